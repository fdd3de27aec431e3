// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/color_decode.h"

#include <lcms2.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/srgb.h"

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

/// Rec.709 primaries, D65, no transfer function.
Profile linearRec709(cmsContext context) {
    const cmsCIExyY white{0.3127, 0.3290, 1.0};
    const cmsCIExyYTRIPLE primaries{{0.64, 0.33, 1.0}, {0.30, 0.60, 1.0}, {0.15, 0.06, 1.0}};
    const std::unique_ptr<cmsToneCurve, FreeCurve> linear(cmsBuildGamma(context, 1.0));
    cmsToneCurve* curves[] = {linear.get(), linear.get(), linear.get()};
    return Profile(cmsCreateRGBProfileTHR(context, &white, &primaries, curves));
}

}  // namespace

bool decodeIcc(std::span<Vector3f> pixels, std::span<const unsigned char> profile) {
    const Context context(cmsCreateContext(nullptr, nullptr));
    cmsSetLogErrorHandlerTHR(context.get(), [](cmsContext, cmsUInt32Number, const char*) {});
    const Profile source(
        cmsOpenProfileFromMemTHR(context.get(), profile.data(), static_cast<cmsUInt32Number>(profile.size())));
    if (!source) return false;
    const cmsColorSpaceSignature space = cmsGetColorSpace(source.get());
    if (space != cmsSigRgbData && space != cmsSigGrayData) return false;
    const bool grey = space == cmsSigGrayData;
    const Profile target = linearRec709(context.get());
    const std::unique_ptr<void, CloseTransform> transform(
        cmsCreateTransformTHR(context.get(), source.get(), grey ? TYPE_GRAY_FLT : TYPE_RGB_FLT, target.get(),
                              TYPE_RGB_FLT, INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE));
    if (!transform) return false;

    constexpr std::size_t kBlock = 4096;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, pixels.size(), kBlock), [&](const auto& range) {
        std::vector<float> in;
        std::vector<float> out(range.size() * 3);
        in.reserve(out.size());
        const std::span<Vector3f> block = pixels.subspan(range.begin(), range.size());
        for (const Vector3f& p : block)
            for (int c = 0; c < (grey ? 1 : 3); ++c) in.push_back(p[c]);
        cmsDoTransform(transform.get(), in.data(), out.data(), static_cast<cmsUInt32Number>(block.size()));
        std::size_t n = 0;
        for (Vector3f& p : block)
            for (int c = 0; c < 3; ++c) p[c] = out[n++];
    });
    return true;
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
