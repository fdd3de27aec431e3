// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/notice_button.h"

#include <QFrame>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>

namespace ui {

namespace {
constexpr int kListWidth = 460;
constexpr int kMaxListHeight = 420;
}  // namespace

NoticeButton::NoticeButton(QWidget* parent) : QToolButton(parent) {
    setObjectName(QStringLiteral("notices"));
    setAccessibleName(tr("Notices"));
    setToolTip(tr("What was found in the files and assumed by the analysis"));
    setAutoRaise(true);
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setIcon(style()->standardIcon(QStyle::SP_MessageBoxInformation));
    connect(this, &QToolButton::clicked, this, &NoticeButton::showList);
    refresh();
}

QStringList NoticeButton::notices() const {
    QStringList all;
    for (const QStringList& sentences : notices_) all += sentences;
    return all;
}

int NoticeButton::unread() const {
    const QStringList all = notices();
    return static_cast<int>(
        std::ranges::count_if(all, [this](const QString& sentence) { return !read_.contains(sentence); }));
}

void NoticeButton::setNotices(const QString& subject, const QStringList& sentences) {
    notices_[subject] = sentences;
    const QStringList all = notices();
    read_.removeIf([&](const QString& sentence) { return !all.contains(sentence); });
    refresh();
}

void NoticeButton::refresh() {
    const int fresh = unread();
    const int count = static_cast<int>(notices().size());
    setVisible(count > 0);
    if (fresh > 0)
        setText(fresh == 1 ? tr("1 new notice") : tr("%1 new notices").arg(fresh));
    else
        setText(count == 1 ? tr("1 notice") : tr("%1 notices").arg(count));
    QFont bold = font();
    bold.setBold(fresh > 0);
    setFont(bold);
}

void NoticeButton::showList() {
    if (notices().isEmpty()) return;
    delete list_;
    list_ = new QFrame(this, Qt::Popup);
    list_->setObjectName(QStringLiteral("noticeList"));
    list_->setFrameShape(QFrame::StyledPanel);
    auto* content = new QWidget;
    auto* rows = new QVBoxLayout(content);
    for (const QString& sentence : notices()) {
        auto* row = new QLabel(sentence, content);
        row->setWordWrap(true);
        row->setTextFormat(Qt::PlainText);
        row->setTextInteractionFlags(Qt::TextSelectableByMouse);
        QFont bold = row->font();
        bold.setBold(!read_.contains(sentence));
        row->setFont(bold);
        rows->addWidget(row);
    }
    rows->addStretch(1);
    auto* scroll = new QScrollArea(list_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    auto* layout = new QVBoxLayout(list_);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(scroll);
    const int height = std::min(rows->heightForWidth(kListWidth - 24) + 8, kMaxListHeight);
    list_->resize(kListWidth, height);
    const QRect space = screen()->availableGeometry();
    QPoint place = mapToGlobal(QPoint(width() - kListWidth, -height));
    place.setX(std::clamp(place.x(), space.left(), std::max(space.left(), space.right() - kListWidth)));
    place.setY(std::max(place.y(), space.top()));
    list_->move(place);
    list_->show();
    read_ = notices();
    refresh();
}

}  // namespace ui
