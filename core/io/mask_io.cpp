// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/mask_io.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "core/io/image_io.h"

namespace core {

namespace fs = std::filesystem;

std::shared_ptr<const Mask> loadMask(const std::string& path) {
    ImageF values = loadScalar(path);
    const StoredFormat format = storedFormat(path);
    const float scale = format.floating ? 1.0f : 1.0f / static_cast<float>((std::uint64_t{1} << format.bits) - 1);
    for (int y = 0; y < values.height(); ++y)
        for (int x = 0; x < values.width(); ++x) {
            float& v = values(x, y);
            if (!std::isfinite(v))
                throw Error(
                    ErrorKind::Input,
                    Message("messages", "The mask \"%1\" has no number at (%2, %3), expected values from 0 to 1.")
                        .with(path, x, y));
            v *= scale;
        }
    auto mask = std::make_shared<Mask>(values);
    mask->setPath(path);
    return mask;
}

std::shared_ptr<const Mask> MaskLoader::load(const std::string& path) {
    const fs::path given(path);
    const std::string full = given.is_absolute() ? path : (fs::path(folder_) / given).string();
    std::shared_ptr<const Mask>& mask = masks_[full];
    if (mask == nullptr) mask = loadMask(full);
    return mask;
}

Scene withSavedMasks(const Scene& scene, const std::string& project) {
    Scene result = scene;
    std::map<std::shared_ptr<const Mask>, std::shared_ptr<const Mask>> saved;
    const fs::path file(project);
    const fs::path folder = file.parent_path() / (file.stem().string() + ".masks");
    for (Segment& segment : result.segments) {
        if (!segment.edit) continue;
        for (Drive& drive : segment.edit->drives) {
            if (drive.mask == nullptr || !drive.mask->path().empty()) continue;
            std::shared_ptr<const Mask>& kept = saved[drive.mask];
            if (kept == nullptr) {
                std::string word = drive.parameter;
                std::ranges::replace(word, '.', '-');
                std::array<char, 24> hash{};
                (void)std::snprintf(hash.data(), hash.size(), "%016llx",
                                    static_cast<unsigned long long>(drive.mask->hash()));
                const fs::path path =
                    folder / (std::to_string(segment.label) + "-" + word + "-" + hash.data() + ".png");
                std::error_code code;
                fs::create_directories(folder, code);
                if (!fs::exists(path, code)) saveScalar(drive.mask->image(), path.string(), "Y", Mask::kSteps);
                auto copy = std::make_shared<Mask>(*drive.mask);
                copy->setPath(path.string());
                kept = std::move(copy);
            }
            drive.mask = kept;
        }
    }
    return result;
}

}  // namespace core
