// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace core {

/// A file being replaced: written under a temporary name in the target's folder, flushed to disk and renamed by
/// `commit`. Until then, and after any failure, the old file is untouched and the temporary one is removed.
class AtomicFile {
  public:
    /// Throws Error(Output) when the target is no regular file or its folder is missing or not writable. A symbolic
    /// link is followed: what it points at is replaced.
    explicit AtomicFile(const std::string& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where to write; keeps the target's extension.
    [[nodiscard]] const std::string& temporaryPath() const { return temporary_; }
    /// Throws Error(Output) when the disk refuses.
    void commit();

  private:
    std::string named_;  ///< as the caller spelled it, for messages
    std::string target_;
    std::string temporary_;
    bool committed_ = false;
};

/// Replaces `path` by `bytes`, atomically. Throws Error(Output).
void writeFileAtomically(const std::string& path, std::string_view bytes);

/// The whole file. Throws Error(Input) naming it when it is missing, no regular file, or larger than `limit` bytes.
[[nodiscard]] std::string readFile(const std::string& path, std::size_t limit);

/// Size in bytes of a regular file. Throws Error(Input) naming it when it is missing, something else or empty.
[[nodiscard]] std::size_t checkedFileSize(const std::string& path);

}  // namespace core
