// SPDX-License-Identifier: GPL-3.0-or-later
// The window in German. That every text of the sources is translated at all is the test `translations`.
#include <gtest/gtest.h>

#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QToolBar>
#include <QToolButton>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/notes.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "gpu/error.h"
#include "tests/ui/support.h"
#include "ui/main_window.h"
#include "ui/new_photo_dialog.h"
#include "ui/tools/tool_box.h"
#include "ui/tools/tool_registry.h"
#include "ui/translations.h"
#include "ui/words.h"

namespace {

class German : public testing::Test {
  protected:
    German() : translators_(ui::installTranslators(QLocale(QLocale::German))) {}

    /// The patterns in a message that read the same in German although they contain words.
    static std::vector<std::string> untranslated(const core::Message& message) {
        std::vector<std::string> result;
        message.visitPatterns([&](const char* context, const std::string& pattern) {
            if (pattern.find_first_of("abcdefghijklmnopqrstuvwxyz") != std::string::npos &&
                QCoreApplication::translate(context, pattern.c_str()).toStdString() == pattern)
                result.push_back(pattern);
        });
        return result;
    }

    static std::vector<std::string> untranslatedError(const std::function<void()>& act) {
        try {
            act();
        } catch (const core::Error& error) {
            return untranslated(error.message());
        }
        return {"no error"};
    }

    std::vector<std::unique_ptr<QTranslator>> translators_;
    QTemporaryDir folder_;
};

TEST_F(German, EveryTaskHasAName) {
    EXPECT_EQ(ui::taskName(core::Task::RecoverDepth), QStringLiteral("Tiefe wird bestimmt"));
    for (int task = 0; task <= static_cast<int>(core::Task::Benchmark); ++task)
        EXPECT_FALSE(ui::taskName(static_cast<core::Task>(task)).isEmpty()) << task;
}

TEST_F(German, ErrorsKeepTheirValuesAndContext) {
    const std::string path = folder_.filePath("Tisch 100%1.patina").toStdString();
    try {
        (void)core::loadProject(path);
        FAIL();
    } catch (const core::Error& error) {
        const QString expected =
            QStringLiteral("„%1“ kann nicht gelesen werden: die Datei gibt es nicht. Beim Laden von „%1“.");
        EXPECT_EQ(ui::translated(error), QString(expected).replace("%1", QString::fromStdString(path)));
        EXPECT_EQ(error.what(),
                  "Cannot read \"" + path + "\": the file does not exist. While loading \"" + path + "\".");
    }
}

TEST_F(German, ErrorsAndNotesHaveNoEnglishInThem) {
    const std::string grey = folder_.filePath("grey.png").toStdString();
    core::saveScalar(core::ImageF(8, 6, 0.5f), grey, "Y", 255);
    core::CreateOptions photograph;
    photograph.color = grey;
    const std::string project = folder_.filePath("p.patina").toStdString();
    const auto load = [&](const char* text) {
        return untranslatedError([&] {
            QFile file(QString::fromStdString(project));
            ASSERT_TRUE(file.open(QIODevice::WriteOnly));
            file.write(text);
            file.close();
            (void)core::loadProject(project);
        });
    };
    EXPECT_EQ(load("{\"format\": 3}"), std::vector<std::string>());
    EXPECT_EQ(load("{\"format\": \"patina\", \"version\": 0}"), std::vector<std::string>());
    EXPECT_EQ(load("{\"format\": \"patina\", \"version\": 1, \"photo\": {\"colour\": 1}}"), std::vector<std::string>());
    EXPECT_EQ(
        untranslatedError([&] { core::saveColor(core::ImageRgb(2, 2), folder_.filePath("x.bmp").toStdString()); }),
        std::vector<std::string>());

    core::Notes notes;
    (void)core::createScene(photograph, &notes);  // without depth
    EXPECT_GE(notes.size(), 2u);
    photograph.depth = grey;
    (void)core::createScene(photograph, &notes);
    core::Scene scene = test::makeScene();
    core::Analysis analysis = *test::makeAnalysis(scene);
    for (const core::Message& note : core::analysisNotes(scene, analysis)) notes.push_back(note);
    EXPECT_GE(notes.size(), 2u);
    for (const core::Message& note : notes) EXPECT_EQ(untranslated(note), std::vector<std::string>());
}

TEST_F(German, HintsNameTheDialogAndNoOption) {
    const core::Message message = core::Message("messages", "the depth map").about(core::Setting::DepthUnitOrKind);
    EXPECT_TRUE(ui::translated(message).contains(QStringLiteral("Tiefeneinheit")));
    EXPECT_FALSE(ui::translated(message).contains(QStringLiteral("--")));
}

TEST_F(German, StandardButtonsToo) {
    const ui::NewPhotoDialog dialog;
    QStringList texts;
    for (const QPushButton* button : dialog.findChildren<QPushButton*>()) texts << button->text().remove('&');
    EXPECT_TRUE(texts.contains(QStringLiteral("Abbrechen"))) << texts.join(' ').toStdString();
}

TEST_F(German, FailuresOfTheDeviceToo) {
    for (const gpu::ErrorKind kind : {gpu::ErrorKind::Validation, gpu::ErrorKind::OutOfMemory, gpu::ErrorKind::Internal,
                                      gpu::ErrorKind::DeviceLost, gpu::ErrorKind::NoAdapter}) {
        const gpu::Error error(kind, "Buffer \"front\" is too large.");
        const QString sentence = ui::translated(error);
        EXPECT_TRUE(sentence.contains(QStringLiteral("Grafik"))) << sentence.toStdString();
        EXPECT_TRUE(sentence.contains(QString::fromUtf8(error.what()))) << "for a report";
    }
}

/// What a bar cuts off at this width.
QStringList cutOff(QWidget& bar) {
    QStringList cut;
    for (QWidget* each : bar.findChildren<QWidget*>()) {
        if (each->objectName() == QLatin1String("qt_toolbar_ext_button")) {
            if (each->isVisible()) cut << QStringLiteral("the bar's end");
            continue;
        }
        const bool text = qobject_cast<QAbstractButton*>(each) != nullptr ||
                          qobject_cast<QComboBox*>(each) != nullptr || qobject_cast<QLabel*>(each) != nullptr ||
                          qobject_cast<QAbstractSpinBox*>(each) != nullptr;
        if (!text || !each->isVisible() || each->objectName() == QLatin1String("toolHint")) continue;
        const QRect place(each->mapTo(&bar, QPoint()), each->size());
        if (each->width() < each->minimumSizeHint().width() || !bar.rect().contains(place))
            cut << each->metaObject()->className() + QStringLiteral(" ") + each->objectName() + each->toolTip();
    }
    return cut;
}

void expectBarsFit() {
    ui::MainWindow window({.canvas = false, .device = {}});
    window.show();
    window.workspace().setDocument(core::Document(test::makeScene()));
    auto* hint = test::child<QLabel>(window, "toolHint");
    for (const int width : {1000, 1200, 1400, 1600}) {
        window.resize(width, 800);
        for (const ui::ToolEntry& entry : ui::toolRegistry()) {
            window.toolBox().choose(QString::fromUtf8(entry.key));
            QTest::qWait(1);
            EXPECT_LE(window.width(), width);
            for (const char* bar : {"toolOptions", "toolHints"}) {
                const QStringList cut = cutOff(*test::child<QToolBar>(window, bar));
                EXPECT_TRUE(cut.isEmpty()) << width << ' ' << entry.key << ": " << cut.join(", ").toStdString();
            }
            // A longer sentence ends in "…", and is whole in its tool tip.
            EXPECT_FALSE(hint->text().isEmpty());
            EXPECT_EQ(hint->toolTip(), hint->text());
            EXPECT_GE(hint->width(), 250) << width << ' ' << entry.key;
        }
    }
}

TEST_F(German, NothingInTheBarsIsCutOff) { expectBarsFit(); }

TEST(English, NothingInTheBarsIsCutOff) { expectBarsFit(); }

TEST(Style, TheActiveChoiceStandsOut) {
    QToolBar bar;
    std::array<QToolButton*, 2> buttons{};
    for (QToolButton*& button : buttons) {
        QAction* action = bar.addAction(QStringLiteral("New"));
        action->setCheckable(true);
        button = qobject_cast<QToolButton*>(bar.widgetForAction(action));
    }
    bar.show();
    const auto luminance = [](QWidget& widget) {
        const QColor color = widget.grab().toImage().pixelColor(3, widget.height() / 2);
        const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
    };
    buttons[0]->setChecked(true);
    // The contrast of WCAG 2.1; 1 = the same.
    EXPECT_GT((luminance(*buttons[0]) + 0.05) / (luminance(*buttons[1]) + 0.05), 2);
    EXPECT_EQ(buttons[0]->size(), buttons[1]->size());
}

}  // namespace
