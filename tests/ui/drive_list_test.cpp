// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/drive_list.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>

#include "core/io/image_io.h"
#include "core/material/brdf.h"
#include "tests/ui/support.h"
#include "ui/widgets/color_button.h"

namespace {

class DriveListTest : public testing::Test {
  protected:
    DriveListTest() {
        core::Scene scene = test::makeScene();
        scene.findSegment(2)->edit = core::defaultMaterial(*core::findBrdf("artist"));
        workspace_.setDocument(core::Document(scene));
        workspace_.select(2);
    }
    static void choose(QComboBox& box, const QString& key) {
        const int index = box.findData(key);
        ASSERT_GE(index, 0) << key.toStdString();
        box.setCurrentIndex(index);
        emit box.activated(index);
    }
    void vary(const char* parameter) { choose(*test::child<QComboBox>(list_, "driveAdd"), parameter); }
    void source(const char* parameter, const QString& key) {
        choose(*test::child<QComboBox>(list_, (std::string("drive_") + parameter + "_source").c_str()), key);
    }
    [[nodiscard]] const std::vector<core::Drive>& drives() const {
        return workspace_.scene().findSegment(2)->edit->drives;
    }

    ui::Workspace workspace_;
    ui::DriveList list_{workspace_};
};

TEST_F(DriveListTest, ARowPerParameterFollowsTheDocument) {
    vary("roughness");
    ASSERT_EQ(drives().size(), 1u);
    EXPECT_EQ(drives()[0].mask->width(), 32);
    EXPECT_EQ(workspace_.paintedParameter(), "roughness") << "what is added is painted";
    EXPECT_EQ(drives()[0].from->value.x(), 0.4f) << "black leaves the edit as it is";
    auto* to = test::child<QSlider>(list_, "drive_roughness_toSlider");
    to->setValue(to->maximum());
    EXPECT_EQ(drives()[0].to->value.x(), 1.0f);
    vary("albedo");
    ASSERT_EQ(drives().size(), 2u);
    EXPECT_EQ(workspace_.paintedParameter(), "albedo");
    EXPECT_EQ(test::child<QComboBox>(list_, "driveAdd")->findData("albedo"), -1) << "one drive a parameter";

    source("albedo", "same:roughness");
    EXPECT_EQ(drives()[1].mask, drives()[0].mask);
    source("albedo", "texture");
    EXPECT_EQ(drives()[1].source, core::DriveSource::Luminance);
    EXPECT_EQ(drives()[1].mask, nullptr);
    EXPECT_FALSE(test::child<ui::ColorButton>(list_, "drive_albedo_from")->isEnabled());
    EXPECT_EQ(workspace_.paintedParameter(), "") << "texture cannot be painted";
    source("albedo", "painted");
    EXPECT_EQ(drives()[1].source, core::DriveSource::Mask);

    test::child<QCheckBox>(list_, "drive_roughness_invert")->click();
    EXPECT_TRUE(drives()[0].invert);
    test::child<QToolButton>(list_, "drive_roughness_remove")->click();
    ASSERT_EQ(drives().size(), 1u);
    workspace_.document().undo();
    EXPECT_EQ(drives().size(), 2u);
    EXPECT_TRUE(drives()[0].invert);
    workspace_.select(1);
    EXPECT_EQ(workspace_.paintedParameter(), "");
}

TEST_F(DriveListTest, LoadsMasksAndRefusesOthers) {
    const QTemporaryDir folder;
    core::ImageF values(32, 24, 51.0f);
    const QString good = folder.filePath("good.png");
    core::saveScalar(values, good.toStdString(), "Y", 257);
    const QString small = folder.filePath("small.png");
    core::saveScalar(core::ImageF(16, 12), small.toStdString(), "Y", 1);
    vary("metallic");
    list_.loadMask("metallic", good);
    ASSERT_TRUE(test::waitUntil([&] { return drives()[0].mask->path() == good.toStdString(); }, 5000));
    EXPECT_NEAR(drives()[0].mask->value(5, 5), 0.2f, 1e-4f);
    EXPECT_TRUE(test::child<QComboBox>(list_, "drive_metallic_source")->currentText().contains("good.png"));

    QSignalSpy errors(&list_, &ui::DriveList::error);
    for (const QString& path : {small, folder.filePath("none.png")}) {
        list_.loadMask("metallic", path);
        ASSERT_TRUE(test::waitUntil([&] { return !errors.isEmpty(); }, 5000));
        EXPECT_TRUE(errors.takeFirst().at(0).toString().contains(path));
        EXPECT_EQ(drives()[0].mask->path(), good.toStdString());
    }
}

}  // namespace
