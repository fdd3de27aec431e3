// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/import/lzf.h"

namespace core {

std::optional<std::string> lzfDecompress(std::string_view block, std::size_t size) {
    if (size / kLzfMaxRatio > block.size()) return std::nullopt;
    std::string out;
    out.reserve(size);
    std::size_t at = 0;
    const auto next = [&]() -> std::size_t { return static_cast<unsigned char>(block[at++]); };
    while (at < block.size()) {
        const std::size_t control = next();
        if (control < 32) {
            const std::size_t count = control + 1;
            if (count > block.size() - at || count > size - out.size()) return std::nullopt;
            out.append(block, at, count);
            at += count;
            continue;
        }
        std::size_t count = control >> 5U;
        if (block.size() - at < (count == 7 ? 2U : 1U)) return std::nullopt;
        if (count == 7) count += next();
        count += 2;
        const std::size_t distance = ((control & 31U) << 8U) + next() + 1;
        if (distance > out.size() || count > size - out.size()) return std::nullopt;
        // The copy may overlap what it writes: a run repeats itself.
        for (std::size_t i = 0; i < count; ++i) out.push_back(out[out.size() - distance]);
    }
    if (out.size() != size) return std::nullopt;
    return out;
}

}  // namespace core
