// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/base/error.h"

namespace core {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void failWriting(const std::string& path, const Message& reason) {
    throw Error(ErrorKind::Output, Message("messages", "Cannot write \"%1\": %2.").with(path, reason));
}

std::string systemReason(int code) { return std::generic_category().message(code); }

/// Opens for a final fsync, which also checks that the file exists.
void flushToDisk(const std::string& path, const std::string& named) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) failWriting(named, systemReason(errno));
    const int result = ::fsync(descriptor);
    const int code = errno;
    ::close(descriptor);
    if (result != 0 && code != EINVAL) failWriting(named, systemReason(code));
}

}  // namespace

AtomicFile::AtomicFile(const std::string& target) : named_(target) {
    static std::atomic<unsigned> counter{0};
    if (target.empty()) throw Error(ErrorKind::Output, Message("messages", "Cannot write: the file name is empty."));
    std::error_code code;
    fs::path resolved(target);
    const fs::path canonical = fs::weakly_canonical(resolved, code);
    if (!code && !canonical.empty()) resolved = canonical;
    const fs::file_status status = fs::status(resolved, code);
    if (fs::is_directory(status)) failWriting(target, Message("messages", "it is a folder, expected a file"));
    if (fs::exists(status) && !fs::is_regular_file(status))
        failWriting(target, Message("messages", "it is not a regular file"));
    const fs::path folder = resolved.has_parent_path() ? resolved.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, code))
        failWriting(target, Message("messages", "the folder \"%1\" does not exist").with(folder.string()));
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        failWriting(
            target,
            Message("messages", "the folder \"%1\" is not writable (%2)").with(folder.string(), systemReason(errno)));
    target_ = resolved.string();
    const std::string unique = std::to_string(::getpid()) + "-" + std::to_string(++counter);
    std::string hidden(1, '.');
    hidden += resolved.stem().string() + "." + unique + ".part" + resolved.extension().string();
    temporary_ = (folder / hidden).string();
}

AtomicFile::~AtomicFile() {
    if (committed_) return;
    std::error_code ignored;
    fs::remove(temporary_, ignored);
}

void AtomicFile::commit() {
    struct stat existing {};
    if (::stat(target_.c_str(), &existing) == 0) ::chmod(temporary_.c_str(), existing.st_mode & 07777);
    flushToDisk(temporary_, named_);
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) failWriting(named_, systemReason(errno));
    committed_ = true;
}

void writeFileAtomically(const std::string& path, std::string_view bytes) {
    AtomicFile file(path);
    const int descriptor = ::open(file.temporaryPath().c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                                  S_IRUSR | S_IWUSR | S_IRGRP | S_IROTH);
    if (descriptor < 0) failWriting(path, systemReason(errno));
    std::size_t written = 0;
    while (written < bytes.size()) {
        const ssize_t count = ::write(descriptor, bytes.data() + written, bytes.size() - written);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) {
            const int code = errno;
            ::close(descriptor);
            failWriting(path, systemReason(code));
        }
        written += static_cast<std::size_t>(count);
    }
    if (::close(descriptor) != 0) failWriting(path, systemReason(errno));
    file.commit();
}

std::size_t checkedFileSize(const std::string& path) {
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    const auto fail = [&](const Message& reason) {
        throw Error(ErrorKind::Input, Message("messages", "Cannot read \"%1\": %2.").with(path, reason));
    };
    if (status.type() == fs::file_type::not_found) fail(Message("messages", "the file does not exist"));
    if (!fs::status_known(status)) fail(code.message());
    if (fs::is_directory(status)) fail(Message("messages", "it is a folder, expected a file"));
    if (!fs::is_regular_file(status)) fail(Message("messages", "it is not a regular file"));
    const std::uintmax_t size = fs::file_size(path, code);
    if (code) fail(code.message());
    if (size == 0) fail(Message("messages", "the file is empty (0 bytes)"));
    return static_cast<std::size_t>(size);
}

std::string readFile(const std::string& path, std::size_t limit) {
    const std::size_t size = checkedFileSize(path);
    if (size > limit)
        throw Error(
            ErrorKind::Input,
            Message("messages", "Cannot read \"%1\": it has %2 bytes, expected at most %3.").with(path, size, limit));
    std::ifstream file(path, std::ios::binary);
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!file)
        throw Error(ErrorKind::Input, Message("messages", "Cannot read \"%1\": %2.").with(path, systemReason(errno)));
    return bytes;
}

}  // namespace core
