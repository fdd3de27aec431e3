// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/error.h"

const char* gpu::toString(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::Validation:
            return "validation error";
        case ErrorKind::OutOfMemory:
            return "out of memory";
        case ErrorKind::Internal:
            return "internal error";
        case ErrorKind::DeviceLost:
            return "device lost";
        case ErrorKind::NoAdapter:
            return "no usable device";
    }
    return "unknown error";
}
