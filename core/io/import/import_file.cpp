// SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include "core/base/files.h"
#include "core/io/import/import_format.h"

namespace core {

ImportFile::ImportFile(std::string path) : path_(std::move(path)) {
    (void)checkedFileSize(path_);
    head_.resize(kHeadBytes);
    std::ifstream file(path_, std::ios::binary);
    file.read(head_.data(), static_cast<std::streamsize>(head_.size()));
    head_.resize(static_cast<std::size_t>(file.gcount()));
}

const std::string& ImportFile::bytes() const {
    if (bytes_.empty()) bytes_ = readFile(path_, kMaxBytes);
    return bytes_;
}

void ImportFile::fail(const Message& reason) const {
    throw Error(ErrorKind::Input, Message("messages", "Cannot read \"%1\": %2.").with(path_, reason));
}

}  // namespace core
