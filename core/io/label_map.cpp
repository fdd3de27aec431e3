// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/label_map.h"

#include <array>
#include <cstdio>
#include <filesystem>

#include "core/analysis/step.h"
#include "core/io/image_io.h"

namespace core {

Scene withSavedLabels(const Scene& scene, const std::string& project) {
    std::array<char, 24> hash{};
    (void)std::snprintf(hash.data(), hash.size(), "%016llx",
                        static_cast<unsigned long long>(analysis::Hash().add(scene.photo->labels).value()));
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
