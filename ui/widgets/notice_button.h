// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QStringList>
#include <QToolButton>

class QFrame;

namespace ui {

/// What the user should read, kept until it is read and beyond: a button that counts what is new, and opens the list.
/// Hidden while there is nothing.
class NoticeButton : public QToolButton {
    Q_OBJECT
  public:
    explicit NoticeButton(QWidget* parent = nullptr);

    /// Replaces the notices about one subject; those that were read before stay read.
    void setNotices(const QString& subject, const QStringList& sentences);
    /// All of them, in the order in which they are listed.
    [[nodiscard]] QStringList notices() const;
    [[nodiscard]] int unread() const;

  public slots:
    /// Opens the list; everything in it counts as read from then on.
    void showList();

  private:
    void refresh();

    QMap<QString, QStringList> notices_;  ///< by subject
    QStringList read_;
    QFrame* list_ = nullptr;
};

}  // namespace ui
