// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/deep_exr.h"

#include <OpenEXR/ImfCompositeDeepScanLine.h>
#include <OpenEXR/ImfDeepCompositing.h>
#include <OpenEXR/ImfDeepScanLineInputPart.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include "core/base/error.h"

namespace core {

namespace {

constexpr std::int64_t kMaxSamplesPerRow = std::int64_t{1} << 22U;

/// Composites colours, but picks a depth: a blend of two would lie where nothing is.
class MedianDepth : public Imf::DeepCompositing {
  public:
    void composite_pixel(float outputs[], const float* inputs[], const char*[], int channels, int samples,
                         int) override {
        std::fill(outputs, outputs + channels, 0.0f);
        std::vector<int> order(static_cast<std::size_t>(samples));
        std::iota(order.begin(), order.end(), 0);
        constexpr int kZ = 0, kZBack = 1, kAlpha = 2;
        const auto depth = [&](int sample) {
            return std::isnan(inputs[kZ][sample]) ? std::numeric_limits<float>::infinity() : inputs[kZ][sample];
        };
        std::ranges::stable_sort(order, {}, depth);
        for (const int sample : order) {
            const float visible = 1 - outputs[kAlpha];
            if (!(visible > 0)) break;
            for (int c = kAlpha; c < channels; ++c) outputs[c] += visible * inputs[c][sample];
            if (outputs[kAlpha] < 0.5f || visible <= 0.5f) continue;
            outputs[kZ] = inputs[kZ][sample];
            outputs[kZBack] = inputs[kZBack][sample];
        }
    }
};

}  // namespace

std::vector<float> flattenDeepExr(const std::string& path, int part, const std::vector<std::string>& channels) {
    Imf::MultiPartInputFile file(path.c_str());
    if (!file.header(part).hasType() || file.header(part).type() != Imf::DEEPSCANLINE)
        throw Error(ErrorKind::Input, Message("messages", "it is a deep image in tiles, expected scan lines"));
    Imf::DeepScanLineInputPart source(file, part);
    const Imath::Box2i window = file.header(part).dataWindow();
    const auto width = static_cast<std::size_t>(std::int64_t{window.max.x} - window.min.x + 1);
    const auto height = static_cast<std::size_t>(std::int64_t{window.max.y} - window.min.y + 1);
    std::vector<float> pixels(width * height * channels.size());

    Imf::FrameBuffer target;
    const std::size_t xStride = channels.size() * sizeof(float);
    for (std::size_t c = 0; c < channels.size(); ++c)
        target.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, pixels.data() + c, window, xStride, xStride * width));
    MedianDepth compositing;
    Imf::CompositeDeepScanLine::setMaximumSampleCount(kMaxSamplesPerRow);
    Imf::CompositeDeepScanLine composite;
    composite.setCompositing(&compositing);
    composite.addSource(&source);
    composite.setFrameBuffer(target);
    for (int y = window.min.y; y <= window.max.y; ++y) composite.readPixels(y, y);
    return pixels;
}

}  // namespace core
