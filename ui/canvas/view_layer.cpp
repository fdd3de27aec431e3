// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/view_layer.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "ui/canvas/display.h"

namespace ui {

namespace {

const core::Vector3f kNothing(0.08f, 0.08f, 0.08f);

core::ImageRgb depthPicture(const core::ImageF& depth, const core::ImageF& scale) {
    float nearest = 0;
    float farthest = 0;
    for (const float z : scale.pixels()) {
        if (!(z > 0)) continue;
        nearest = nearest == 0 ? z : std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    // Uniform in 1/z, so that near surfaces get more colours.
    const float low = farthest > 0 ? 1 / farthest : 0;
    const float range = nearest > 0 ? std::max(1 / nearest - low, 1e-6f) : 1;
    core::ImageRgb picture(depth.width(), depth.height(), kNothing);
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (depth[i] > 0) picture[i] = rampColor((1 / depth[i] - low) / range);
    }
    return picture;
}

core::ImageRgb normalPicture(const core::ImageV3& normals) {
    core::ImageRgb picture(normals.width(), normals.height(), kNothing);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const core::Vector3f& n = normals[i];
        if (n.squaredNorm() > 0)
            picture[i] = core::Vector3f(0.5f + 0.5f * n.x(), 0.5f - 0.5f * n.y(), 0.5f - 0.5f * n.z());
    }
    return picture;
}

core::ImageRgb segmentPicture(const core::Photo& photo) {
    core::ImageRgb picture(photo.color.width(), photo.color.height());
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const core::Vector3f& c = photo.color[i];
        const float luminance = 0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z();
        const std::uint16_t label = photo.labels.empty() ? std::uint16_t{0} : photo.labels[i];
        picture[i] = segmentColor(label) * (0.45f + 0.55f * encodeSrgb(luminance));
    }
    return picture;
}

core::ImageRgb coveragePicture(const core::Photo& photo, const core::Analysis& analysis) {
    core::ImageRgb picture(photo.color.width(), photo.color.height());
    const core::DirectionalMap& map = *analysis.environment;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const core::Vector3f& c = photo.color(x, y);
            const float grey = 0.35f * encodeSrgb(0.2126f * c.x() + 0.7152f * c.y() + 0.0722f * c.z());
            picture(x, y) = core::Vector3f::Constant(grey);
            const core::Vector3f& n = analysis.front->normal(x, y);
            if (n.squaredNorm() == 0 || map.coverage.empty()) continue;
            const core::Vector3f view = photo.camera.pixelRay(x, y).normalized();
            const core::Vector3f mirrored = view - 2 * view.dot(n) * n;
            const core::Vector2f texel =
                core::DirectionalMap::texelFromDirection(mirrored, map.coverage.width(), map.coverage.height());
            const int u = std::clamp(static_cast<int>(texel.x()), 0, map.coverage.width() - 1);
            const int v = std::clamp(static_cast<int>(texel.y()), 0, map.coverage.height() - 1);
            const float seen = map.coverage(u, v);
            const core::Vector3f color =
                seen > 0 ? rampColor(0.35f + 0.1f * std::log2(1 + seen)) : core::Vector3f(0.80f, 0.32f, 0.16f);
            picture(x, y) = core::Vector3f::Constant(grey) + 0.6f * color;
        }
    }
    return picture;
}

}  // namespace

QString layerKey(ViewLayer layer) {
    switch (layer) {
        case ViewLayer::Result:
            return QStringLiteral("result");
        case ViewLayer::Original:
            return QStringLiteral("original");
        case ViewLayer::Depth:
            return QStringLiteral("depth");
        case ViewLayer::Normals:
            return QStringLiteral("normals");
        case ViewLayer::Segments:
            return QStringLiteral("segments");
        case ViewLayer::BackDepth:
            return QStringLiteral("backDepth");
        case ViewLayer::Coverage:
            return QStringLiteral("coverage");
    }
    return {};
}

QString layerTitle(ViewLayer layer) {
    static constexpr std::array<const char*, kViewLayers.size()> kTitles = {
        QT_TRANSLATE_NOOP("ViewLayer", "Result"),   QT_TRANSLATE_NOOP("ViewLayer", "Original"),
        QT_TRANSLATE_NOOP("ViewLayer", "Depth"),    QT_TRANSLATE_NOOP("ViewLayer", "Normals"),
        QT_TRANSLATE_NOOP("ViewLayer", "Segments"), QT_TRANSLATE_NOOP("ViewLayer", "Back depth"),
        QT_TRANSLATE_NOOP("ViewLayer", "Coverage"),
    };
    return QCoreApplication::translate("ViewLayer", kTitles.at(static_cast<std::size_t>(layer)));
}

LayerPicture makeLayerPicture(ViewLayer layer, const core::Photo& photo, const core::Analysis* analysis) {
    const bool known = analysis != nullptr && analysis->front != nullptr && analysis->back != nullptr;
    switch (layer) {
        case ViewLayer::Result:
        case ViewLayer::Original:
            break;
        case ViewLayer::Depth: {
            const core::ImageF& depth = known ? analysis->front->depth : photo.depth.image();
            return {depthPicture(depth, depth), true};
        }
        case ViewLayer::Normals:
            if (known) return {normalPicture(analysis->front->normal), true};
            break;
        case ViewLayer::Segments:
            return {segmentPicture(photo), true};
        case ViewLayer::BackDepth:
            if (known) return {depthPicture(analysis->back->depth, analysis->front->depth), true};
            break;
        case ViewLayer::Coverage:
            if (known && analysis->environment != nullptr) return {coveragePicture(photo, *analysis), true};
            break;
    }
    return {photo.color, false};
}

}  // namespace ui
