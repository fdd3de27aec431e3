// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recent_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QSettings>
#include <QStandardPaths>
#include <algorithm>
#include <string>
#include <vector>

#include "ui/canvas/display.h"

namespace ui {

namespace {

const char* const kFilesKey = "recentFiles";
const char* const kFolderKey = "folder";
const char* const kPhotosKey = "recentPhotos";

QVariantMap settingsOf(const core::CreateOptions& options) {
    QVariantMap map;
    map[QStringLiteral("color")] = QString::fromStdString(options.color);
    map[QStringLiteral("depth")] = QString::fromStdString(options.depth);
    map[QStringLiteral("segments")] = QString::fromStdString(options.segments);
    if (options.depthKind) map[QStringLiteral("kind")] = static_cast<int>(*options.depthKind);
    if (options.depthUnit) map[QStringLiteral("unit")] = *options.depthUnit;
    if (options.hfov) map[QStringLiteral("hfov")] = *options.hfov;
    return map;
}

core::CreateOptions optionsOf(const QVariantMap& map) {
    const auto text = [&](const char* key) { return map.value(QString::fromUtf8(key)).toString().toStdString(); };
    core::CreateOptions options;
    options.color = text("color");
    options.depth = text("depth");
    options.segments = text("segments");
    bool known = false;
    const int kind = map.value(QStringLiteral("kind")).toInt(&known);
    if (known && kind >= 0 && kind <= static_cast<int>(core::DepthKind::Inverse))
        options.depthKind = static_cast<core::DepthKind>(kind);
    if (map.contains(QStringLiteral("unit"))) options.depthUnit = map.value(QStringLiteral("unit")).toDouble();
    if (map.contains(QStringLiteral("hfov"))) options.hfov = map.value(QStringLiteral("hfov")).toFloat();
    return options;
}

QString absolutePath(const QString& path) { return QFileInfo(path).absoluteFilePath(); }

QString thumbnailPath(const QString& path) {
    const QByteArray hash = QCryptographicHash::hash(absolutePath(path).toUtf8(), QCryptographicHash::Sha1).toHex();
    return QStringLiteral("%1/thumbnails/%2.png")
        .arg(QStandardPaths::writableLocation(QStandardPaths::CacheLocation), QString::fromLatin1(hash));
}

/// Keeps the first kMaxCount files, and of everything else only what belongs to them.
void store(const QStringList& files) {
    QSettings settings;
    const QStringList kept = files.mid(0, RecentFiles::kMaxCount);
    for (const QString& path : settings.value(kFilesKey).toStringList())
        if (!kept.contains(path)) QFile::remove(thumbnailPath(path));
    QVariantMap photos = settings.value(kPhotosKey).toMap();
    for (const QString& path : photos.keys())
        if (!kept.contains(path)) photos.remove(path);
    settings.setValue(kFilesKey, kept);
    settings.setValue(kPhotosKey, photos);
}

}  // namespace

QString RecentFiles::lastFolder() {
    const QString last = QSettings().value(kFolderKey).toString();
    if (!last.isEmpty() && QFileInfo(last).isDir()) return last;
    const QString pictures = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
    return QFileInfo(pictures).isDir() ? pictures : QDir::homePath();
}

QString RecentFiles::folder(const core::Document& document, bool writable) {
    std::vector<std::string> paths = {document.path()};
    if (document.scene().photo != nullptr) paths.push_back(document.scene().photo->source.color);
    for (const std::string& path : paths) {
        if (path.empty()) continue;
        const QFileInfo folder(QFileInfo(QString::fromStdString(path)).absolutePath());
        if (folder.isDir() && (!writable || folder.isWritable())) return folder.filePath();
    }
    return lastFolder();
}

QString RecentFiles::baseName(const core::Document& document) {
    if (!document.path().empty()) return QFileInfo(QString::fromStdString(document.path())).completeBaseName();
    if (document.scene().photo == nullptr) return {};
    return QFileInfo(QString::fromStdString(document.scene().photo->source.color)).completeBaseName();
}

QStringList RecentFiles::files() { return QSettings().value(kFilesKey).toStringList(); }

void RecentFiles::add(const QString& path) {
    QStringList all = files();
    const QString absolute = absolutePath(path);
    all.removeAll(absolute);
    all.prepend(absolute);
    store(all);
    QSettings().setValue(kFolderKey, QFileInfo(absolute).path());
}

void RecentFiles::addPhoto(const core::CreateOptions& options) {
    core::CreateOptions known = options;
    for (std::string* path : {&known.color, &known.depth, &known.segments})
        if (!path->empty()) *path = absolutePath(QString::fromStdString(*path)).toStdString();
    const QString color = QString::fromStdString(known.color);
    add(color);
    QSettings settings;
    QVariantMap photos = settings.value(kPhotosKey).toMap();
    photos[color] = settingsOf(known);
    settings.setValue(kPhotosKey, photos);
}

void RecentFiles::remove(const QString& path) {
    QStringList all = files();
    all.removeAll(path);
    store(all);
}

std::optional<core::CreateOptions> RecentFiles::photo(const QString& path) {
    const QVariantMap photos = QSettings().value(kPhotosKey).toMap();
    if (!photos.contains(path)) return std::nullopt;
    return optionsOf(photos.value(path).toMap());
}

QImage RecentFiles::thumbnail(const QString& path) { return QImage(thumbnailPath(path)); }

void RecentFiles::setThumbnail(const QString& path, const QImage& image) {
    const QString place = thumbnailPath(path);
    QDir().mkpath(QFileInfo(place).absolutePath());
    QSaveFile file(place);
    if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG")) return;
    file.commit();
}

QImage makeThumbnail(const core::ImageRgb& color) {
    if (color.empty()) return {};
    const int longest = std::max(color.width(), color.height());
    const int step = std::max(1, longest / (2 * kThumbnailSide));
    core::ImageRgb reduced(std::max(1, color.width() / step), std::max(1, color.height() / step));
    for (int y = 0; y < reduced.height(); ++y)
        for (int x = 0; x < reduced.width(); ++x) {
            core::Vector3f sum(0, 0, 0);
            for (int v = 0; v < step; ++v)
                for (int u = 0; u < step; ++u)
                    sum += color(std::min(x * step + u, color.width() - 1), std::min(y * step + v, color.height() - 1));
            reduced(x, y) = sum / static_cast<float>(step * step);
        }
    const QImage image = displayImage(reduced);
    if (std::max(image.width(), image.height()) <= kThumbnailSide) return image;
    return image.scaled(kThumbnailSide, kThumbnailSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

}  // namespace ui
