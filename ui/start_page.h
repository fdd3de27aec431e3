// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace ui {

/// What the window shows while nothing is open: a button to open something, the recent files and the samples.
class StartPage : public QWidget {
    Q_OBJECT
  public:
    explicit StartPage(QWidget* parent = nullptr);

    /// Lists the recent files again. Files that are gone are grey and say so.
    void refresh();

  signals:
    void openPressed();
    /// A file that exists when it is chosen.
    void recentChosen(const QString& path);
    void sampleChosen(const QString& project);
    /// A file is no longer among the recent ones.
    void recentRemoved();

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    QListWidget* makeList(const QString& key, const QString& name);
    void fitIcons(QListWidget& list);
    void addEntry(QListWidget& list, const QString& path, const QString& title, const QString& toolTip,
                  const QImage& picture);
    void activate(QListWidget& list, QListWidgetItem* item);
    void removeCurrent();
    void updateRemove();

    QPushButton* open_ = nullptr;
    QLabel* recentTitle_ = nullptr;
    QListWidget* recent_ = nullptr;
    QPushButton* remove_ = nullptr;
    QListWidget* samples_ = nullptr;
};

}  // namespace ui
