// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/params.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <initializer_list>
#include <limits>
#include <numbers>
#include <type_traits>

#include "core/base/error.h"
#include "core/material/material_ranges.h"

namespace core {

namespace {

constexpr ParamUnit kPixels{PARAM_LABEL("scene", "px"), 1};
constexpr ParamUnit kMillimetres{PARAM_LABEL("scene", "mm"), 1000};
constexpr ParamUnit kPercent{PARAM_LABEL("scene", "%"), 100};
constexpr ParamUnit kDegrees{PARAM_LABEL("scene", "°"), 180 / std::numbers::pi};
constexpr ParamUnit kSeconds{PARAM_LABEL("scene", "s"), 1};

template <class T>
constexpr bool isOptional = false;
template <class T>
constexpr bool isOptional<std::optional<T>> = true;

template <class T>
ParamValue toValue(const T& member) {
    if constexpr (isOptional<T>)
        return member ? toValue(*member) : ParamValue();
    else if constexpr (std::is_same_v<T, bool>)
        return member;
    else if constexpr (std::is_enum_v<T> || std::is_integral_v<T>)
        return static_cast<std::int64_t>(member);
    else
        return member;
}

template <class T>
void assign(T& member, const ParamValue& value) {
    if constexpr (isOptional<T>) {
        if (std::holds_alternative<std::monostate>(value))
            member.reset();
        else
            assign(member.emplace(), value);
    } else if constexpr (!std::is_same_v<T, bool> && (std::is_enum_v<T> || std::is_integral_v<T>)) {
        member = static_cast<T>(std::get<std::int64_t>(value));
    } else {
        member = std::get<T>(value);
    }
}

template <class T>
struct ParamMember;
template <class C, class T>
struct ParamMember<T C::*> {
    using Class = C;
};
template <auto member>
using ClassOf = typename ParamMember<decltype(member)>::Class;

template <auto first, auto... rest>
auto& follow(auto& owner) {
    if constexpr (sizeof...(rest) == 0)
        return owner.*first;
    else
        return follow<rest...>(owner.*first);
}

/// A value of the member's type: its own initial one, or `custom` of an automatic parameter.
template <class T>
ParamValue typedInitial(const T& member, double custom) {
    if constexpr (!isOptional<T>)
        return toValue(member);
    else if constexpr (std::is_same_v<T, std::optional<Vector3f>>)
        return Vector3f(Vector3f::Constant(static_cast<float>(custom)));
    else
        return static_cast<typename T::value_type>(custom);
}

template <class T>
std::vector<Word<std::int64_t>> numberedWords() {
    std::vector<Word<std::int64_t>> words;
    if constexpr (std::is_enum_v<T>)
        for (const Word<T>& word : Words<T>::table)
            words.push_back({static_cast<std::int64_t>(word.value), word.key, word.label});
    return words;
}

/// The row of the member at the end of a path of members, which starts at the parameter's owner.
template <auto first, auto... rest>
Param<ClassOf<first>> at(ParamRow row) {
    using Owner = ClassOf<first>;
    const Owner fresh{};
    const auto& member = follow<first, rest...>(fresh);
    using Type = std::remove_cvref_t<decltype(member)>;
    row.initial = typedInitial(member, row.custom);
    row.automatic = isOptional<Type>;
    row.words = numberedWords<Type>();
    Param<Owner> param{{std::move(row)}};
    param.get = [](const Owner& owner) { return toValue(follow<first, rest...>(owner)); };
    param.set = [](Owner& owner, const ParamValue& value) { assign(follow<first, rest...>(owner), value); };
    return param;
}

template <class Row>
std::vector<Row> joined(std::initializer_list<std::vector<Row>> tables) {
    std::vector<Row> rows;
    for (const std::vector<Row>& table : tables) rows.insert(rows.end(), table.begin(), table.end());
    return rows;
}

template <class Owner>
const Param<Owner>& findRow(std::span<const Param<Owner>> rows, std::string_view key) {
    const auto found = std::ranges::find(rows, key, [](const ParamRow& row) { return std::string_view(row.key); });
    CORE_ASSERT(found != rows.end(), "a parameter of the table");
    return *found;
}

std::vector<SegmentParam> flagParams() {
    using enum Stage;
    return {
        at<&Segment::visible>({.key = "visible",
                               .label = PARAM_LABEL("scene", "Visible"),
                               .help = PARAM_LABEL("scene", "Show the segment with its new material"),
                               .stage = Display}),
        at<&Segment::locked>({.key = "locked",
                              .label = PARAM_LABEL("scene", "Locked"),
                              .help = PARAM_LABEL("scene", "Protect the segment's pixels from being changed"),
                              .stage = Display}),
        at<&Segment::glossy>({.key = "glossy",
                              .label = PARAM_LABEL("scene", "Glossy"),
                              .help = PARAM_LABEL("scene", "Treat the segment's colours as reflections"),
                              .stage = Reflectance}),
    };
}

std::vector<SegmentParam> backSideParams() {
    using enum Stage;
    return {
        at<&Segment::backSide, &BackSideParams::method>(
            {.key = "back_side.method",
             .label = PARAM_LABEL("scene", "Method"),
             .help = PARAM_LABEL("scene", "How to invent the side that the camera does not see"),
             .stage = BackSide,
             .group = ParamGroup::BackSide}),
        at<&Segment::backSide, &BackSideParams::offset>(
            {.key = "back_side.offset",
             .label = PARAM_LABEL("scene", "Thickness"),
             .help = PARAM_LABEL("scene", "Distance between front and back, for constant thickness"),
             .unit = kMillimetres,
             .legal = {0, 1000},
             .slider = {0.0001, 1},
             .logScale = true,
             .decimals = 1,
             .stage = BackSide,
             .group = ParamGroup::BackSide}),
        at<&Segment::backSide, &BackSideParams::planeShift>(
            {.key = "back_side.plane_shift",
             .label = PARAM_LABEL("scene", "Move mirror"),
             .help = PARAM_LABEL("scene", "Move the fitted mirror away from the camera"),
             .unit = kMillimetres,
             .legal = {-1000, 1000},
             .slider = {-0.2, 0.2},
             .decimals = 1,
             .stage = BackSide,
             .group = ParamGroup::BackSide}),
        at<&Segment::backSide, &BackSideParams::thicknessScale>(
            {.key = "back_side.thickness_scale",
             .label = PARAM_LABEL("scene", "Stretch"),
             .help = PARAM_LABEL("scene", "Scale the invented thickness"),
             .unit = kPercent,
             .legal = {0, 1000},
             .slider = {0.1, 4},
             .logScale = true,
             .stage = BackSide,
             .group = ParamGroup::BackSide}),
        at<&Segment::backSide, &BackSideParams::minThickness>(
            {.key = "back_side.min_thickness",
             .label = PARAM_LABEL("scene", "Minimum"),
             .help = PARAM_LABEL("scene", "Minimum thickness anywhere on the segment"),
             .unit = kMillimetres,
             .legal = {0, 1000},
             .slider = {0.0001, 0.1},
             .logScale = true,
             .decimals = 1,
             .stage = BackSide,
             .group = ParamGroup::BackSide}),
    };
}

std::vector<SegmentParam> estimatedParams() {
    using enum Stage;
    return {
        at<&Segment::reflectance>({.key = "reflectance",
                                   .label = PARAM_LABEL("scene", "Reflectance"),
                                   .help = PARAM_LABEL("scene", "Ratio of reflected to arriving light"),
                                   .legal = {1e-4, 100},
                                   .custom = 1,
                                   .stage = Reflectance,
                                   .group = ParamGroup::Reflectance}),
        at<&Segment::lobeWidth>(
            {.key = "lobe_width",
             .label = PARAM_LABEL("scene", "Lobe width"),
             .help = PARAM_LABEL("scene", "Blur of the segment's reflections in the photograph (GGX alpha)"),
             .legal = {1e-3, 1},
             .slider = {0.005, 0.5},
             .logScale = true,
             .decimals = 3,
             .custom = 0.05,
             .stage = Reflectance,
             .group = ParamGroup::Reflectance}),
        at<&Segment::smoothing>({.key = "smoothing",
                                 .label = PARAM_LABEL("scene", "Smoothing"),
                                 .help = PARAM_LABEL("scene",
                                                     "Remove bumps and dents narrower than this: more for porcelain, "
                                                     "less for fur and carvings. Needs the depth filter."),
                                 .unit = kPixels,
                                 .legal = {0, 200},
                                 .slider = {0, 100},
                                 .decimals = 1,
                                 .custom = 12,
                                 .stage = Geometry,
                                 .group = ParamGroup::Front}),
    };
}

std::vector<SceneParam> depthFilterParams() {
    using enum Stage;
    return {
        at<&Scene::depthFilter, &DepthFilterParams::enabled>(
            {.key = "depth_filter.enabled",
             .label = PARAM_LABEL("scene", "Filter the depth map"),
             .help = PARAM_LABEL("scene", "Smooth surfaces and keep outlines sharp (edge-avoiding filter)"),
             .stage = Geometry,
             .group = ParamGroup::Depth}),
        at<&Scene::depthFilter, &DepthFilterParams::automatic>(
            {.key = "depth_filter.automatic",
             .label = PARAM_LABEL("scene", "Automatic"),
             .help = PARAM_LABEL("scene", "Adapt the filter to the measured noise of the depth map"),
             .stage = Geometry,
             .group = ParamGroup::Depth}),
        at<&Scene::depthFilter, &DepthFilterParams::spatialSigma>(
            {.key = "depth_filter.spatial_sigma",
             .label = PARAM_LABEL("scene", "Radius"),
             .help = PARAM_LABEL("scene", "Size of the depth filter"),
             .unit = kPixels,
             .legal = {0.1, 100},
             .slider = {0.3, 20},
             .logScale = true,
             .decimals = 2,
             .stage = Geometry,
             .group = ParamGroup::Depth}),
        at<&Scene::depthFilter, &DepthFilterParams::colorSigma>(
            {.key = "depth_filter.color_sigma",
             .label = PARAM_LABEL("scene", "Colour range"),
             .help = PARAM_LABEL("scene", "Separate colours that differ by more than this"),
             .legal = {1e-4, 100},
             .slider = {0.005, 1},
             .logScale = true,
             .decimals = 3,
             .stage = Geometry,
             .group = ParamGroup::Depth}),
        at<&Scene::depthFilter, &DepthFilterParams::depthSigma>(
            {.key = "depth_filter.depth_sigma",
             .label = PARAM_LABEL("scene", "Depth range"),
             .help = PARAM_LABEL("scene", "Separate depths that differ by more than this fraction"),
             .legal = {1e-6, 100},
             .slider = {0.0005, 0.2},
             .logScale = true,
             .decimals = 4,
             .stage = Geometry,
             .group = ParamGroup::Depth}),
    };
}

std::vector<SceneParam> environmentParams() {
    using enum Stage;
    return {
        at<&Scene::environment, &EnvironmentParams::rotation>(
            {.key = "environment.rotation",
             .label = PARAM_LABEL("scene", "Rotation"),
             .help = PARAM_LABEL("scene", "Turn the light about the vertical axis of the camera"),
             .unit = kDegrees,
             .legal = {-1000, 1000},
             .slider = {-std::numbers::pi, std::numbers::pi},
             .decimals = 1,
             .stage = Environment,
             .group = ParamGroup::Light}),
        at<&Scene::environment, &EnvironmentParams::scale>(
            {.key = "environment.scale",
             .label = PARAM_LABEL("scene", "Strength"),
             .help = PARAM_LABEL("scene", "Scale the radiance of the light"),
             .legal = {0, 1e6},
             .slider = {0.01, 100},
             .logScale = true,
             .decimals = 2,
             .stage = Environment,
             .group = ParamGroup::Light}),
        at<&Scene::environment, &EnvironmentParams::height>({.key = "environment.height",
                                                             .label = PARAM_LABEL("scene", "Rows"),
                                                             .legal = {kMinMapRows, kMaxMapRows},
                                                             .stage = Reflectance}),
        at<&Scene::environment, &EnvironmentParams::use>(
            {.key = "environment.use",
             .label = PARAM_LABEL("scene", "Loaded map"),
             .help = PARAM_LABEL("scene", "Use the map as all of the light, or only where the photograph shows none"),
             .stage = Environment,
             .group = ParamGroup::Light}),
        at<&Scene::environment, &EnvironmentParams::fill>(
            {.key = "environment.fill",
             .label = PARAM_LABEL("scene", "Gaps"),
             .help = PARAM_LABEL("scene", "How to fill directions that nothing in the photograph shows"),
             .stage = Reflectance,
             .group = ParamGroup::Light}),
    };
}

std::vector<SceneParam> renderParams() {
    using enum Stage;
    return {
        at<&Scene::render, &RenderParams::samples>(
            {.key = "render.samples",
             .label = PARAM_LABEL("scene", "Samples"),
             .help = PARAM_LABEL("scene", "Light paths per pixel of a finished picture"),
             .legal = {1, 1e6},
             .stage = Reshade,
             .group = ParamGroup::Picture}),
        at<&Scene::render, &RenderParams::timeLimit>(
            {.key = "render.time_limit",
             .label = PARAM_LABEL("scene", "Time limit"),
             .help = PARAM_LABEL("scene",
                                 "Stop refining the view after this many seconds. Exports always use all samples."),
             .unit = kSeconds,
             .legal = {0, 86400},
             .zero = PARAM_LABEL("scene", "None"),
             .stage = Reshade,
             .group = ParamGroup::Picture}),
        at<&Scene::render, &RenderParams::seed>({.key = "render.seed",
                                                 .label = PARAM_LABEL("scene", "Seed"),
                                                 .help = PARAM_LABEL("scene", "The same seed gives the same picture"),
                                                 .legal = {0, std::numeric_limits<std::uint32_t>::max()},
                                                 .stage = Irradiance,
                                                 .group = ParamGroup::Picture}),
        at<&Scene::render, &RenderParams::bounces>(
            {.key = "render.bounces",
             .label = PARAM_LABEL("scene", "Bounces"),
             .help = PARAM_LABEL(
                 "scene", "Surfaces a light path may visit. With 1, folds reflect the object's original colour."),
             .legal = {1, 64},
             .stage = Irradiance,
             .group = ParamGroup::Picture}),
        at<&Scene::render, &RenderParams::filter>(
            {.key = "render.filter",
             .label = PARAM_LABEL("scene", "Smooth noise, keep edges"),
             .help = PARAM_LABEL("scene", "Filter the new picture inside each segment, edge-aware"),
             .stage = Composite,
             .group = ParamGroup::Picture}),
        at<&Scene::render, &RenderParams::surfaceSamples>(
            {.key = "render.surface_samples",
             .label = PARAM_LABEL("scene", "Surface samples"),
             .help = PARAM_LABEL("scene", "Points on front and back of a translucent segment"),
             .legal = {1, 1e7},
             .stage = Irradiance,
             .group = ParamGroup::Translucency}),
        at<&Scene::render, &RenderParams::irradianceSamples>(
            {.key = "render.irradiance_samples",
             .label = PARAM_LABEL("scene", "Irradiance rays"),
             .help = PARAM_LABEL("scene", "Light paths per surface sample"),
             .legal = {1, 1e6},
             .stage = Irradiance,
             .group = ParamGroup::Translucency}),
        at<&Scene::render, &RenderParams::diffusionQuality>(
            {.key = "render.translucency_quality",
             .label = PARAM_LABEL("scene", "Quality"),
             .help = PARAM_LABEL("scene", "Accuracy of summing the light of all surface samples"),
             .stage = Irradiance,
             .group = ParamGroup::Translucency}),
    };
}

}  // namespace

std::span<const SegmentParam> segmentParams() {
    static const auto kRows = joined<SegmentParam>({flagParams(), backSideParams(), estimatedParams()});
    return kRows;
}

std::span<const SceneParam> sceneParams() {
    static const auto kRows = joined<SceneParam>({depthFilterParams(), environmentParams(), renderParams()});
    return kRows;
}

std::span<const MaterialParam> blendParams() {
    static const std::vector<MaterialParam> kRows = {
        at<&Material::blendNew>({.key = "blend.new",
                                 .label = PARAM_LABEL("scene", "New"),
                                 .help = PARAM_LABEL("scene", "Weight of the new surface"),
                                 .legal = {0, kMaxWeight},
                                 .slider = {0, 2},
                                 .decimals = 2,
                                 .stage = Stage::Composite}),
        at<&Material::blendOriginal>({.key = "blend.original",
                                      .label = PARAM_LABEL("scene", "Photograph"),
                                      .help = PARAM_LABEL("scene", "Weight of the photograph underneath"),
                                      .legal = {0, kMaxWeight},
                                      .slider = {0, 2},
                                      .decimals = 2,
                                      .stage = Stage::Composite}),
    };
    return kRows;
}

std::span<const TranslucencyParam> translucencyParams() {
    static const std::vector<TranslucencyParam> kRows = {
        at<&Translucency::model>(
            {.key = "translucency.model",
             .label = PARAM_LABEL("scene", "Model"),
             .help = PARAM_LABEL("scene", "Better dipole: more accurate for strongly absorbing materials"),
             .stage = Stage::Irradiance}),
        at<&Translucency::eta>({.key = "translucency.eta",
                                .label = PARAM_LABEL("scene", "Index"),
                                .help = PARAM_LABEL("scene", "Relative index of refraction; 1 = no boundary"),
                                .legal = {1, 3},
                                .slider = {1, 2.5},
                                .decimals = 2,
                                .stage = Stage::Irradiance}),
        at<&Translucency::scale>(
            {.key = "translucency.scale",
             .label = PARAM_LABEL("scene", "Size"),
             .help = PARAM_LABEL("scene", "Scale the object by this factor; larger objects look less translucent"),
             .legal = {1e-4, 1e4},
             .slider = {0.01, 100},
             .logScale = true,
             .decimals = 2,
             .stage = Stage::Irradiance}),
        at<&Translucency::weight>({.key = "translucency.weight",
                                   .label = PARAM_LABEL("scene", "Weight"),
                                   .help = PARAM_LABEL("scene", "Scale the light that was scattered inside"),
                                   .legal = {0, kMaxWeight},
                                   .slider = {0, 4},
                                   .decimals = 2,
                                   .stage = Stage::Composite}),
    };
    return kRows;
}

const SegmentParam& segmentParam(std::string_view key) { return findRow(segmentParams(), key); }
const SceneParam& sceneParam(std::string_view key) { return findRow(sceneParams(), key); }

std::string_view paramObject(const ParamRow& row) {
    const std::string_view key = row.key;
    const std::size_t dot = key.find('.');
    return dot == std::string_view::npos ? std::string_view() : key.substr(0, dot);
}

const char* paramName(const ParamRow& row) {
    const char* dot = std::strchr(row.key, '.');
    return dot == nullptr ? row.key : dot + 1;
}

double toNumber(const ParamValue& value) {
    if (const auto* on = std::get_if<bool>(&value)) return *on ? 1 : 0;
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
    if (const auto* single = std::get_if<float>(&value)) return static_cast<double>(*single);
    return std::get<double>(value);
}

ParamValue fromNumber(const ParamRow& row, double number) {
    if (std::holds_alternative<bool>(row.initial)) return number != 0;
    if (std::holds_alternative<std::int64_t>(row.initial)) return static_cast<std::int64_t>(std::llround(number));
    if (std::holds_alternative<float>(row.initial)) return static_cast<float>(number);
    return number;
}

}  // namespace core
