// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/cryptomatte.h"

#include <array>
#include <bit>
#include <cstdio>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/io/image_writer.h"

namespace core {

namespace {

constexpr const char* kTypeName = "CryptoObject";

std::string hex(std::uint32_t value) {
    std::array<char, 9> text{};
    std::snprintf(text.data(), text.size(), "%08x", value);
    return text.data();
}

}  // namespace

std::uint32_t murmurHash3(std::string_view bytes) {
    constexpr std::uint32_t c1 = 0xcc9e2d51U;
    constexpr std::uint32_t c2 = 0x1b873593U;
    const auto byte = [&](std::size_t i) { return std::uint32_t{static_cast<unsigned char>(bytes[i])}; };
    std::uint32_t h = 0;
    const std::size_t blocks = bytes.size() / 4;
    for (std::size_t i = 0; i < blocks; ++i) {
        std::uint32_t k = byte(4 * i) | byte(4 * i + 1) << 8U | byte(4 * i + 2) << 16U | byte(4 * i + 3) << 24U;
        k = std::rotl(k * c1, 15) * c2;
        h = std::rotl(h ^ k, 13) * 5 + 0xe6546b64U;
    }
    std::uint32_t tail = 0;
    for (std::size_t i = bytes.size() % 4; i > 0; --i) tail = tail << 8U | byte(4 * blocks + i - 1);
    h ^= std::rotl(tail * c1, 15) * c2;
    h ^= static_cast<std::uint32_t>(bytes.size());
    h = (h ^ h >> 16U) * 0x85ebca6bU;
    h = (h ^ h >> 13U) * 0xc2b2ae35U;
    return h ^ h >> 16U;
}

std::uint32_t cryptomatteId(std::string_view name) {
    const std::uint32_t hash = murmurHash3(name);
    const std::uint32_t exponent = hash >> 23U & 255U;
    return exponent == 0 || exponent == 255 ? hash ^ 1U << 23U : hash;
}

void saveCryptomatte(const Scene& scene, const std::string& path) {
    if (std::filesystem::path(path).extension() != ".exr")
        throw Error(ErrorKind::Usage,
                    Message("messages", "Cannot write \"%1\": a Cryptomatte is stored in a .exr file.").with(path));
    const Photo& photo = *scene.photo;
    std::map<std::uint16_t, float> ids;
    nlohmann::json manifest = nlohmann::json::object();
    for (const Segment& segment : scene.segments) {
        const std::uint32_t id = cryptomatteId(segment.name);
        ids[segment.label] = std::bit_cast<float>(id);
        manifest[segment.name] = hex(id);
    }

    OIIO::ImageSpec spec(photo.camera.width, photo.camera.height, 8, OIIO::TypeFloat);
    const std::string layer = std::string(kTypeName) + "00.";
    spec.channelnames = {"R", "G", "B", "A", layer + "r", layer + "g", layer + "b", layer + "a"};
    spec.alpha_channel = 3;
    spec["compression"] = "zip";
    spec["oiio:ColorSpace"] = "Linear";
    spec["Software"] = "Patina " PATINA_VERSION;
    const std::string key = "cryptomatte/" + hex(murmurHash3(kTypeName)).substr(0, 7) + "/";
    spec[key + "name"] = kTypeName;
    spec[key + "hash"] = "MurmurHash3_32";
    spec[key + "conversion"] = "uint32_to_float32";
    spec[key + "manifest"] = manifest.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);

    std::vector<float> pixels;
    pixels.reserve(photo.color.size() * 8);
    for (std::size_t i = 0; i < photo.color.size(); ++i) {
        const auto id = ids.find(photo.labels[i]);
        const bool covered = id != ids.end();
        const Vector3f& color = photo.color[i];
        for (const float value :
             {color.x(), color.y(), color.z(), 1.0f, covered ? id->second : 0.0f, covered ? 1.0f : 0.0f, 0.0f, 0.0f})
            pixels.push_back(value);
    }
    writeImage(path, "openexr", spec, OIIO::TypeFloat, pixels.data());
}

}  // namespace core
