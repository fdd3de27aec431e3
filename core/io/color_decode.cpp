// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/color_decode.h"

#include <lcms2.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/color.h"

namespace core {

namespace {

struct CloseProfile {
    void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct CloseTransform {
    void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
struct FreeCurve {
    void operator()(cmsToneCurve* curve) const { cmsFreeToneCurve(curve); }
};
struct FreeContext {
    void operator()(cmsContext context) const { cmsDeleteContext(context); }
};
using Context = std::unique_ptr<std::remove_pointer_t<cmsContext>, FreeContext>;
using Profile = std::unique_ptr<void, CloseProfile>;

/// One that says nothing about damaged profiles.
Context quietContext() {
    Context context(cmsCreateContext(nullptr, nullptr));
    cmsSetLogErrorHandlerTHR(context.get(), [](cmsContext, cmsUInt32Number, const char*) {});
    return context;
}

/// An RGB profile with one curve, y = (a·x + b)^g from d on and c·x below.
struct Curve {
    double g = 1, a = 1, b = 0, c = 1, d = 0;
};
Profile rgbProfile(cmsContext context, const cmsCIExyY& white, const cmsCIExyYTRIPLE& primaries, const Curve& curve) {
    const double parameters[]{curve.g, curve.a, curve.b, curve.c, curve.d};
    const std::unique_ptr<cmsToneCurve, FreeCurve> tone(cmsBuildParametricToneCurve(context, 4, parameters));
    cmsToneCurve* curves[] = {tone.get(), tone.get(), tone.get()};
    return Profile(cmsCreateRGBProfileTHR(context, &white, &primaries, curves));
}

/// Rec.709 primaries, D65, no transfer function.
Profile linearRec709(cmsContext context) {
    return rgbProfile(context, {0.3127, 0.3290, 1.0}, {{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}}, {});
}

/// From encoded to linear, by the number of H.273's table 3.
std::optional<Curve> codedCurve(std::uint16_t transfer) {
    switch (transfer) {
        case 1:  // Rec.709, Rec.601 and Rec.2020 share one function
        case 6:
        case 11:
        case 14:
        case 15:
            return Curve{1 / 0.45, 1 / 1.0993, 0.0993 / 1.0993, 1 / 4.5, 4.5 * 0.01805};
        case 4:
            return Curve{2.2};
        case 5:
            return Curve{2.8};
        case 7:
            return Curve{1 / 0.45, 1 / 1.1115, 0.1115 / 1.1115, 1 / 4.0, 4.0 * 0.0228};
        case 8:
            return Curve{};
        case 2:
        case 13:
            return Curve{2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045};
        default:
            return std::nullopt;
    }
}

/// Converts in place from a profile of `channels` channels to linear Rec.709. Returns false, leaving the pixels, where
/// that cannot be done.
bool toLinearRec709(cmsContext context, void* source, int channels, std::span<Vector3f> pixels) {
    const Profile target = linearRec709(context);
    const std::unique_ptr<void, CloseTransform> transform(
        cmsCreateTransformTHR(context, source, channels == 1 ? TYPE_GRAY_FLT : TYPE_RGB_FLT, target.get(), TYPE_RGB_FLT,
                              INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE));
    if (!transform) return false;

    constexpr std::size_t kBlock = 4096;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels.size(), kBlock), [&](const auto& range) {
        std::vector<float> in;
        std::vector<float> out(range.size() * 3);
        in.reserve(out.size());
        const std::span<Vector3f> block = pixels.subspan(range.begin(), range.size());
        for (const Vector3f& p : block)
            for (int c = 0; c < channels; ++c) in.push_back(p[c]);
        cmsDoTransform(transform.get(), in.data(), out.data(), static_cast<cmsUInt32Number>(block.size()));
        std::size_t n = 0;
        for (Vector3f& p : block)
            for (int c = 0; c < 3; ++c) p[c] = out[n++];
    });
    return true;
}

}  // namespace

bool decodeIcc(std::span<Vector3f> pixels, std::span<const unsigned char> profile) {
    const Context context = quietContext();
    const Profile source(
        cmsOpenProfileFromMemTHR(context.get(), profile.data(), static_cast<cmsUInt32Number>(profile.size())));
    if (!source) return false;
    const cmsColorSpaceSignature space = cmsGetColorSpace(source.get());
    if (space != cmsSigRgbData && space != cmsSigGrayData) return false;
    return toLinearRec709(context.get(), source.get(), space == cmsSigGrayData ? 1 : 3, pixels);
}

bool decodeCoded(std::span<Vector3f> pixels, const CodedRgb& space) {
    const auto curve = codedCurve(space.transfer);
    if (!curve) return false;
    const Context context = quietContext();
    const auto point = [](const std::array<double, 2>& xy) { return cmsCIExyY{xy[0], xy[1], 1.0}; };
    const Profile source = rgbProfile(context.get(), point(space.white),
                                      {point(space.red), point(space.green), point(space.blue)}, *curve);
    return source && toLinearRec709(context.get(), source.get(), 3, pixels);
}

void decodeSrgb(std::span<Vector3f> pixels) {
    for (Vector3f& p : pixels)
        for (int c = 0; c < 3; ++c) p[c] = srgbDecode(p[c]);
}

void decodeGamma(std::span<Vector3f> pixels, float gamma) {
    for (Vector3f& p : pixels)
        for (int c = 0; c < 3; ++c) p[c] = std::pow(std::max(p[c], 0.0f), gamma);
}

}  // namespace core
