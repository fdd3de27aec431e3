// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shading/drive_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/pixel.h"
#include "core/material/brdf.h"
#include "core/shading/segment_shading.h"

namespace core {

namespace {

/// Maximum correction of the mean for clipped detail; a larger one would cost more texture than the mean is worth.
constexpr float kMaxCorrection = 1.25f;

PixelBox boxOf(const LabelImage& labels, std::uint16_t label) {
    PixelBox box;
    for (int y = 0; y < labels.height(); ++y)
        for (int x = 0; x < labels.width(); ++x)
            if (labels(x, y) == label) box.add({x, y});
    return box;
}

kernel::vec4 packed(const Vector3f& v, float w) { return {v.x(), v.y(), v.z(), w}; }

/// Mapping of a drive's stored values to t.
struct Response {
    float gain = 1, stored = 0, t = 0, least = 0, greatest = 1;
};

/// Factor on clamp(1 + gain (d − 1), 0, limit) that restores a mean of 1 over the detail d of the segment's pixels.
float meanCorrection(const LabelImage& labels, std::uint16_t label, const PixelBox& box, const ImageF& detail,
                     float gain, float limit) {
    // Sums over bins of 1 + gain (d − 1), exact except for the bin in which values are clipped.
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

/// Builds the drives of one scene.
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

    /// The weight of the translucent light as a factor on the albedo that other surfaces see.
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
    PixelBox box_;                ///< of the current segment
    std::size_t firstPlane_ = 0;  ///< of the current segment
};

}  // namespace

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

}  // namespace core
