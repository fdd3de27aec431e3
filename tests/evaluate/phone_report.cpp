// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/phone_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/analysis/pipeline.h"
#include "core/io/image_io.h"
#include "render/renderer.h"
#include "tests/evaluate/device.h"
#include "tests/evaluate/markdown.h"
#include "tests/evaluate/metrics.h"
#include "tests/evaluate/phone_picture.h"
#include "tests/evaluate/pictures.h"

namespace evaluate {

namespace fs = std::filesystem;
using core::ImageF;
using core::ImageRgb;
using core::Vector3f;
using Mask = core::Image<std::uint8_t>;

namespace {

struct PhoneVariant {
    const char* key;
    const char* title;
    PhoneDepth depth;
    bool flags;
    bool trueLight;
};
constexpr std::array<PhoneVariant, 4> kPhoneVariants = {
    {{"phone", "phone", PhoneDepth::Phone, true, false},
     {"unflagged", "phone, nothing flagged", PhoneDepth::Phone, false, false},
     {"exact_depth", "exact depth, 8-bit picture", PhoneDepth::Exact, true, false},
     {"true_light", "phone, true light", PhoneDepth::Phone, true, true}}};

/// Pixels of a label whose eight neighbours have it, too.
Mask innerMask(const core::LabelImage& labels, std::uint16_t label) {
    Mask mask(labels.width(), labels.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            bool inside = true;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u)
                    inside = inside && (!labels.contains(u, v) || labels(u, v) == label);
            mask(x, y) = inside ? 1 : 0;
        }
    return mask;
}

ImageRgb clipped(const ImageRgb& picture, float scale) {
    ImageRgb result(picture.width(), picture.height());
    for (std::size_t i = 0; i < picture.size(); ++i) result[i] = (scale * picture[i]).cwiseMin(1.0f).cwiseMax(0.0f);
    return result;
}

float exposureInside(const ImageRgb& truth, const Mask& mask) {
    std::vector<float> values;
    for (std::size_t i = 0; i < truth.size(); ++i)
        if (mask[i] != 0)
            for (int c = 0; c < 3; ++c) values.push_back(truth[i][c]);
    return 1 / std::max(static_cast<float>(quantile(std::move(values), 0.99)), 1e-6f);
}

/// Standard deviation of the logarithm of luminance.
double contrastOf(const ImageRgb& picture, const Mask& mask) {
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = 0; i < picture.size(); ++i) {
        if (mask[i] == 0) continue;
        const double value = std::log(std::max(static_cast<double>(luminance(picture[i])), 0.01));
        sum += value, squares += value * value, count += 1;
    }
    return std::sqrt(std::max(squares / count - sum / count * sum / count, 1e-12));
}

ImageF channelOf(const ImageRgb& picture, int c) {
    ImageF result(picture.width(), picture.height());
    for (std::size_t i = 0; i < picture.size(); ++i) result[i] = picture[i][c];
    return result;
}

/// 11 × 11 Gaussian of σ = 1.5, mirrored at the borders.
ImageF windowMean(const ImageF& image) {
    const auto pass = [](const ImageF& in, int dx, int dy) {
        ImageF out(in.width(), in.height());
        const auto mirrored = [](int i, int size) { return size - 1 - std::abs(size - 1 - std::abs(i)); };
        for (int y = 0; y < in.height(); ++y)
            for (int x = 0; x < in.width(); ++x) {
                float sum = 0, weights = 0;
                for (int k = -5; k <= 5; ++k) {
                    const float w = std::exp(-static_cast<float>(k * k) / 4.5f);
                    sum += w * in(mirrored(x + k * dx, in.width()), mirrored(y + k * dy, in.height()));
                    weights += w;
                }
                out(x, y) = sum / weights;
            }
        return out;
    };
    return pass(pass(image, 1, 0), 0, 1);
}

ImageF product(const ImageF& a, const ImageF& b) {
    ImageF result(a.width(), a.height());
    for (std::size_t i = 0; i < a.size(); ++i) result[i] = a[i] * b[i];
    return result;
}

/// Unlike `compare`'s, of all three channels and with windows that reach over the outline.
double ssimOfChannels(const ImageRgb& picture, const ImageRgb& truth, const Mask& mask) {
    constexpr double kC1 = 0.01 * 0.01;
    constexpr double kC2 = 0.03 * 0.03;
    double sum = 0, count = 0;
    for (int c = 0; c < 3; ++c) {
        const ImageF a = channelOf(picture, c);
        const ImageF b = channelOf(truth, c);
        const ImageF ma = windowMean(a), mb = windowMean(b);
        const ImageF aa = windowMean(product(a, a)), bb = windowMean(product(b, b)), ab = windowMean(product(a, b));
        for (std::size_t i = 0; i < mask.size(); ++i) {
            if (mask[i] == 0) continue;
            const auto x = static_cast<double>(ma[i]), y = static_cast<double>(mb[i]);
            const double va = static_cast<double>(aa[i]) - x * x, vb = static_cast<double>(bb[i]) - y * y;
            const double cov = static_cast<double>(ab[i]) - x * y;
            sum += (2 * x * y + kC1) * (2 * cov + kC2) / ((x * x + y * y + kC1) * (va + vb + kC2));
            count += 1;
        }
    }
    return sum / count;
}

Json figures(const ImageRgb& picture, const ImageRgb& truth, const Mask& mask) {
    const float exposure = exposureInside(truth, mask);
    const ImageRgb a = displayEncoded(picture, exposure);
    const ImageRgb b = displayEncoded(truth, exposure);
    double squared = 0, sum = 0, trueSum = 0, count = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        squared += (a[i] - b[i]).cast<double>().squaredNorm() / 3;
        sum += picture[i].cast<double>().sum();
        trueSum += truth[i].cast<double>().sum();
        count += 1;
    }
    return {{"psnr", -10 * std::log10(std::max(squared / count, 1e-10))},
            {"ssim", ssimOfChannels(a, b, mask)},
            {"contrast", contrastOf(picture, mask) / contrastOf(truth, mask)},
            {"mean_ratio", sum / std::max(trueSum, 1e-12)}};
}

/// Angles to the true normals in all segments but the largest.
std::vector<float> normalErrors(const SceneFolder& folder, const core::Surface& front) {
    const core::LabelImage& labels = folder.scene.photo->labels;
    std::map<std::uint16_t, std::size_t> sizes;
    for (const std::uint16_t label : labels.pixels())
        if (label != 0) ++sizes[label];
    const auto largest = std::ranges::max_element(sizes, {}, [](const auto& entry) { return entry.second; });
    const core::ImageV3 truth = trueNormals(folder);
    std::vector<float> angles;
    for (std::size_t i = 0; i < labels.size(); ++i)
        if (labels[i] != 0 && labels[i] != largest->first)
            angles.push_back(static_cast<float>(angleDegrees(front.normal[i], truth[i])));
    return angles;
}

void useTrueLight(const SceneFolder& folder, core::Scene& scene) {
    auto light = std::make_shared<core::ImageRgb>(trueEnvironment(folder));
    for (Vector3f& value : light->pixels()) value /= phoneWhite(folder);
    scene.environment.image = std::move(light);
    scene.environment.path = "env.exr";
    scene.environment.use = core::EnvironmentUse::Replace;
}

struct EditPictureSet {
    ImageRgb photo, truth;
    std::vector<ImageRgb> ours;
};

std::vector<ContactSheet::Cell> phoneRow(const SceneFolder& folder, const Edit& edit, const EditPictureSet& pictures,
                                         const Mask& mask, const Json& reports) {
    const float exposure = exposureInside(pictures.truth, mask);
    const Rect rect = boundsOf(mask, 12);
    const auto crop = [&](const ImageRgb& picture) { return displayEncoded(cropped(picture, rect), exposure); };
    std::vector<ContactSheet::Cell> cells{{folder.name + "/" + edit.name, crop(pictures.photo)},
                                          {"truth", crop(pictures.truth)}};
    for (std::size_t v = 0; v < kPhoneVariants.size(); ++v)
        cells.push_back(
            {std::string(kPhoneVariants[v].title) + " " + fixed(reports.at(v).at("psnr"), 1), crop(pictures.ours[v])});
    return cells;
}

/// Mean of a figure over the reports of one variant.
double meanOf(const Json& reports, const std::string& variant, const char* figure) {
    double sum = 0, count = 0;
    for (const Json& report : reports)
        if (report.at("variant") == variant) sum += report.at(figure).get<double>(), count += 1;
    return sum / count;
}

}  // namespace

Json phoneReports(const SceneFolder& folder, const std::string& only, ContactSheet& sheet, const fs::path& output) {
    std::vector<core::Scene> scenes;
    std::vector<core::AnalysisPipeline> pipelines(kPhoneVariants.size());
    std::vector<std::vector<float>> angles;
    for (std::size_t v = 0; v < kPhoneVariants.size(); ++v) {
        core::Scene& scene = scenes.emplace_back(phoneScene(folder, kPhoneVariants[v].depth, output));
        if (!kPhoneVariants[v].flags)
            for (core::Segment& segment : scene.segments) segment.glossy = false;
        if (kPhoneVariants[v].trueLight) useTrueLight(folder, scene);
        angles.push_back(normalErrors(folder, *pipelines[v].run(scene)->front));
    }
    const float white = phoneWhite(folder);
    Json all = Json::array();
    for (const Edit& edit : folder.edits) {
        if (!only.empty() && edit.name != only) continue;
        const Mask mask = innerMask(folder.scene.photo->labels, edit.label);
        EditPictureSet pictures{clipped(folder.scene.photo->color, 1 / white),
                                clipped(core::loadColor(edit.truth.string()), 1 / white),
                                {}};
        const double unedited = figures(pictures.photo, pictures.truth, mask).at("psnr");
        Json reports = Json::array();
        for (std::size_t v = 0; v < kPhoneVariants.size(); ++v) {
            core::Scene scene = scenes[v];
            scene.findSegment(edit.label)->edit = edit.material;
            pictures.ours.push_back(clipped(render::renderImage(newDevice(), scene, pipelines[v].run(scene)), 1));
            Json report = figures(pictures.ours.back(), pictures.truth, mask);
            report["scene"] = folder.name;
            report["edit"] = edit.name;
            report["variant"] = kPhoneVariants[v].key;
            report["unedited"] = unedited;
            report["normals"] = {quantile(angles[v], 0.5), quantile(angles[v], 0.95)};
            reports.push_back(std::move(report));
        }
        sheet.addRow(phoneRow(folder, edit, pictures, mask, reports));
        for (Json& report : reports) all.push_back(std::move(report));
    }
    fs::remove(output / "phone.jpg");
    fs::remove(output / "disparity.exr");
    return all;
}

void printPhone(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    out << "\n### As a phone would have taken it\n\nInside the edited segment, eroded by one pixel: an 8-bit picture "
           "with clipped highlights and a small, blurred, shifted 8-bit depth map. Pictures: phone.png.\n\n";
    Table table(out, {"variant", "scene", "edit", "unedited [dB]", "PSNR [dB]", "SSIM", "contrast", "mean",
                      "normals, median / 95 %"});
    for (const PhoneVariant& variant : kPhoneVariants) {
        for (const Json& report : reports) {
            if (report.at("variant") != variant.key) continue;
            table.row({variant.title, report.at("scene"), report.at("edit"), fixed(report.at("unedited"), 1),
                       fixed(report.at("psnr"), 2), fixed(report.at("ssim"), 3), fixed(report.at("contrast"), 2),
                       fixed(report.at("mean_ratio"), 2),
                       fixed(report.at("normals").at(0), 1) + "° / " + fixed(report.at("normals").at(1), 1) + "°"});
        }
        table.row({"**" + std::string(variant.title) + "**", "**mean**", "",
                   fixed(meanOf(reports, variant.key, "unedited"), 2), fixed(meanOf(reports, variant.key, "psnr"), 2),
                   fixed(meanOf(reports, variant.key, "ssim"), 3), fixed(meanOf(reports, variant.key, "contrast"), 2),
                   fixed(meanOf(reports, variant.key, "mean_ratio"), 2), ""});
    }
}

}  // namespace evaluate
