// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/brdf_file.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <mutex>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/material/measured_brdf.h"
#include "core/material/user_brdf.h"
#include "shaders/brdf/registry.h"

namespace core {

namespace fs = std::filesystem;

namespace {

/// Identifies one state of a file.
struct Stamp {
    std::uintmax_t size = 0;
    fs::file_time_type time;
    bool operator==(const Stamp&) const = default;
};

Stamp stampOf(const std::string& path) {
    std::error_code code;
    Stamp stamp;
    stamp.size = fs::file_size(path, code);
    stamp.time = fs::last_write_time(path, code);
    return stamp;
}

std::shared_ptr<BrdfFile> makeBrdfFile(const std::string& path) {
    auto file = std::make_shared<BrdfFile>();
    file->path = path;
    file->name = fs::path(path).filename().string();
    file->info = {.id = BRDF_MEASURED,
                  .key = kFileBrdf,
                  .label = file->name.c_str(),
                  .params = {},
                  .usesAlbedo = false,
                  .usesSpecular = false,
                  .defaultFresnel = Fresnel::None};
    return file;
}

void describe(BrdfFile& file, const UserBrdf& user) {
    file.info.id = BRDF_USER;
    file.info.params = user.params;
    file.info.usesAlbedo = user.usesAlbedo;
    file.info.usesSpecular = user.usesSpecular;
    file.info.defaultFresnel = user.usesFresnel ? Fresnel::Schlick : Fresnel::None;
}

UserBrdfCheck& userBrdfCheck() {
    static UserBrdfCheck check;
    return check;
}

/// Files in use, by path.
class Cache {
  public:
    std::shared_ptr<const BrdfFile> find(const std::string& path, const Stamp& stamp) {
        const std::lock_guard lock(mutex_);
        const auto found = files_.find(path);
        return found != files_.end() && found->second.first == stamp ? found->second.second.lock() : nullptr;
    }
    void store(const std::string& path, const Stamp& stamp, const std::shared_ptr<const BrdfFile>& file) {
        const std::lock_guard lock(mutex_);
        std::erase_if(files_, [](const auto& entry) { return entry.second.second.expired(); });
        files_[path] = {stamp, file};
    }

  private:
    std::mutex mutex_;
    std::map<std::string, std::pair<Stamp, std::weak_ptr<const BrdfFile>>> files_;
};

}  // namespace

std::shared_ptr<const BrdfFile> loadBrdfFile(const std::string& path) {
    static Cache cache;
    const Stamp stamp = stampOf(path);
    if (auto known = cache.find(path, stamp)) return known;
    const std::shared_ptr<BrdfFile> file = makeBrdfFile(path);
    if (path.ends_with(kUserBrdfExtension)) {
        file->user = loadUserBrdf(path);
        describe(*file, *file->user);
        if (const UserBrdfCheck& check = userBrdfCheck()) check(file);
    } else {
        file->measured = loadMeasuredBrdf(path);
    }
    cache.store(path, stamp, file);
    return file;
}

void setUserBrdfCheck(UserBrdfCheck check) { userBrdfCheck() = std::move(check); }

std::shared_ptr<const BrdfFile> loadBrdfFileOrProblem(const std::string& path, const std::vector<std::string>& keys) {
    try {
        return loadBrdfFile(path);
    } catch (const Error& error) {
        const std::shared_ptr<BrdfFile> file = makeBrdfFile(path);
        file->problem = error.message();
        for (const std::string& key : keys) {
            if (file->unread.size() == kBrdfValueCount) break;
            const char* name = file->unreadKeys.emplace_back(key).c_str();
            file->unread.push_back({name, name, "", -kNoValue, kNoValue, kNoValue, false});
        }
        file->info.params = file->unread;
        file->info.usesAlbedo = file->info.usesSpecular = true;
        return file;
    }
}

Material fileMaterial(std::shared_ptr<const BrdfFile> file) {
    Material material = defaultMaterial(file->info);
    material.brdfFile = std::move(file);
    return material;
}

Material withReloadedFile(const Material& material, std::shared_ptr<const BrdfFile> file) {
    const std::span<const ParamInfo> before = findBrdf(material)->params;
    const Material fresh = fileMaterial(std::move(file));
    const std::span<const ParamInfo> after = findBrdf(fresh)->params;
    Material result = material;
    result.brdfFile = fresh.brdfFile;
    result.values = fresh.values;
    for (std::size_t i = 0; i < after.size(); ++i)
        for (std::size_t j = 0; j < before.size(); ++j)
            if (std::string_view(after[i].key) == before[j].key && material.values.at(j) != kNoValue)
                result.values.at(i) = std::clamp(material.values.at(j), after[i].min, after[i].max);
    return result;
}

}  // namespace core
