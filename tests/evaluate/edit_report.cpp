// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/edit_report.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/io/image_io.h"
#include "core/shading/silhouette.h"
#include "render/renderer.h"
#include "tests/evaluate/device.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/metrics.h"

namespace evaluate {

namespace {

struct Variant {
    const char* key;
    const char* title;
    core::ImageRgb EditPictures::*picture;
};
constexpr std::array<Variant, 4> kVariants = {{{"unedited", "unedited", &EditPictures::unedited},
                                               {"ours", "ours", &EditPictures::ours},
                                               {"true_light", "+ true light", &EditPictures::trueLight},
                                               {"true_light_and_back", "+ true back", &EditPictures::trueBoth}}};

struct Metric {
    const char* key;
    const char* title;
    int digits;
};
constexpr std::array<Metric, 4> kMetrics = {{{"psnr", "PSNR [dB]", 1},
                                             {"ssim", "SSIM", 3},
                                             {"rel_mse", "relMSE", 3},
                                             {"mean_ratio", "mean over true mean", 2}}};

constexpr int kOutlineWidth = 2;  // [px], on either side

core::Image<std::uint8_t> dilatedMask(const core::LabelImage& labels, std::uint16_t label, int dilation) {
    core::Image<std::uint8_t> mask(labels.width(), labels.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            for (int v = y - dilation; v <= y + dilation; ++v)
                for (int u = x - dilation; u <= x + dilation; ++u)
                    if (labels.contains(u, v) && labels(u, v) == label) mask(x, y) = 1;
    return mask;
}

/// The picture with mixed pixels of the outline unmixed: only the edited surface inside the label, the photograph
/// outside.
core::ImageRgb stoppedAtLabel(const core::Scene& scene, const Edit& edit, const core::ImageRgb& picture) {
    std::vector<std::uint8_t> edited(std::size_t{edit.label} + 1, 0);
    edited[edit.label] = 1;
    core::ImageRgb result = picture;
    for (const core::SilhouettePixel& p :
         core::findSilhouette(scene.photo->color, scene.photo->labels, scene.photo->depth, edit.label, edited,
                              core::coverageFrom(scene.findSegment(edit.label)->glossy))) {
        if (scene.photo->labels(p.x, p.y) != edit.label)
            result(p.x, p.y) = scene.photo->color(p.x, p.y);
        else if (p.coverage > 0)
            result(p.x, p.y) = (picture(p.x, p.y) - p.kept) / p.coverage;
    }
    return result;
}

Json toJson(const Metrics& m) {
    return {{"psnr", m.psnr}, {"ssim", m.ssim}, {"rel_mse", m.relMse}, {"mean_ratio", m.meanRatio}};
}

}  // namespace

EditPictures renderEdit(const SceneFolder& folder, const Edit& edit, core::AnalysisPipeline& pipeline) {
    const gpu::Device device = newDevice();
    core::Scene scene = folder.scene;
    scene.findSegment(edit.label)->edit = edit.material;
    EditPictures pictures;
    pictures.unedited = scene.photo->color;
    pictures.truth = core::loadColor(edit.truth.string());
    pictures.ours = render::renderImage(device, scene, pipeline.run(scene));
    scene.environment.image = std::make_shared<core::ImageRgb>(trueEnvironment(folder));
    scene.environment.path = "env.exr";
    pictures.trueLight = render::renderImage(device, scene, pipeline.run(scene));
    scene.backDepth = std::make_shared<core::ImageF>(trueBackDepth(folder));
    scene.backDepthPath = "depth_back.exr";
    pictures.trueBoth = render::renderImage(device, scene, pipeline.run(scene));
    return pictures;
}

Json editReport(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures) {
    const float exposure = displayExposure(pictures.truth);
    const auto mask = erodedMask(folder.scene.photo->labels, edit.label, 1);
    Json report = {{"scene", folder.name}, {"edit", edit.name}, {"samples", folder.scene.render.samples}};
    for (const Variant& variant : kVariants)
        report[variant.key] = toJson(compare(pictures.*variant.picture, pictures.truth, mask, exposure));
    const core::LabelImage& labels = folder.scene.photo->labels;
    const auto whole = dilatedMask(labels, edit.label, kOutlineWidth);
    const auto inner = erodedMask(labels, edit.label, kOutlineWidth);
    auto outline = whole;
    for (std::size_t i = 0; i < outline.size(); ++i) outline[i] = whole[i] != 0 && inner[i] == 0 ? 1 : 0;
    const core::ImageRgb stopped = stoppedAtLabel(folder.scene, edit, pictures.trueBoth);
    report["outline"] = {{"stopped_at_label", compare(stopped, pictures.truth, outline, exposure).psnr},
                         {"mixed", compare(pictures.trueBoth, pictures.truth, outline, exposure).psnr},
                         {"whole_stopped_at_label", compare(stopped, pictures.truth, whole, exposure).psnr},
                         {"whole_mixed", compare(pictures.trueBoth, pictures.truth, whole, exposure).psnr}};
    return report;
}

double meanOverEdits(const Json& reports, const std::string& variant, const std::string& metric) {
    double sum = 0;
    int count = 0;
    for (const Json& report : reports) {
        const double value = report.at(variant).at(metric);
        if (!std::isfinite(value)) continue;
        sum += value;
        ++count;
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

void printEdits(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    out << "\n### Edits\n\nInside the edited segment, eroded by one pixel. PSNR and SSIM of the display-encoded "
           "picture, "
           "99th percentile of the truth at 1; relative MSE and mean of the linear one.\n";
    for (const Metric& metric : kMetrics) {
        out << "\n" << metric.title << ":\n\n";
        std::vector<std::string> columns = {"scene", "edit"};
        for (const Variant& variant : kVariants) columns.emplace_back(variant.title);
        Table table(out, columns);
        for (const Json& report : reports) {
            std::vector<std::string> cells = {report.at("scene"), report.at("edit")};
            for (const Variant& variant : kVariants)
                cells.push_back(fixed(report.at(variant.key).at(metric.key), metric.digits));
            table.row(cells);
        }
        std::vector<std::string> cells = {"**mean**", ""};
        for (const Variant& variant : kVariants)
            cells.push_back(fixed(meanOverEdits(reports, variant.key, metric.key), metric.digits));
        table.row(cells);
    }
    out << "\nOutlines, with true light and back side: PSNR [dB] of the pixels within two of the outline, and of the "
           "segment with two pixels around it; where the edit stops at the label, and where mixed pixels are taken "
           "apart:\n\n";
    Table table(out, {"scene", "edit", "outline, stopped", "outline, mixed", "whole, stopped", "whole, mixed"});
    for (const Json& report : reports) {
        const Json& outline = report.at("outline");
        table.row({report.at("scene"), report.at("edit"), fixed(outline.at("stopped_at_label"), 1),
                   fixed(outline.at("mixed"), 1), fixed(outline.at("whole_stopped_at_label"), 1),
                   fixed(outline.at("whole_mixed"), 1)});
    }
}

}  // namespace evaluate
