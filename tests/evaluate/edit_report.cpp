// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/edit_report.h"

#include <array>
#include <cmath>
#include <limits>

#include "core/io/image_io.h"
#include "core/render/renderer.h"
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
}

}  // namespace evaluate
