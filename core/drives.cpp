// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drives.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/brdf.h"
#include "core/material_ranges.h"
#include "core/reference_renderer.h"
#include "core/steps/segment_pixels.h"

namespace core {

namespace {

/// How far clipped detail may be made up for: beyond that, more of the texture would be lost than the mean is worth.
constexpr float kMaxCorrection = 1.25f;

using steps::PixelBox;

PixelBox boxOf(const LabelImage& labels, std::uint16_t label) {
    PixelBox box;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) == label) box.add({x, y});
    return box;
}

kernel::vec4 packed(const Vector3f& v, float w) { return {v.x(), v.y(), v.z(), w}; }

/// How a drive's stored values become t.
struct Response {
    float gain = 1, stored = 0, t = 0, least = 0, greatest = 1;
};

/// Factor on clamp(1 + gain (d − 1), 0, limit) by which its mean over the detail d of the segment's pixels is 1 again.
float meanCorrection(const LabelImage& labels, std::uint16_t label, const PixelBox& box, const ImageF& detail,
                     float gain, float limit) {
    // Sums over bins of 1 + gain (d − 1); only the bin in which values are clipped is not exact.
    constexpr std::size_t kBins = 2048;
    constexpr float kRange = 16;
    std::array<double, kBins> sums{};
    std::array<double, kBins> counts{};
    double count = 0;
    double negative = 0;
    for (int y = box.y0; y <= box.y1; ++y)
        for (int x = box.x0; x <= box.x1; ++x) {
            if (labels(x, y) != label) continue;
            const float v = 1 + gain * (detail(x, y) - 1);
            count += 1;
            if (v <= 0) {
                negative += 1;
                continue;
            }
            const auto bin = std::min(static_cast<std::size_t>(v * (kBins / kRange)), kBins - 1);
            sums[bin] += static_cast<double>(v);
            counts[bin] += 1;
        }
    const auto mean = [&](double factor) {
        double sum = 0;
        for (std::size_t i = 0; i < kBins; ++i)
            if (counts[i] > 0) sum += std::min(factor * sums[i], static_cast<double>(limit) * counts[i]);
        return sum / count;
    };
    const bool clipped = negative > 0 || mean(1) < 1 - 1e-5;
    if (count == 0 || !clipped) return 1;
    double low = 1 / static_cast<double>(kMaxCorrection);
    double high = static_cast<double>(kMaxCorrection);
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (mean(middle) < 1 ? low : high) = middle;
    }
    return static_cast<float>(0.5 * (low + high));
}

/// The drives of one scene in the making.
class DriveBuilder {
  public:
    DriveBuilder(const Scene& scene, const Analysis& analysis) : labels_(scene.photo->labels), analysis_(analysis) {}

    void add(const Segment& segment, kernel::SegmentShading& shading) {
        const Material& material = *segment.edit;
        std::vector<std::pair<kernel::Drive, std::uint32_t>> paths;
        std::vector<std::pair<kernel::Drive, std::uint32_t>> composite;
        const Vector3f estimated = specularOf(segment, analysis_);
        const std::vector<DriveParameter> parameters = driveParameters(material);
        box_ = {};
        for (const Drive& drive : material.drives) {
            const auto parameter = std::ranges::find(parameters, drive.parameter, &DriveParameter::key);
            if (parameter == parameters.end()) continue;
            if (drive.source == DriveSource::Mask ? drive.mask == nullptr : analysis_.textureDetail == nullptr)
                continue;
            if (box_.x1 < 0) box_ = boxOf(labels_, segment.label);
            if (box_.x1 < 0) return;
            const std::uint32_t plane = planeFor(drive);
            const kernel::Drive entry =
                entryFor(drive, *parameter, ownValue(material, *parameter, estimated), segment.label, plane);
            const bool weight = parameter->slot == kernel::kDriveTranslucentWeight;
            if (!weight) paths.emplace_back(entry, plane);
            if (weight) paths.emplace_back(bodyEntry(entry, *material.translucency), plane);
            if (weight || parameter->slot == kernel::kDriveBlendNew || parameter->slot == kernel::kDriveBlendOriginal)
                composite.emplace_back(entry, plane);
        }
        const auto append = [&](const auto& list, kernel::uint& first, kernel::uint& count) {
            first = static_cast<kernel::uint>(table_.drives.size());
            count = static_cast<kernel::uint>(list.size());
            for (const auto& [entry, plane] : list) {
                table_.drives.push_back(entry);
                table_.planeOf.push_back(plane);
            }
        };
        append(paths, shading.drives.x, shading.drives.y);
        append(composite, shading.drives.z, shading.drives.w);
        firstPlane_ = table_.planes.size();
    }

    DriveTable take() { return std::move(table_); }

  private:
    std::uint32_t planeFor(const Drive& drive) {
        DrivePlane plane{.mask = drive.source == DriveSource::Mask ? drive.mask : nullptr,
                         .detail = drive.source == DriveSource::Mask ? nullptr : analysis_.textureDetail,
                         .x = box_.x0,
                         .y = box_.y0,
                         .width = box_.width(),
                         .height = box_.height(),
                         .offset = table_.valueCount};
        for (std::size_t i = firstPlane_; i < table_.planes.size(); ++i)
            if (table_.planes[i].mask == plane.mask && table_.planes[i].detail == plane.detail)
                return static_cast<std::uint32_t>(i);
        table_.valueCount += static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.height);
        table_.planes.push_back(std::move(plane));
        return static_cast<std::uint32_t>(table_.planes.size() - 1);
    }

    kernel::Drive entryFor(const Drive& drive, const DriveParameter& parameter, const Vector3f& own,
                           std::uint16_t label, std::uint32_t plane) const {
        const auto end = [&](const std::optional<DriveEnd>& e) -> Vector3f {
            if (!e) return own;
            const Vector3f value = e->factor ? Vector3f(e->value.cwiseProduct(own)) : e->value;
            return value.cwiseMax(parameter.min).cwiseMin(parameter.max);
        };
        Vector3f from = end(drive.from);
        Vector3f to = end(drive.to);
        Response r;
        if (drive.source == DriveSource::Mask) {
            r = {.gain = drive.strength, .stored = 0.5f, .t = 0.5f};
        } else if (drive.from || drive.to) {
            r = {.gain = drive.strength, .stored = 1, .t = 0.5f};
        } else {
            const float largest = own.maxCoeff();
            const float limit = largest > 0 ? std::max(parameter.max / largest, 1.0f) : 1.0f;
            const float gain = drive.invert ? -drive.strength : drive.strength;
            const float factor = meanCorrection(labels_, label, box_, *analysis_.textureDetail, gain, limit);
            from.setZero();
            to = own * factor;
            r = {.gain = drive.strength, .stored = 1, .t = 1, .least = 0, .greatest = limit / factor};
        }
        if (drive.invert) r.gain = -r.gain;
        const DrivePlane& p = table_.planes[plane];
        kernel::Drive entry;
        entry.from = packed(from, r.gain);
        entry.to = packed(to, r.stored);
        entry.range = {r.t, r.least, r.greatest, 0};
        entry.slot = parameter.slot;
        entry.offset = static_cast<kernel::uint>(p.offset);
        entry.origin = static_cast<kernel::uint>(p.x) | static_cast<kernel::uint>(p.y) << 16;
        entry.stride = static_cast<kernel::uint>(p.width);
        return entry;
    }

    /// The weight of the translucent light as a factor on the body that other surfaces see.
    static kernel::Drive bodyEntry(kernel::Drive entry, const Translucency& translucency) {
        const Vector3f albedo = translucentAlbedo(translucency);
        const kernel::vec3 body(albedo.x(), albedo.y(), albedo.z());
        entry.from = {body * entry.from.x, entry.from.w};
        entry.to = {body * entry.to.x, entry.to.w};
        entry.slot = kernel::kDriveDiffuse;
        return entry;
    }

    const LabelImage& labels_;
    const Analysis& analysis_;
    DriveTable table_;
    PixelBox box_;                ///< of the segment in work
    std::size_t firstPlane_ = 0;  ///< of the segment in work
};

}  // namespace

std::vector<DriveParameter> driveParameters(const Material& material) {
    std::vector<DriveParameter> result;
    const BrdfInfo* brdf = findBrdf(material);
    if (brdf == nullptr) return result;
    for (std::size_t i = 0; i < brdf->params.size(); ++i) {
        const ParamInfo& param = brdf->params[i];
        result.push_back({param.key, param.label, false, param.min, param.max, static_cast<kernel::uint>(i)});
    }
    if (brdf->usesAlbedo) result.push_back({"albedo", "Diffuse colour", true, 0, 1, kernel::kDriveAlbedo});
    if (brdf->usesSpecular) {
        result.push_back({"specular", "Specular colour", true, 0, kMaxSpecular, kernel::kDriveSpecular});
        result.push_back({"eta", "Index n", true, kMinIndex, kMaxIndex, kernel::kDriveEta});
        result.push_back({"k", "Extinction k", true, 0, kMaxIndex, kernel::kDriveK});
    }
    result.push_back({"blend.new", "New", false, 0, kMaxWeight, kernel::kDriveBlendNew});
    result.push_back({"blend.original", "Photograph", false, 0, kMaxWeight, kernel::kDriveBlendOriginal});
    if (material.translucency)
        result.push_back(
            {"translucency.weight", "Translucency", false, 0, kMaxWeight, kernel::kDriveTranslucentWeight});
    return result;
}

std::vector<Drive> knownDrives(const std::vector<Drive>& drives, const Material& material) {
    const std::vector<DriveParameter> known = driveParameters(material);
    std::vector<Drive> result;
    for (const Drive& drive : drives)
        if (std::ranges::find(known, drive.parameter, &DriveParameter::key) != known.end()) result.push_back(drive);
    return result;
}

Vector3f ownValue(const Material& material, const DriveParameter& parameter, const Vector3f& estimatedSpecular) {
    switch (parameter.slot) {
        case kernel::kDriveAlbedo:
            return material.albedo;
        case kernel::kDriveSpecular:
            return material.specular.value_or(estimatedSpecular);
        case kernel::kDriveEta:
            return material.eta;
        case kernel::kDriveK:
            return material.k;
        case kernel::kDriveBlendNew:
            return Vector3f::Constant(material.blendNew);
        case kernel::kDriveBlendOriginal:
            return Vector3f::Constant(material.blendOriginal);
        case kernel::kDriveTranslucentWeight:
            return Vector3f::Constant(material.translucency ? material.translucency->weight : 0.0f);
        default:
            return Vector3f::Constant(material.values.at(parameter.slot));
    }
}

bool drivenByLuminance(const Material& material) {
    return std::ranges::any_of(material.drives, [](const Drive& d) { return d.source == DriveSource::Luminance; });
}

void DrivePlane::copyRows(int first, int rows, std::span<float> target) const {
    CORE_ASSERT(first >= 0 && rows >= 0 && first + rows <= height &&
                    target.size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(width),
                "rows of the plane");
    std::size_t i = 0;
    for (int row = y + first; row < y + first + rows; ++row)
        for (int column = x; column < x + width; ++column)
            target[i++] = mask ? mask->value(column, row) : (*detail)(column, row);
}

std::vector<float> DriveTable::values() const {
    std::vector<float> result(valueCount);
    for (const DrivePlane& plane : planes)
        plane.copyRows(0, plane.height,
                       std::span(result).subspan(plane.offset, static_cast<std::size_t>(plane.width) *
                                                                   static_cast<std::size_t>(plane.height)));
    return result;
}

DriveTable buildDrives(const Scene& scene, const Analysis& analysis, std::span<kernel::SegmentShading> shading) {
    DriveBuilder builder(scene, analysis);
    for (const Segment& segment : scene.segments) {
        if (!segment.edit || !usable(*segment.edit) || segment.edit->drives.empty() || segment.label >= shading.size())
            continue;
        if (shading[segment.label].diffuse.w != 0) builder.add(segment, shading[segment.label]);
    }
    return builder.take();
}

ImageRgb effectiveParameter(const Scene& scene, const Analysis& analysis, const Segment& segment,
                            std::string_view parameter) {
    const auto fail = [&](const std::string& reason) {
        throw Error(ErrorKind::Usage, "The segment \"" + segment.name + "\" " + reason);
    };
    if (!segment.edit) fail("is not edited, so it has no parameters.");
    const std::vector<DriveParameter> parameters = driveParameters(*segment.edit);
    const auto found = std::ranges::find(parameters, parameter, &DriveParameter::key);
    if (found == parameters.end()) {
        std::string known;
        for (const DriveParameter& p : parameters) known += (known.empty() ? "" : ", ") + p.key;
        fail("has no parameter \"" + std::string(parameter) + "\", expected one of " + known + ".");
    }
    std::vector<kernel::SegmentShading> shading = buildSegmentShading(scene, analysis);
    const DriveTable table = buildDrives(scene, analysis, shading);
    const std::vector<float> values = table.values();
    const kernel::uvec4 range = shading[segment.label].drives;
    const kernel::Drive* drive = nullptr;
    for (kernel::uint i = 0; i < range.y + range.w; ++i) {
        const kernel::Drive& d = table.drives[i < range.y ? range.x + i : range.z + i - range.y];
        if (d.slot == found->slot) drive = &d;
    }
    const Vector3f own = ownValue(*segment.edit, *found, specularOf(segment, analysis));
    const LabelImage& labels = scene.photo->labels;
    ImageRgb result(labels.width(), labels.height());
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x) {
            if (labels(x, y) != segment.label) continue;
            result(x, y) = own;
            if (drive == nullptr) continue;
            const kernel::uint at =
                kernel::drive_index(*drive, static_cast<kernel::uint>(x), static_cast<kernel::uint>(y));
            const kernel::vec3 v = kernel::drive_value(*drive, values[at]);
            result(x, y) = found->color ? Vector3f(v.x, v.y, v.z) : Vector3f::Constant(v.x);
        }
    return result;
}

void requireMasksFit(const Scene& scene, ErrorKind kind) {
    const auto size = [](int w, int h) { return std::to_string(w) + "x" + std::to_string(h); };
    for (const Segment& segment : scene.segments) {
        if (!segment.edit) continue;
        for (const Drive& drive : segment.edit->drives) {
            if (drive.mask == nullptr) continue;
            const LabelImage& labels = scene.photo->labels;
            if (drive.mask->width() == labels.width() && drive.mask->height() == labels.height()) continue;
            throw Error(kind, "The mask \"" + drive.mask->path() + "\" of \"" + drive.parameter + "\" in segment \"" +
                                  segment.name + "\" is " + size(drive.mask->width(), drive.mask->height()) +
                                  ", expected the photograph's size " + size(labels.width(), labels.height()) + ".");
        }
    }
}

std::vector<std::string> maskNotes(const Scene& scene) {
    std::vector<std::string> notes;
    for (const Segment& segment : scene.segments) {
        if (!segment.edit) continue;
        for (const Drive& drive : segment.edit->drives) {
            if (drive.mask == nullptr || drive.mask->path().empty()) continue;
            const LabelImage& labels = scene.photo->labels;
            float least = 2;
            float greatest = -1;
            for (int y = 0; y < labels.height(); ++y)
                for (int x = 0; x < labels.width(); ++x) {
                    if (labels(x, y) != segment.label) continue;
                    least = std::min(least, drive.mask->value(x, y));
                    greatest = std::max(greatest, drive.mask->value(x, y));
                }
            if (least != greatest) continue;
            notes.push_back("The mask \"" + drive.mask->path() + "\" is " + std::to_string(least).substr(0, 5) +
                            " everywhere in the segment \"" + segment.name + "\", so \"" + drive.parameter +
                            "\" does not vary there. Is it the mask of another segment?");
        }
    }
    return notes;
}

}  // namespace core
