// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/image.h"
#include "core/io/project.h"
#include "core/scene/document.h"

namespace ui {

/// Projects and photographs that were opened lately, the last one first, in the user's settings. For each a small
/// picture is kept in the user's cache.
class RecentFiles {
  public:
    static constexpr int kMaxCount = 12;

    /// Absolute paths.
    [[nodiscard]] static QStringList files();
    /// Puts a project first.
    static void add(const QString& path);
    /// Puts a photograph first, and remembers with what it was opened.
    static void addPhoto(const core::CreateOptions& options);
    /// Forgets a file and its picture; the file itself stays.
    static void remove(const QString& path);
    /// Where a dialog for files starts: the folder of the document's file, of its photograph, or the one used last.
    /// With `writable`, the first of them that can be written to.
    [[nodiscard]] static QString folder(const core::Document& document, bool writable = false);
    /// The folder that was used last; by default the one for pictures.
    [[nodiscard]] static QString lastFolder();
    /// The name of the document's photograph, or of the project, without folder and ending; "" without a photograph.
    [[nodiscard]] static QString baseName(const core::Document& document);

    /// With what a photograph was opened; nullopt = `path` is a project.
    [[nodiscard]] static std::optional<core::CreateOptions> photo(const QString& path);

    /// The picture of a file; null = there is none.
    [[nodiscard]] static QImage thumbnail(const QString& path);
    /// Keeps the picture of a file, the latest one. From any thread. A cache that cannot be written is no error.
    static void setThumbnail(const QString& path, const QImage& image);
};

/// A photograph, scene-linear, as a picture of at most kThumbnailSide pixels.
[[nodiscard]] QImage makeThumbnail(const core::ImageRgb& color);
inline constexpr int kThumbnailSide = 320;

}  // namespace ui
