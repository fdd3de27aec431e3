// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/photo_report.h"

#include "core/analysis/pipeline.h"
#include "core/base/clock.h"
#include "core/io/image_io.h"
#include "core/io/material_json.h"
#include "core/io/project.h"
#include "render/renderer.h"
#include "tests/evaluate/device.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/metrics.h"
#include "tests/evaluate/outline.h"
#include "tests/evaluate/pictures.h"

namespace evaluate {

namespace fs = std::filesystem;
using core::ImageRgb;
using core::Vector3f;

namespace {

constexpr int kLargePicture = 1600;  // longer side of the pictures saved beside the sheet [px]

core::Vector2f vector2(const Json& json) { return {json.at(0).get<float>(), json.at(1).get<float>()}; }

/// An entry's intrinsics from the folder's sample.json, in pixels of the colour image.
std::optional<core::Camera> sampleIntrinsics(const fs::path& folder, std::size_t index) {
    const Json intrinsics = readJson(folder / "sample.json").at("entries").at(index).at("intrinsics");
    if (!intrinsics.is_object() || intrinsics.value("normalised", false)) return std::nullopt;
    core::Camera camera;
    camera.fx = intrinsics.at("fx"), camera.fy = intrinsics.at("fy");
    camera.cx = intrinsics.at("cx"), camera.cy = intrinsics.at("cy");
    return camera;
}

/// Outlines of a segment in pixels of the photograph.
std::vector<Outline> outlinesOf(const Json& segment, float scale) {
    std::vector<Outline> outlines;
    const auto points = [&](const Json& list) {
        Outline outline;
        for (const Json& point : list) outline.push_back(scale * vector2(point));
        return outline;
    };
    for (const Json& polygon : segment.value("polygons", Json::array())) outlines.push_back(points(polygon));
    for (const Json& curve : segment.value("curves", Json::array())) outlines.push_back(curveOutline(points(curve)));
    for (const Json& ellipse : segment.value("ellipses", Json::array()))
        outlines.push_back(ellipseOutline(scale * vector2(ellipse.at("center")), scale * vector2(ellipse.at("radii"))));
    return outlines;
}

/// Depth from stereo disparities that were stored less a constant `offset` [px].
core::ImageF offsetDisparity(core::ImageF stored, float offset, float focalBaseline) {
    for (float& value : stored.pixels()) value = value > 0 ? focalBaseline / (value + offset) : 0.0f;
    return stored;
}

/// The photograph reduced by `factor`: mean colour of each block, depth of its middle pixel.
std::shared_ptr<core::Photo> reduced(const core::Photo& photo, int factor) {
    auto small = std::make_shared<core::Photo>();
    const auto scale = 1 / static_cast<float>(factor);
    core::Camera& camera = small->camera = photo.camera;
    camera.width /= factor, camera.height /= factor;
    camera.fx *= scale, camera.fy *= scale, camera.cx *= scale, camera.cy *= scale;
    small->source = photo.source;
    small->clipLevel = photo.clipLevel;
    small->depthSampleSpacing = std::max(photo.depthSampleSpacing * scale, 1.0f);
    small->color = ImageRgb(camera.width, camera.height);
    small->depth = core::ImageF(camera.width, camera.height);
    small->labels = core::LabelImage(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y) {
        for (int x = 0; x < camera.width; ++x) {
            for (int j = 0; j < factor; ++j)
                for (int i = 0; i < factor; ++i)
                    small->color(x, y) += scale * scale * photo.color(x * factor + i, y * factor + j);
            small->depth(x, y) = photo.depth(x * factor + factor / 2, y * factor + factor / 2);
        }
    }
    return small;
}

/// The picture with the borders of the segments drawn on it.
ImageRgb withOutlines(ImageRgb picture, const core::LabelImage& labels) {
    const int thickness = std::max(1, picture.width() / 400);
    for (int y = 0; y < labels.height(); ++y) {
        for (int x = 0; x < labels.width(); ++x) {
            bool border = false;
            for (const auto& [dx, dy] : {std::pair{thickness, 0}, {-thickness, 0}, {0, thickness}, {0, -thickness}})
                border = border || (labels.contains(x + dx, y + dy) && labels(x + dx, y + dy) != labels(x, y));
            if (border && labels(x, y) != 0) picture(x, y) = Vector3f(1, 0.2f, 0.8f);
        }
    }
    return picture;
}

ImageRgb sideBySide(const ImageRgb& a, const ImageRgb& b) {
    ImageRgb both(a.width() + b.width(), std::max(a.height(), b.height()));
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) both(x, y) = a(x, y);
    for (int y = 0; y < b.height(); ++y)
        for (int x = 0; x < b.width(); ++x) both(a.width() + x, y) = b(x, y);
    return both;
}

Json analysedReport(const core::Scene& scene, const std::string& name, ContactSheet& sheet, const fs::path& output) {
    const core::Photo& photo = *scene.photo;
    auto start = core::Clock::now();
    const auto analysis = core::AnalysisPipeline().run(scene);
    const double analysisSeconds = core::secondsSince(start);
    start = core::Clock::now();
    const ImageRgb edited = render::renderImage(newDevice(), scene, analysis);
    const double renderSeconds = core::secondsSince(start);

    // Photographs keep their exposure; floating-point pictures brighter than white are darkened.
    const float exposure = std::min(displayExposure(photo.color), 1.0f);
    const ImageRgb before = displayEncoded(photo.color, exposure);
    const ImageRgb after = displayEncoded(edited, exposure);
    core::Image<std::uint8_t> mask(photo.labels.width(), photo.labels.height());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = photo.labels[i] != 0 ? 1 : 0;
    const Rect rect = boundsOf(mask, photo.camera.width / 30);
    savePicture(sideBySide(fitted(cropped(before, rect), kLargePicture / 2, kLargePicture / 2),
                           fitted(cropped(after, rect), kLargePicture / 2, kLargePicture / 2)),
                (output / ("photo_" + name + ".png")).string());
    const float lightExposure = displayExposure(analysis->environment->radiance);
    sheet.addRow({{name, withOutlines(before, photo.labels)},
                  {"depth", depthPicture(analysis->front->depth, depthRange(analysis->front->depth))},
                  {"normals", normalPicture(analysis->front->normal)},
                  {"environment", displayEncoded(analysis->environment->radiance, lightExposure)},
                  {"edit", after}});

    Json report = {{"photo", name},
                   {"width", photo.camera.width},
                   {"height", photo.camera.height},
                   {"analysis_seconds", analysisSeconds},
                   {"edit_seconds", renderSeconds},
                   {"glossy", Json::array()}};
    for (const auto& reflectance : analysis->reflectances)
        report["glossy"].push_back({{"segment", scene.findSegment(reflectance->label)->name},
                                    {"reflectance", {reflectance->rho.x(), reflectance->rho.y(), reflectance->rho.z()}},
                                    {"reliable", reflectance->reliable},
                                    {"alpha", reflectance->alpha},
                                    {"alpha_reliable", reflectance->alphaReliable}});
    return report;
}

}  // namespace

core::Scene loadPhotoScene(const fs::path& folder, const Json& entry, int longerSide) {
    core::CreateOptions options;
    options.color = (folder / entry.at("color").get<std::string>()).string();
    if (entry.contains("depth")) options.depth = (folder / entry.at("depth").get<std::string>()).string();
    if (entry.contains("depth_unit")) options.depthUnit = entry.at("depth_unit").get<double>();
    if (entry.contains("sample_entry")) options.intrinsics = sampleIntrinsics(folder, entry.at("sample_entry"));
    core::Scene scene = core::createScene(options);
    auto photo = std::make_shared<core::Photo>(*scene.photo);
    if (entry.contains("disparity_offset"))
        photo->depth =
            offsetDisparity(core::loadScalar(options.depth), entry.at("disparity_offset"), entry.at("focal_baseline"));
    const int side = std::max(photo->camera.width, photo->camera.height);
    if (longerSide > 0 && side > longerSide) photo = reduced(*photo, (side + longerSide - 1) / longerSide);
    std::optional<core::ImageF> mask;
    if (entry.contains("mask")) mask = core::loadScalar((folder / entry.at("mask").get<std::string>()).string());
    if (mask && !mask->sameSize(photo->labels))
        throw core::Error(core::ErrorKind::Input, "The mask of \"" + options.color +
                                                      "\" has another size than the picture as it is evaluated.");
    const float scale = static_cast<float>(photo->camera.width) / entry.at("outline_width").get<float>();
    std::uint16_t label = 0;
    for (const Json& segment : entry.at("segments"))
        fillOutlines(photo->labels, outlinesOf(segment, scale), ++label,
                     segment.value("mask", false) ? &mask.value() : nullptr);
    scene.photo = photo;
    core::addMissingSegments(scene);
    label = 0;
    for (const Json& json : entry.at("segments")) {
        core::Segment* segment = scene.findSegment(++label);
        if (segment == nullptr)
            throw core::Error(core::ErrorKind::Input, "The outline of \"" + json.at("name").get<std::string>() +
                                                          "\" holds no pixel of \"" + options.color + "\".");
        segment->name = json.at("name");
        segment->glossy = json.value("glossy", false);
        if (json.contains("edit")) segment->edit = core::materialFromJson(json.at("edit").dump());
    }
    return scene;
}

Json photoReport(const fs::path& folder, const Json& entry, const PhotoOptions& options, ContactSheet& sheet,
                 const fs::path& output) {
    const std::string name = entry.at("name");
    try {
        core::Scene scene = loadPhotoScene(folder, entry, options.longerSide);
        scene.render.samples = options.samples;
        return analysedReport(scene, name, sheet, output);
    } catch (const core::Error& error) {
        // Messages contain full paths, but the report must not depend on where the data lies.
        std::string reason = error.what();
        const std::string prefix = folder.string() + "/";
        for (std::size_t at = reason.find(prefix); at != std::string::npos; at = reason.find(prefix))
            reason.erase(at, prefix.size());
        return {{"photo", name}, {"skipped", reason}};
    }
}

void printPhotos(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    out << "\n### Photographs without truth\n\nPictures: photos.png.\n\n";
    Table table(out, {"photo", "size", "analysis [s]", "edit [s]", "glossy segments: reflectance, alpha"});
    for (const Json& report : reports) {
        if (report.contains("skipped")) {
            table.row({report.at("photo"), "–", "–", "–", "skipped: " + report.at("skipped").get<std::string>()});
            continue;
        }
        std::string glossy;
        for (const Json& entry : report.at("glossy")) {
            glossy += (glossy.empty() ? "" : "; ") + entry.at("segment").get<std::string>() + ":";
            for (const Json& channel : entry.at("reflectance")) glossy += " " + fixed(channel, 2);
            glossy += entry.at("reliable").get<bool>() ? "" : " (a guess)";
            glossy += ", " + fixed(entry.at("alpha"), 2);
        }
        table.row(
            {report.at("photo"),
             std::to_string(report.at("width").get<int>()) + " × " + std::to_string(report.at("height").get<int>()),
             fixed(report.at("analysis_seconds"), 1), fixed(report.at("edit_seconds"), 1), glossy});
    }
}

}  // namespace evaluate
