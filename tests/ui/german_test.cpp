// SPDX-License-Identifier: GPL-3.0-or-later
// The window in German. That every text of the sources is translated at all is the test `translations`.
#include <gtest/gtest.h>

#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/analysis/notes.h"
#include "core/io/image_io.h"
#include "core/io/project.h"
#include "tests/ui/support.h"
#include "ui/new_photo_dialog.h"
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

}  // namespace
