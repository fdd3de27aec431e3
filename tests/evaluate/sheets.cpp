// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/sheets.h"

#include <algorithm>
#include <cmath>

#include "tests/evaluate/directional_metrics.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/metrics.h"
#include "tests/evaluate/pictures.h"

namespace evaluate {

using core::ImageF;
using core::ImageRgb;

namespace {

constexpr int kMargin = 24;

/// The edited segment of the five pictures, display-encoded: unedited, ours, true light, true both, truth.
std::vector<ImageRgb> encodedCrops(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures) {
    const Rect rect = boundsOf(erodedMask(folder.scene.photo->labels, edit.label, 0), kMargin);
    const float exposure = displayExposure(pictures.truth);
    std::vector<ImageRgb> crops;
    for (const ImageRgb* picture :
         {&pictures.unedited, &pictures.ours, &pictures.trueLight, &pictures.trueBoth, &pictures.truth})
        crops.push_back(displayEncoded(cropped(*picture, rect), exposure));
    return crops;
}

ImageF coveragePicture(const core::DirectionalMap& map) {
    ImageF values(map.coverage.width(), map.coverage.height());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::log1p(map.coverage[i]);
    return values;
}

/// Exposure that maps the 90th percentile of luminance to 1, because a sun would make everything else black.
float environmentExposure(const ImageRgb& map) {
    std::vector<float> values;
    for (const auto& pixel : map.pixels()) values.push_back(luminance(pixel));
    return 1 / static_cast<float>(std::max(quantile(std::move(values), 0.9), 1e-6));
}

ContactSheet::Cell cell(const std::string& caption, ImageRgb picture) { return {caption, std::move(picture)}; }

}  // namespace

std::vector<ContactSheet::Cell> editRow(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures,
                                        const Json& report) {
    std::vector<ImageRgb> crops = encodedCrops(folder, edit, pictures);
    const auto caption = [&](const char* text, const char* key) {
        return std::string(text) + " " + fixed(report.at(key).at("psnr"), 1) + " dB";
    };
    ImageRgb difference = differencePicture(crops[1], crops[4]);
    return {cell(folder.name + "/" + edit.name + " " + fixed(report.at("unedited").at("psnr"), 1) + " dB",
                 std::move(crops[0])),
            cell(caption("ours", "ours"), std::move(crops[1])),
            cell(caption("+ true light", "true_light"), std::move(crops[2])),
            cell(caption("+ true back", "true_light_and_back"), std::move(crops[3])),
            cell("truth", std::move(crops[4])),
            cell("ours - truth, times 2", std::move(difference))};
}

void saveStrip(const SceneFolder& folder, const Edit& edit, const EditPictures& pictures,
               const std::filesystem::path& path) {
    const std::vector<ImageRgb> crops = encodedCrops(folder, edit, pictures);
    const int width = crops[0].width();
    ImageRgb strip(width * static_cast<int>(crops.size()), crops[0].height());
    for (std::size_t i = 0; i < crops.size(); ++i)
        for (int y = 0; y < strip.height(); ++y)
            for (int x = 0; x < width; ++x) strip(static_cast<int>(i) * width + x, y) = crops[i](x, y);
    savePicture(strip, path.string());
}

void saveSceneSheet(const SceneFolder& folder, const core::Analysis& analysis, const std::filesystem::path& path) {
    const core::Photo& photo = *folder.scene.photo;
    const core::ImageV3 normals = trueNormals(folder);
    ImageF angles(normals.width(), normals.height());
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (!normals[i].isZero() && !analysis.front->normal[i].isZero())
            angles[i] = static_cast<float>(angleDegrees(normals[i], analysis.front->normal[i]));

    const ImageF back = trueBackDepth(folder);
    const std::pair<double, double> range = depthRange(back);
    ImageF backErrors(back.width(), back.height());
    for (const core::Segment& segment : folder.scene.segments) {
        std::vector<float> thickness;
        for (std::size_t i = 0; i < back.size(); ++i)
            if (photo.labels[i] == segment.label && back[i] > 0) thickness.push_back(back[i] - photo.depth[i]);
        const auto scale = static_cast<float>(quantile(std::move(thickness), 0.5));
        for (std::size_t i = 0; i < back.size(); ++i)
            if (photo.labels[i] == segment.label && back[i] > 0)
                backErrors[i] = std::abs(analysis.back->depth[i] - back[i]) / scale;
    }

    const core::DirectionalMap& light = *analysis.environment;
    const ImageRgb trueLight = resampledMap(trueEnvironment(folder), light.radiance.height());
    const float exposure = environmentExposure(trueLight);
    const ImageF coverage = coveragePicture(light);

    ContactSheet sheet(440, 440);
    sheet.addRow({cell(folder.name + ": normals", normalPicture(analysis.front->normal)),
                  cell("true normals", normalPicture(normals)),
                  cell("angle between, white = 10 degrees", heatPicture(angles, 10))});
    sheet.addRow({cell("back depth", depthPicture(analysis.back->depth, range)),
                  cell("true back depth", depthPicture(back, range)),
                  cell("error, white = the thickness", heatPicture(backErrors, 1))});
    sheet.addRow({cell("environment", displayEncoded(light.radiance, exposure)),
                  cell("observations, logarithmic", heatPicture(coverage, std::log1p(100.0))),
                  cell("true environment", displayEncoded(trueLight, exposure))});
    sheet.save(path.string());
}

}  // namespace evaluate
