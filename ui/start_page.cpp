// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start_page.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/recent_files.h"
#include "ui/samples.h"

namespace ui {

namespace {

constexpr int kPathRole = Qt::UserRole;
constexpr int kMissingRole = Qt::UserRole + 1;

/// The picture in a frame of `size`, grey for a file that is gone.
QIcon entryIcon(const QImage& picture, const QSize& size, double ratio, bool missing) {
    const QSize pixels = (QSizeF(size) * ratio).toSize();
    QImage frame(pixels, QImage::Format_RGB32);
    frame.fill(qRgb(44, 44, 44));
    if (!picture.isNull()) {
        QImage scaled = picture.scaled(pixels, Qt::KeepAspectRatio, Qt::SmoothTransformation);
        if (missing) scaled = scaled.convertToFormat(QImage::Format_Grayscale8);
        QPainter painter(&frame);
        if (missing) painter.setOpacity(0.4);
        painter.drawImage((pixels.width() - scaled.width()) / 2, (pixels.height() - scaled.height()) / 2, scaled);
    }
    QPixmap pixmap = QPixmap::fromImage(frame);
    pixmap.setDevicePixelRatio(ratio);
    QIcon icon(pixmap);
    icon.addPixmap(pixmap, QIcon::Selected);
    return icon;
}

QLabel* makeTitle(const QString& text, double scale, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setPointSizeF(font.pointSizeF() * scale);
    label->setFont(font);
    return label;
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("startPage"));
    setAccessibleName(tr("Start"));
    setAutoFillBackground(true);
    // Its width does not limit the window's, which keeps this page below the picture.
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    open_ = new QPushButton(tr("Open photo or project…"), this);
    open_->setObjectName(QStringLiteral("startOpen"));
    open_->setToolTip(tr("Photographs with depth, photographs with a depth map beside them, and projects"));
    QFont large = open_->font();
    large.setPointSizeF(large.pointSizeF() * 1.4);
    open_->setFont(large);
    const int margin = fontMetrics().height();
    open_->setStyleSheet(QStringLiteral("QPushButton { padding: %1px %2px; }").arg(margin / 2).arg(margin));
    connect(open_, &QPushButton::clicked, this, &StartPage::openPressed);
    recentTitle_ = makeTitle(tr("Recent"), 1.2, this);
    recent_ = makeList(QStringLiteral("startRecent"), tr("Recent projects and photographs"));
    recent_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(recent_, &QListWidget::customContextMenuRequested, this, [this](const QPoint& place) {
        if (recent_->itemAt(place) == nullptr) return;
        recent_->setCurrentItem(recent_->itemAt(place));
        auto* menu = new QMenu(this);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        connect(menu->addAction(tr("Remove from list")), &QAction::triggered, this, &StartPage::removeCurrent);
        menu->popup(recent_->viewport()->mapToGlobal(place));
    });
    remove_ = new QPushButton(tr("Remove from list"), this);
    remove_->setObjectName(QStringLiteral("startRemove"));
    remove_->setToolTip(tr("Forget the selected file; the file itself stays (Delete)"));
    connect(remove_, &QPushButton::clicked, this, &StartPage::removeCurrent);
    connect(recent_, &QListWidget::currentItemChanged, this, &StartPage::updateRemove);
    auto* samplesTitle = makeTitle(tr("Examples"), 1.2, this);
    samples_ = makeList(QStringLiteral("startSamples"), tr("Edited examples"));

    auto* header = new QHBoxLayout;
    header->addWidget(recentTitle_);
    header->addStretch(1);
    header->addWidget(remove_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(margin, 2 * margin, margin, margin);
    layout->setSpacing(margin / 2);
    QLabel* title = makeTitle(tr("Change what things in a photograph are made of"), 1.6, this);
    title->setWordWrap(true);
    title->setAlignment(Qt::AlignCenter);
    layout->addWidget(title);
    layout->addSpacing(margin);
    layout->addWidget(open_, 0, Qt::AlignHCenter);
    layout->addWidget(new QLabel(tr("or drop a file here"), this), 0, Qt::AlignHCenter);
    layout->addSpacing(margin);
    layout->addLayout(header);
    layout->addWidget(recent_, 2);
    layout->addWidget(samplesTitle);
    layout->addWidget(samples_, 1);
    const std::vector<Sample> samples = bundledSamples();
    for (const Sample& sample : samples)
        addEntry(*samples_, sample.project, sample.title, sample.project, QImage(sample.picture));
    samplesTitle->setVisible(!samples.empty());
    samples_->setVisible(!samples.empty());
    setFocusProxy(open_);
    refresh();
}

QListWidget* StartPage::makeList(const QString& key, const QString& name) {
    auto* list = new QListWidget(this);
    list->setObjectName(key);
    list->setAccessibleName(name);
    list->setViewMode(QListView::IconMode);
    list->setMovement(QListView::Static);
    list->setResizeMode(QListView::Adjust);
    list->setUniformItemSizes(true);
    list->setWordWrap(true);
    list->setTextElideMode(Qt::ElideMiddle);
    list->setFrameShape(QFrame::NoFrame);
    list->viewport()->setAutoFillBackground(false);
    list->installEventFilter(this);
    fitIcons(*list);
    connect(list, &QListWidget::itemClicked, this, [this, list](QListWidgetItem* item) { activate(*list, item); });
    return list;
}

void StartPage::fitIcons(QListWidget& list) {
    const int unit = list.fontMetrics().height();
    list.setIconSize(QSize(12 * unit, 8 * unit));
    list.setGridSize(QSize(14 * unit, 12 * unit));
    list.setMinimumHeight(12 * unit);
}

void StartPage::addEntry(QListWidget& list, const QString& path, const QString& title, const QString& toolTip,
                         const QImage& picture) {
    const bool missing = !QFileInfo::exists(path);
    auto* item = new QListWidgetItem(entryIcon(picture, list.iconSize(), devicePixelRatioF(), missing), title, &list);
    item->setToolTip(toolTip);
    item->setData(kPathRole, path);
    item->setData(kMissingRole, missing);
    item->setData(Qt::AccessibleTextRole, title);
    item->setData(Qt::AccessibleDescriptionRole, toolTip);
    if (missing) item->setForeground(palette().color(QPalette::Disabled, QPalette::Text));
}

void StartPage::refresh() {
    recent_->clear();
    for (const QString& path : RecentFiles::files()) {
        const QFileInfo file(path);
        // The grid has room for two lines: a name, and for a file that is gone why it is grey.
        QString title = file.fileName();
        QString toolTip = path;
        if (!file.exists()) {
            const bool folder = QFileInfo::exists(file.absolutePath());
            title += QLatin1Char('\n') + tr("not found");
            toolTip = (folder ? tr("%1 is no longer in its folder: it was moved, renamed or deleted.")
                              : tr("The folder of %1 cannot be found: it was moved, or its disk is not connected."))
                          .arg(path);
        }
        addEntry(*recent_, path, title, toolTip, RecentFiles::thumbnail(path));
    }
    const bool any = recent_->count() > 0;
    recentTitle_->setVisible(any);
    recent_->setVisible(any);
    updateRemove();
}

void StartPage::activate(QListWidget& list, QListWidgetItem* item) {
    if (item == nullptr) return;
    const QString path = item->data(kPathRole).toString();
    if (!QFileInfo::exists(path)) {
        // It stays where it is, grey, for the user to remove.
        if (!item->data(kMissingRole).toBool()) refresh();
        return;
    }
    if (&list == recent_)
        emit recentChosen(path);
    else
        emit sampleChosen(path);
}

void StartPage::removeCurrent() {
    const QListWidgetItem* item = recent_->currentItem();
    if (item == nullptr) return;
    const int row = recent_->row(item);
    RecentFiles::remove(item->data(kPathRole).toString());
    refresh();
    recent_->setCurrentRow(std::min(row, recent_->count() - 1));
    emit recentRemoved();
}

void StartPage::updateRemove() {
    remove_->setVisible(recent_->count() > 0);
    remove_->setEnabled(recent_->currentItem() != nullptr);
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    auto& list = *static_cast<QListWidget*>(watched);
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Return:
        case Qt::Key_Enter:
        case Qt::Key_Space:
            activate(list, list.currentItem());
            return true;
        case Qt::Key_Delete:
            if (&list == recent_) removeCurrent();
            return true;
        default:
            return QWidget::eventFilter(watched, event);
    }
}

void StartPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() != QEvent::FontChange || samples_ == nullptr) return;
    for (QListWidget* list : {recent_, samples_}) fitIcons(*list);
}

}  // namespace ui
