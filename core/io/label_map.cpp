// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/label_map.h"

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>

#include "core/io/image_io.h"

namespace core {

namespace {

/// FNV-1a over the label map's width and labels.
std::uint64_t labelHash(const LabelImage& labels) {
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    const auto mix = [&](std::uint64_t value) { hash = (hash ^ value) * 0x100000001b3ULL; };
    mix(static_cast<std::uint64_t>(labels.width()));
    for (const std::uint16_t label : labels.pixels()) mix(label);
    return hash;
}

}  // namespace

Scene withSavedLabels(const Scene& scene, const std::string& project) {
    std::array<char, 24> hash{};
    (void)std::snprintf(hash.data(), hash.size(), "%016llx",
                        static_cast<unsigned long long>(labelHash(scene.photo->labels)));
    const std::filesystem::path file(project);
    const std::filesystem::path path =
        file.parent_path() / (file.stem().string() + ".segments-" + hash.data() + ".png");
    saveLabels(scene.photo->labels, path.string());
    Scene result = scene;
    auto photo = std::make_shared<Photo>(*scene.photo);
    photo->source.segments = path.string();
    result.photo = std::move(photo);
    return result;
}

void saveMask(const BinaryMask& mask, const std::string& path) {
    LabelImage picture(mask.width(), mask.height());
    for (std::size_t i = 0; i < mask.size(); ++i) picture[i] = mask[i] != 0 ? 255 : 0;
    saveLabels(picture, path);
}

}  // namespace core
