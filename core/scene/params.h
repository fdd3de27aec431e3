// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/scene/changes.h"
#include "core/scene/scene.h"

// The table of everything a user can set in a scene, apart from the parameters of BRDFs. One row per parameter drives
// project files, the command line's ranges, the panels, `firstChangedStage`, the cache keys of the analysis and their
// tests. A new parameter is its member in scene.h and a row in params.cpp.

namespace core {

/// Value of a parameter. monostate = automatic: the analysis chooses. A choice is the number of its enumerator.
using ParamValue = std::variant<std::monostate, bool, std::int64_t, float, double, Vector3f>;

/// Group of controls in which the window shows a parameter; None = not shown by a control of its own.
enum class ParamGroup { None, Front, BackSide, Light, Reflectance, Picture, Translucency, Depth };

struct ParamRange {
    double min = 0;
    double max = 0;
};

/// A unit in the window: shown value = stored value · factor. `label` is untranslated (context "scene").
struct ParamUnit {
    const char* label = "";
    double factor = 1;
};

/// What a table says about a parameter, whoever owns it.
struct ParamRow {
    const char* key;               ///< in project files: "name" or "object.name"
    const char* label;             ///< for people, untranslated (context "scene")
    const char* help = "";         ///< tool tip, untranslated (context "scene")
    ParamUnit unit = {};           ///< in the window; files are in SI units, radians and pixels
    ParamRange legal = {};         ///< of numbers: what files, the command line and number boxes accept
    ParamRange slider = {};        ///< of numbers: what a slider reaches; empty = a number box without slider
    bool logScale = false;         ///< slider positions are spaced by factors; needs slider.min > 0
    int decimals = 0;              ///< in the window
    const char* zero = "";         ///< shown in place of 0, untranslated (context "scene")
    double custom = 0;             ///< automatic parameters: first value of their own
    Stage stage = Stage::Display;  ///< first stage that a change touches
    ParamGroup group = ParamGroup::None;

    // Taken from the member.
    ParamValue initial = {};                     ///< of the member's type; of an automatic one, `custom`
    bool automatic = false;                      ///< may be left to the analysis (std::optional)
    std::vector<Word<std::int64_t>> words = {};  ///< choices only, in the order of display
};

template <class Owner>
struct Param : ParamRow {
    ParamValue (*get)(const Owner&) = nullptr;
    void (*set)(Owner&, const ParamValue&) = nullptr;  ///< the value's type has to be that of `initial`, or monostate
};
using SegmentParam = Param<Segment>;
using SceneParam = Param<Scene>;
using MaterialParam = Param<Material>;
using TranslucencyParam = Param<Translucency>;

/// All rows, in the order of project files.
[[nodiscard]] std::span<const SegmentParam> segmentParams();
[[nodiscard]] std::span<const SceneParam> sceneParams();

/// Weights of a material; the parameters of its BRDF are in the BRDF's own table (core/material/brdf.h).
[[nodiscard]] std::span<const MaterialParam> blendParams();
/// Translucency of a material, except its coefficients. Here "translucency" is the object itself.
[[nodiscard]] std::span<const TranslucencyParam> translucencyParams();

/// The row of a key, which has to exist.
[[nodiscard]] const SegmentParam& segmentParam(std::string_view key);
[[nodiscard]] const SceneParam& sceneParam(std::string_view key);

/// "back_side" of "back_side.offset", "" of "smoothing": the object of a project file that holds the parameter.
[[nodiscard]] std::string_view paramObject(const ParamRow& row);
/// "offset" of "back_side.offset": its key in that object.
[[nodiscard]] const char* paramName(const ParamRow& row);

/// Number in a value, enumerator of a choice, 0 or 1 of a switch; not for colours and monostate.
[[nodiscard]] double toNumber(const ParamValue& value);
/// A number as a value of the row's type, rounded where that is whole.
[[nodiscard]] ParamValue fromNumber(const ParamRow& row, double number);

}  // namespace core
