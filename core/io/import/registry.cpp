// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "core/io/import/import_format.h"

namespace core {

std::span<const ImportFormat* const> importFormats() {
#define PATINA_ADDRESS(format) &format,
    static constexpr std::array kFormats{PATINA_IMPORT_FORMATS(PATINA_ADDRESS)};
#undef PATINA_ADDRESS
    return kFormats;
}

const ImportFormat* findImportFormat(const ImportFile& file) {
    for (const ImportFormat* format : importFormats())
        if (format->recognises(file)) return format;
    return nullptr;
}

}  // namespace core
