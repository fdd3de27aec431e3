// SPDX-License-Identifier: GPL-3.0-or-later
// The list of BRDFs. The number is the id in files and kernels: never reuse one. The name is the key in files, the
// prefix of the functions in shaders/brdf/<name>.h and the word on the command line.
#ifndef PATINA_BRDF_REGISTRY_H
#define PATINA_BRDF_REGISTRY_H

#include "shaders/brdf/artist.h"
#include "shaders/brdf/blinn_phong.h"
#include "shaders/brdf/coated.h"
#include "shaders/brdf/ggx.h"
#include "shaders/brdf/lambert.h"
#include "shaders/brdf/measured.h"
#include "shaders/brdf/none.h"
#include "shaders/brdf/oren_nayar.h"
#include "shaders/brdf/phong.h"
#include "shaders/brdf/ward.h"

#define BRDF_LIST(X) \
    X(0, none)       \
    X(1, lambert) X(2, phong) X(3, ggx) X(4, oren_nayar) X(5, blinn_phong) X(6, ward) X(7, coated) X(8, artist)

// BRDFs that a file defines (core/material/brdf_file.h) have an id, but no entry of their own in the list.
#define BRDF_MEASURED 9
// Those that the user wrote: this id and the following ones, one for each file in use (shaders/brdf/user.h).
#define BRDF_USER 10
#define BRDF_USER_COUNT 8

#define BRDF_DISPATCH_LIST(X) BRDF_LIST(X) X(BRDF_MEASURED, measured)

#endif
