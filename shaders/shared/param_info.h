// SPDX-License-Identifier: GPL-3.0-or-later
// Description of one BRDF parameter, C++ only: the material panel, the project file, the command line and the tests are
// driven by tables of these, which stand beside each BRDF's text.
#ifndef PATINA_PARAM_INFO_H
#define PATINA_PARAM_INFO_H

#ifdef __cplusplus

#include <span>

/// Marks a label for translation (lupdate -tr-function-alias QT_TRANSLATE_NOOP+=PARAM_LABEL) and yields its text.
#define PARAM_LABEL(context, text) text

namespace core {

/// One scalar parameter of a BRDF: `key` in files and on the command line, `label` for people, `unit` "" when it has
/// none, range and initial value, and whether a slider should run logarithmically.
struct ParamInfo {
    const char* key;
    const char* label;
    const char* unit;
    float min;
    float max;
    float initial;
    bool logScale;
};

/// What a BRDF says about itself, beside its text: the name people read, its parameters in the order of
/// BrdfParams.values, which colours it uses, and its Fresnel mode when none is asked for (shaders/brdf/fresnel.h).
struct BrdfTable {
    const char* label;
    std::span<const ParamInfo> params;
    bool usesAlbedo;
    bool usesSpecular;
    int defaultFresnel;
};

}  // namespace core

#endif

#endif
