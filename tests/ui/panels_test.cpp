// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QtTest/qtestspontaneevent.h>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QToolButton>
#include <QTreeView>
#include <QWheelEvent>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/io/image_io.h"
#include "core/material/brdf_file.h"
#include "core/material/metals.h"
#include "core/material/translucency.h"
#include "core/scene/segments.h"
#include "tests/support/merl_file.h"
#include "tests/support/other_value.h"
#include "tests/support/temp_folder.h"
#include "tests/support/user_brdf_text.h"
#include "tests/ui/support.h"
#include "ui/panels/back_side_panel.h"
#include "ui/panels/environment_panel.h"
#include "ui/panels/material_panel.h"
#include "ui/panels/registry.h"
#include "ui/panels/render_panel.h"
#include "ui/panels/segments_panel.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/map_view.h"
#include "ui/widgets/param_control.h"
#include "ui/widgets/param_slider.h"
#include "ui/widgets/profile_view.h"
#include "ui/workspace.h"

namespace {

class Panels : public testing::Test {
  protected:
    void open() { workspace_.setDocument(core::Document(test::makeScene())); }
    const core::Segment& segment(std::uint16_t label) { return *workspace_.scene().findSegment(label); }
    /// As a user does: the combo box shows the entry and says so.
    static void choose(QComboBox& box, int index) {
        ASSERT_GE(index, 0);
        box.setCurrentIndex(index);
        emit box.activated(index);
    }
    void chooseBrdf(ui::MaterialPanel& panel, const char* key) {
        auto* box = test::child<QComboBox>(panel, "materialBrdf");
        choose(*box, box->findData(QString::fromUtf8(key)));
    }

    ui::Workspace workspace_;
};

TEST_F(Panels, EveryPanelLivesWithoutADocumentAndNamesItsControls) {
    for (const ui::PanelEntry& entry : ui::panelRegistry()) {
        const std::unique_ptr<ui::Panel> panel(entry.make(workspace_, nullptr));
        EXPECT_FALSE(entry.translatedTitle().isEmpty());
        for (const QWidget* widget : panel->findChildren<QWidget*>()) {
            const bool control = qobject_cast<const QAbstractButton*>(widget) != nullptr ||
                                 qobject_cast<const QComboBox*>(widget) != nullptr ||
                                 qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
                                 qobject_cast<const QAbstractSlider*>(widget) != nullptr;
            if (!control || widget->objectName().startsWith("qt_")) continue;
            const auto* bar = qobject_cast<const QScrollBar*>(widget);
            if (bar != nullptr) continue;
            EXPECT_FALSE(widget->objectName().isEmpty()) << entry.key << ": " << widget->metaObject()->className();
            EXPECT_FALSE(widget->toolTip().isEmpty()) << entry.key << ": " << widget->objectName().toStdString();
        }
    }
}

TEST_F(Panels, SegmentListShowsAndEditsFlagsAndNames) {
    ui::SegmentsPanel panel(workspace_);
    open();
    auto* list = test::child<QTreeView>(panel, "segmentList");
    QAbstractItemModel& model = *list->model();
    ASSERT_EQ(model.rowCount(), 2);
    const QModelIndex name = model.index(1, 0), glossy = model.index(1, 1);
    EXPECT_EQ(name.data().toString(), "card");
    model.setData(glossy, Qt::Checked, Qt::CheckStateRole);
    EXPECT_TRUE(segment(2).glossy);
    model.setData(name, QStringLiteral("badge"), Qt::EditRole);
    EXPECT_EQ(segment(2).name, "badge");
    workspace_.document().undo();
    EXPECT_EQ(name.data().toString(), "card");
    EXPECT_EQ(glossy.data(Qt::CheckStateRole).toInt(), Qt::Checked);
    workspace_.document().undo();
    EXPECT_EQ(glossy.data(Qt::CheckStateRole).toInt(), Qt::Unchecked);
}

TEST_F(Panels, SegmentNamesStayUniqueAndNeverEmpty) {
    ui::SegmentsPanel panel(workspace_);
    open();
    QSignalSpy messages(&panel, &ui::Panel::message);
    QAbstractItemModel& model = *test::child<QTreeView>(panel, "segmentList")->model();
    model.setData(model.index(1, 0), QStringLiteral("wall"), Qt::EditRole);
    model.setData(model.index(1, 0), QStringLiteral("   "), Qt::EditRole);
    EXPECT_EQ(messages.size(), 2);
    EXPECT_EQ(segment(2).name, "card");
    EXPECT_EQ(model.index(1, 0).data().toString(), "card");
    EXPECT_FALSE(workspace_.document().canUndo());
}

TEST_F(Panels, SelectionGoesBothWays) {
    ui::SegmentsPanel panel(workspace_);
    open();
    auto* list = test::child<QTreeView>(panel, "segmentList");
    list->setCurrentIndex(list->model()->index(1, 0));
    EXPECT_EQ(workspace_.selectedLabel(), 2);
    workspace_.select(1);
    EXPECT_EQ(list->currentIndex().row(), 0);
    workspace_.select(77);
    EXPECT_EQ(workspace_.selectedLabel(), 0);
    EXPECT_FALSE(list->currentIndex().isValid());
}

TEST_F(Panels, MaterialControlsComeFromTheTableOfEachBrdf) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    for (const core::BrdfInfo& info : core::brdfs()) {
        chooseBrdf(panel, info.key);
        ASSERT_TRUE(segment(2).edit.has_value());
        EXPECT_EQ(segment(2).edit->brdf, info.key);
        EXPECT_EQ(segment(2).edit->fresnel, info.defaultFresnel);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        for (std::size_t i = 0; i < info.params.size(); ++i) {
            const core::ParamInfo& param = info.params[i];
            auto* slider = test::child<ui::ParamSlider>(panel, param.key);
            EXPECT_NEAR(slider->value(), static_cast<double>(param.initial), 1e-6);
            test::child<QSlider>(*slider, (std::string(param.key) + "Slider").c_str())->setValue(1000);
            EXPECT_NEAR(segment(2).edit->values[i], param.max, 1e-3f * param.max);
        }
    }
    chooseBrdf(panel, "");
    EXPECT_FALSE(segment(2).edit.has_value());
}

TEST_F(Panels, TheOldMaterialComesBackWithItsPaintedMask) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    chooseBrdf(panel, "phong");
    const auto mask = std::make_shared<core::Mask>(32, 24);
    workspace_.editSelected("paint", [&](core::Segment& s) {
        s.edit->values[0] = 77;
        core::Drive& drive = s.edit->drives.emplace_back();
        drive.parameter = "exponent";
        drive.mask = mask;
    });
    const core::Material painted = *segment(2).edit;
    chooseBrdf(panel, "lambert");
    ASSERT_EQ(segment(2).edit->brdf, "lambert");
    EXPECT_TRUE(segment(2).edit->drives.empty());
    workspace_.editSelected("colour", [&](core::Segment& s) { s.edit->albedo = {1, 0, 0}; });
    chooseBrdf(panel, "ggx");
    chooseBrdf(panel, "phong");
    EXPECT_EQ(segment(2).edit->drives, painted.drives);
    EXPECT_EQ(segment(2).edit->values, painted.values);
    EXPECT_EQ(segment(2).edit->albedo, core::Vector3f(1, 0, 0)) << "common to all: the latest";

    chooseBrdf(panel, "");
    EXPECT_FALSE(segment(2).edit.has_value());
    chooseBrdf(panel, "phong");
    ASSERT_TRUE(segment(2).edit.has_value());
    EXPECT_EQ(segment(2).edit->drives, painted.drives) << "also after the segment was as photographed";
    const std::uint64_t before = workspace_.document().revision();
    chooseBrdf(panel, "phong");
    EXPECT_EQ(workspace_.document().revision(), before) << "the same again is no step";

    for (const char* brdf : {"", "phong", "ggx", "lambert"}) {
        workspace_.document().undo();
        EXPECT_EQ(segment(2).edit ? segment(2).edit->brdf : "", brdf);
        if (std::string(brdf) == "lambert") break;
    }
    workspace_.document().undo();  // the colour
    workspace_.document().undo();
    EXPECT_EQ(*segment(2).edit, painted);

    workspace_.select(1);
    chooseBrdf(panel, "phong");
    EXPECT_TRUE(segment(1).edit->drives.empty()) << "another segment has its own";

    core::BinaryMask corner(32, 24);
    corner(0, 0) = 1;
    workspace_.editScene(
        "delete", [](core::Scene& scene) { scene = core::deleteSegments(scene, std::vector<std::uint16_t>{2}); });
    workspace_.editScene("new", [&](core::Scene& scene) { scene = core::withSegment(scene, corner, "2"); });
    workspace_.select(2);
    chooseBrdf(panel, "phong");
    EXPECT_TRUE(segment(2).edit->drives.empty()) << "another segment with the same label";
    open();
    workspace_.select(2);
    chooseBrdf(panel, "phong");
    EXPECT_TRUE(segment(2).edit->drives.empty()) << "another document";
}

TEST_F(Panels, ANewMaterialStartsWithTheObjectsOwnColour) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.setAnalysis(test::makeAnalysis(workspace_.scene()));  // lit by 0.5 from everywhere
    workspace_.select(1);
    chooseBrdf(panel, "lambert");
    EXPECT_LT((segment(1).edit->albedo - core::Vector3f(0.4f, 0.6f, 0.8f)).norm(), 0.02f)
        << segment(1).edit->albedo.transpose();
    workspace_.select(2);
    chooseBrdf(panel, "lambert");
    EXPECT_NEAR(segment(2).edit->albedo.x(), 0.9f, 1e-4f) << "brighter than white";
    EXPECT_NEAR(segment(2).edit->albedo.y() / segment(2).edit->albedo.x(), 0.5f / 0.8f, 1e-3f);
}

TEST_F(Panels, AColourIsPickedFromThePicture) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.setAnalysis(test::makeAnalysis(workspace_.scene()));
    workspace_.select(2);
    chooseBrdf(panel, "ggx");
    auto* pick = test::child<QToolButton>(panel, "materialAlbedoPick");
    pick->click();
    EXPECT_TRUE(workspace_.picking());
    EXPECT_TRUE(pick->isChecked());
    workspace_.finishPicking(2, 2);  // on the wall
    EXPECT_FALSE(workspace_.picking());
    EXPECT_FALSE(pick->isChecked());
    EXPECT_LT((segment(2).edit->albedo - core::Vector3f(0.4f, 0.6f, 0.8f)).norm(), 0.02f);
    EXPECT_EQ(workspace_.document().undoLabel(), "Pick diffuse colour");
    auto* specular = test::child<QToolButton>(panel, "materialSpecularPick");
    specular->click();
    pick->click();
    EXPECT_TRUE(pick->isChecked());
    EXPECT_FALSE(specular->isChecked()) << "one at a time";
    workspace_.select(1);
    EXPECT_FALSE(workspace_.picking()) << "another segment";
}

TEST_F(Panels, TheWheelScrollsAndChangesNothing) {
    open();
    workspace_.editScene("edit", [](core::Scene& scene) {
        scene.segments[1].glossy = true;
        scene.segments[1].edit = core::defaultMaterial(*core::findBrdf("ggx"));
        scene.segments[1].edit->translucency.emplace();
        scene.environment.image = std::make_shared<core::ImageRgb>(16, 8, core::Vector3f(1, 1, 1));
    });
    workspace_.select(2);
    const std::uint64_t revision = workspace_.document().revision();
    int controls = 0;
    for (const ui::PanelEntry& entry : ui::panelRegistry()) {
        QScrollArea area;
        area.setWidget(entry.make(workspace_, nullptr));
        area.setWidgetResizable(true);
        area.resize(300, 120);
        area.show();
        QCoreApplication::processEvents();
        if (QWidget* first = area.focusWidget()) first->clearFocus();  // by which a window begins
        // Only a wheel of the user's is passed on to what is around a widget.
        const auto turn = [](QWidget& widget, int angle) {
            const QPointF middle(widget.rect().center());
            QWheelEvent wheel(middle, widget.mapToGlobal(middle), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                              Qt::NoScrollPhase, false);
            QSpontaneKeyEvent::setSpontaneous(&wheel);
            qApp->notify(&widget, &wheel);
        };
        for (QWidget* widget : area.widget()->findChildren<QWidget*>()) {
            const auto* box = qobject_cast<QComboBox*>(widget);
            const auto* spin = qobject_cast<QDoubleSpinBox*>(widget);
            const auto* slider = qobject_cast<QSlider*>(widget);
            if ((box == nullptr && spin == nullptr && slider == nullptr) || !widget->isEnabled()) continue;
            area.ensureWidgetVisible(widget);
            const auto value = [&]() -> double {
                return box != nullptr ? box->currentIndex() : spin != nullptr ? spin->value() : slider->value();
            };
            ++controls;
            EXPECT_NE(widget->focusPolicy(), Qt::WheelFocus) << widget->objectName().toStdString();
            const double before = value();
            for (const int angle : {120, -120, -120}) turn(*widget, angle);
            EXPECT_EQ(value(), before) << widget->objectName().toStdString();
            EXPECT_FALSE(widget->hasFocus()) << widget->objectName().toStdString();
        }
        QScrollBar& bar = *area.verticalScrollBar();
        for (QWidget* widget : area.widget()->findChildren<QDoubleSpinBox*>()) {
            if (!widget->isVisible() || bar.maximum() == 0) continue;
            area.ensureWidgetVisible(widget);
            bar.setValue(std::min(bar.value(), bar.maximum() - 1));
            const int before = bar.value();
            turn(*widget, -120);
            EXPECT_GT(bar.value(), before) << "the panel is scrolled instead";
            break;
        }
    }
    EXPECT_GT(controls, 30);
    EXPECT_EQ(workspace_.document().revision(), revision);
}

TEST_F(Panels, AMaterialComesFromAFileAndFollowsIt) {
    const test::TempFolder folder;
    const std::string path = folder / "grey.binary";
    test::writeMerl(path, [](double, double, double) { return core::Vector3f(0.1f, 0.1f, 0.1f); });
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    QSignalSpy errors(&panel, &ui::Panel::error);
    panel.loadBrdf(QString::fromStdString(folder / "missing.binary"));
    ASSERT_TRUE(errors.wait(5000));
    EXPECT_TRUE(errors[0][0].toString().contains("missing.binary"));
    EXPECT_FALSE(segment(2).edit.has_value());

    panel.loadBrdf(QString::fromStdString(path));
    ASSERT_TRUE(QTest::qWaitFor([&] { return segment(2).edit.has_value(); }, 5000));
    const auto first = segment(2).edit->brdfFile;
    ASSERT_NE(first, nullptr);
    auto* combo = test::child<QComboBox>(panel, "materialBrdf");
    EXPECT_EQ(combo->currentData().toString(), "file");
    auto* label = test::child<QLabel>(panel, "materialFile");
    EXPECT_EQ(label->text(), "grey.binary");

    // A file that is broken while it is in use: said, and the last state stays.
    std::filesystem::resize_file(path, 100);
    ASSERT_TRUE(QTest::qWaitFor([&] { return label->text().contains("100 bytes"); }, 5000));
    EXPECT_EQ(segment(2).edit->brdfFile, first);
    test::writeMerl(path, [](double, double, double) { return core::Vector3f(0.2f, 0.1f, 0.1f); });
    ASSERT_TRUE(QTest::qWaitFor([&] { return segment(2).edit->brdfFile != first; }, 5000));
    EXPECT_EQ(label->text(), "grey.binary");
    workspace_.document().undo();
    workspace_.document().undo();
    EXPECT_FALSE(segment(2).edit.has_value());
}

TEST_F(Panels, ABrdfByTheUserHasItsSlidersAndFollowsItsFile) {
    const test::TempFolder folder;
    const std::string path = folder / "gloss.brdf.glsl";
    const std::string gloss = "uniform float gloss = 0.25;  // 0 to 1, \"How glossy\"\n";
    test::writeBytes(path, gloss + test::kMattBrdf);
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    panel.loadBrdf(QString::fromStdString(path));
    ASSERT_TRUE(QTest::qWaitFor([&] { return segment(2).edit.has_value(); }, 5000));
    auto* slider = test::child<ui::ParamSlider>(panel, "gloss");
    EXPECT_NEAR(slider->value(), 0.25, 1e-6);
    test::child<QSlider>(*slider, "glossSlider")->setValue(1000);
    EXPECT_EQ(segment(2).edit->values[0], 1);

    // Another parameter while it is in use; what stays keeps its value.
    test::writeBytes(path, "uniform float depth = 3.0;  // 1 to 9\n" + gloss + test::kMattBrdf);
    ASSERT_TRUE(QTest::qWaitFor([&] { return segment(2).edit->values[1] == 1; }, 5000));
    EXPECT_EQ(segment(2).edit->values[0], 3);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    EXPECT_NEAR(test::child<ui::ParamSlider>(panel, "depth")->value(), 3, 1e-6);
    EXPECT_NEAR(test::child<ui::ParamSlider>(panel, "gloss")->value(), 1, 1e-6);

    // Refused by the reader, then by the check.
    const auto usable = segment(2).edit->brdfFile;
    auto* label = test::child<QLabel>(panel, "materialFile");
    test::writeBytes(path, test::evaluating("for (;;"));
    ASSERT_TRUE(QTest::qWaitFor([&] { return label->text().contains("gloss.brdf.glsl:2: "); }, 5000));
    EXPECT_EQ(segment(2).edit->brdfFile, usable);
    core::setUserBrdfCheck([](const std::shared_ptr<const core::BrdfFile>& file) {
        throw core::Error(core::ErrorKind::Input, file->path + ":77: It glows.");
    });
    test::writeBytes(path, test::kMattBrdf);
    EXPECT_TRUE(QTest::qWaitFor([&] { return label->text().contains(":77: It glows."); }, 5000));
    core::setUserBrdfCheck({});
    EXPECT_EQ(segment(2).edit->brdfFile, usable);
}

TEST_F(Panels, AFileThatIsMissingIsUsedWhenItComes) {
    const test::TempFolder folder;
    const std::string path = folder / "late.brdf.glsl";
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    workspace_.editSelected("Edit", [&](core::Segment& segment) {
        segment.edit = core::fileMaterial(core::loadBrdfFileOrProblem(path, {"gloss"}));
        segment.edit->values[0] = 0.75f;
    });
    auto* label = test::child<QLabel>(panel, "materialFile");
    EXPECT_TRUE(label->text().startsWith("Shown as photographed"));
    EXPECT_FALSE(core::usable(*segment(2).edit));
    test::writeBytes(folder / "other.brdf.glsl", test::kMattBrdf);

    test::writeBytes(path, std::string("uniform float gloss = 0.25;  // 0 to 1\n") + test::kMattBrdf);
    ASSERT_TRUE(QTest::qWaitFor([&] { return core::usable(*segment(2).edit); }, 5000));
    EXPECT_EQ(label->text(), "late.brdf.glsl");
    EXPECT_EQ(segment(2).edit->values[0], 0.75f) << "what the project said";
}

TEST_F(Panels, AMetalSetsIndexAndExtinction) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    chooseBrdf(panel, "ggx");
    auto* fresnel = test::child<QComboBox>(panel, "materialFresnel");
    fresnel->setCurrentIndex(fresnel->findData(static_cast<int>(core::Fresnel::Conductor)));
    emit fresnel->activated(fresnel->currentIndex());
    auto* metal = test::child<QComboBox>(panel, "materialMetal");
    EXPECT_EQ(metal->currentIndex(), 0);
    metal->setCurrentIndex(metal->findData(QStringLiteral("copper")));
    emit metal->activated(metal->currentIndex());
    ASSERT_NE(core::metalOf(*segment(2).edit), nullptr);
    EXPECT_STREQ(core::metalOf(*segment(2).edit)->key, "copper");
    test::child<QDoubleSpinBox>(panel, "materialKR")->setValue(5);
    EXPECT_EQ(metal->currentIndex(), 0) << "other numbers are no listed metal";
}

TEST_F(Panels, DraggingASliderIsOneUndoStep) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    chooseBrdf(panel, "phong");
    auto* slider = test::child<QSlider>(panel, "exponentSlider");
    const float before = segment(2).edit->values[0];
    for (int position = 300; position < 320; ++position) slider->setValue(position);
    emit slider->sliderReleased();
    workspace_.document().undo();
    EXPECT_EQ(segment(2).edit->values[0], before);
    workspace_.document().undo();
    EXPECT_FALSE(segment(2).edit.has_value());
    EXPECT_FALSE(workspace_.document().canUndo());
}

TEST_F(Panels, EstimatedSpecularShowsTheReflectance) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.setAnalysis(test::makeAnalysis(workspace_.scene()));
    workspace_.select(2);
    chooseBrdf(panel, "phong");
    auto* estimated = test::child<QCheckBox>(panel, "materialSpecularEstimated");
    EXPECT_TRUE(estimated->isChecked());
    EXPECT_EQ(test::child<ui::ColorButton>(panel, "materialSpecular")->color(), core::Vector3f(0.25f, 0.5f, 0.75f));
    estimated->click();
    ASSERT_TRUE(segment(2).edit->specular.has_value());
    EXPECT_EQ(*segment(2).edit->specular, core::Vector3f(0.25f, 0.5f, 0.75f));
    estimated->click();
    EXPECT_FALSE(segment(2).edit->specular.has_value());
}

TEST_F(Panels, TranslucencyPresetFillsTheCoefficients) {
    ui::MaterialPanel panel(workspace_);
    open();
    workspace_.select(2);
    chooseBrdf(panel, "lambert");
    auto* group = test::child<QGroupBox>(panel, "translucency");
    group->setChecked(true);
    emit group->clicked(true);
    ASSERT_TRUE(segment(2).edit->translucency.has_value());
    for (const core::TranslucencyPreset& preset : core::translucencyPresets()) {
        auto* box = test::child<QComboBox>(panel, "translucencyPreset");
        choose(*box, box->findData(QString::fromUtf8(preset.key)));
        EXPECT_EQ(segment(2).edit->translucency->preset, preset.key);
        EXPECT_EQ(segment(2).edit->translucency->sigmaA.x(), preset.sigmaA[0]);
        EXPECT_EQ(segment(2).edit->translucency->sigmaSPrime.z(), preset.sigmaSPrime[2]);
    }
    EXPECT_EQ(test::child<QLabel>(panel, "translucencyFreePathUnit")->text(), "mm");
    EXPECT_EQ(test::child<QLabel>(panel, "translucencySigmaAUnit")->text(), "1/mm");
    test::child<QDoubleSpinBox>(panel, "translucencySigmaAG")->setValue(0.5);
    EXPECT_EQ(segment(2).edit->translucency->sigmaA.y(), 0.5f);
    EXPECT_TRUE(segment(2).edit->translucency->preset.empty());
    group->setChecked(false);
    emit group->clicked(false);
    EXPECT_FALSE(segment(2).edit->translucency.has_value());
}

TEST_F(Panels, BackSideIsInMillimetresAndPreviewed) {
    ui::BackSidePanel panel(workspace_);
    open();
    workspace_.select(2);
    auto* method = test::child<QComboBox>(panel, "backSideMethod");
    choose(*method, method->findData(static_cast<int>(core::BackSideMethod::Offset)));
    EXPECT_EQ(segment(2).backSide.method, core::BackSideMethod::Offset);
    test::child<QDoubleSpinBox>(panel, "backSideOffsetSpin")->setValue(20);
    EXPECT_NEAR(segment(2).backSide.offset, 0.02f, 1e-7f);
    EXPECT_EQ(test::child<ui::ProfileView>(panel, "backSideProfile")->maxThickness(), 0);
    workspace_.setAnalysis(test::makeAnalysis(workspace_.scene()));
    EXPECT_NEAR(test::child<ui::ProfileView>(panel, "backSideProfile")->maxThickness(), 0.1f, 1e-6f);
}

TEST_F(Panels, SmoothingFollowsTheNoiseOrTheUser) {
    ui::BackSidePanel panel(workspace_);
    open();
    auto* automatic = test::child<QCheckBox>(panel, "smoothingAutomatic");
    auto* slider = test::child<ui::ParamSlider>(panel, "smoothing");
    EXPECT_FALSE(automatic->isEnabled()) << "nothing is selected";
    workspace_.select(2);
    EXPECT_TRUE(automatic->isEnabled());
    EXPECT_TRUE(automatic->isChecked());
    EXPECT_FALSE(slider->isEnabled());
    auto analysis = std::make_shared<core::Analysis>(*test::makeAnalysis(workspace_.scene()));
    analysis->smoothing[2] = 7.5f;
    workspace_.setAnalysis(analysis);
    EXPECT_EQ(slider->value(), 7.5) << "what the noise asks for is shown";

    automatic->click();
    EXPECT_EQ(segment(2).smoothing, 7.5f);
    EXPECT_TRUE(slider->isEnabled());
    test::child<QDoubleSpinBox>(panel, "smoothingSpin")->setValue(12);
    EXPECT_EQ(segment(2).smoothing, 12.0f);
    EXPECT_FALSE(segment(1).smoothing.has_value());
    workspace_.document().undo();
    EXPECT_EQ(segment(2).smoothing, 7.5f);
    EXPECT_EQ(slider->value(), 7.5);
    workspace_.document().undo();
    EXPECT_FALSE(segment(2).smoothing.has_value());
    EXPECT_TRUE(automatic->isChecked());
    EXPECT_FALSE(slider->isEnabled());

    workspace_.document().redo();
    automatic->click();
    EXPECT_FALSE(segment(2).smoothing.has_value());
    workspace_.editScene("off", [](core::Scene& scene) { scene.depthFilter.enabled = false; });
    EXPECT_FALSE(automatic->isEnabled()) << "without the depth filter nothing is smoothed";
}

TEST_F(Panels, EnvironmentShowsMapsAndReflectance) {
    ui::EnvironmentPanel panel(workspace_);
    open();
    auto* map = test::child<ui::MapView>(panel, "environmentView");
    EXPECT_TRUE(map->image().isNull());
    workspace_.editScene("flag", [](core::Scene& scene) { scene.segments[1].glossy = true; });
    workspace_.setAnalysis(test::makeAnalysis(workspace_.scene()));
    EXPECT_FALSE(map->image().isNull());
    auto* which = test::child<QComboBox>(panel, "environmentMap");
    which->setCurrentIndex(1);
    EXPECT_TRUE(map->image().isNull());
    workspace_.select(2);
    EXPECT_FALSE(map->image().isNull());
    EXPECT_TRUE(test::child<QLabel>(panel, "reflectanceValue")->text().contains("0.250, 0.500, 0.750"));
    test::child<QCheckBox>(panel, "reflectanceAutomatic")->click();
    ASSERT_TRUE(segment(2).reflectance.has_value());
    EXPECT_EQ(*segment(2).reflectance, core::Vector3f(0.25f, 0.5f, 0.75f));
    for (const char* name : {"environmentRotation", "environmentScale"}) {
        EXPECT_FALSE(test::child<ui::ParamSlider>(panel, name)->isEnabled()) << "would change nothing";
        EXPECT_TRUE(test::child<QSlider>(panel, (std::string(name) + "Slider").c_str())
                        ->toolTip()
                        .contains(QStringLiteral("Load an environment map")));
    }
    workspace_.editScene("map", [](core::Scene& scene) {
        scene.environment.path = "map.exr";
        scene.environment.image = std::make_shared<core::ImageRgb>(16, 8, core::Vector3f(1, 1, 1));
    });
    EXPECT_TRUE(test::child<ui::ParamSlider>(panel, "environmentScale")->isEnabled());
    EXPECT_FALSE(test::child<QSlider>(panel, "environmentScaleSlider")
                     ->toolTip()
                     .contains(QStringLiteral("Load an environment map")));
    test::child<QDoubleSpinBox>(panel, "environmentRotationSpin")->setValue(90);
    EXPECT_NEAR(workspace_.scene().environment.rotation, std::numbers::pi_v<float> / 2, 1e-5f);
}

TEST_F(Panels, EnvironmentFileIsLoadedInTheBackgroundAndChecked) {
    ui::EnvironmentPanel panel(workspace_);
    open();
    const QTemporaryDir folder;
    const QString good = folder.filePath("light.exr");
    core::saveColor(core::ImageRgb(16, 8, core::Vector3f(1, 2, 3)), good.toStdString());
    panel.loadEnvironment(good);
    ASSERT_TRUE(test::waitUntil([&] { return workspace_.scene().environment.image != nullptr; }, 5000));
    EXPECT_EQ(workspace_.scene().environment.path, good.toStdString());
    QSignalSpy errors(&panel, &ui::Panel::error);
    const QString square = folder.filePath("square.exr");
    core::saveColor(core::ImageRgb(8, 8, core::Vector3f(1, 1, 1)), square.toStdString());
    panel.loadEnvironment(square);
    ASSERT_TRUE(test::waitUntil([&] { return errors.size() == 1; }, 5000));
    EXPECT_TRUE(errors[0][0].toString().contains("8x8"));
    panel.loadEnvironment(folder.filePath("missing.exr"));
    ASSERT_TRUE(test::waitUntil([&] { return errors.size() == 2; }, 5000));
    EXPECT_TRUE(errors[1][0].toString().contains("missing.exr"));
    EXPECT_EQ(workspace_.scene().environment.path, good.toStdString());
    test::child<QPushButton>(panel, "recoverEnvironment")->click();
    EXPECT_EQ(workspace_.scene().environment.image, nullptr);
}

TEST_F(Panels, RenderingNumbersReachTheScene) {
    ui::RenderPanel panel(workspace_);
    EXPECT_FALSE(panel.isEnabled());
    open();
    EXPECT_TRUE(panel.isEnabled());
    test::child<QDoubleSpinBox>(panel, "renderSamples")->setValue(7);
    test::child<QDoubleSpinBox>(panel, "renderBounces")->setValue(2);
    test::child<QCheckBox>(panel, "renderFilter")->click();
    EXPECT_FALSE(test::child<ui::ParamSlider>(panel, "depthFilterSpatialSigma")->isEnabled()) << "automatic at first";
    test::child<QCheckBox>(panel, "depthFilterAutomatic")->click();
    EXPECT_FALSE(workspace_.scene().depthFilter.automatic);
    EXPECT_TRUE(test::child<ui::ParamSlider>(panel, "depthFilterSpatialSigma")->isEnabled());
    test::child<QCheckBox>(panel, "depthFilterEnabled")->click();
    EXPECT_EQ(workspace_.scene().render.samples, 7);
    EXPECT_EQ(workspace_.scene().render.bounces, 2);
    EXPECT_FALSE(workspace_.scene().render.filter);
    EXPECT_FALSE(workspace_.scene().depthFilter.enabled);
    EXPECT_FALSE(test::child<ui::ParamSlider>(panel, "depthFilterSpatialSigma")->isEnabled());
}

/// Sets the control of a parameter to `value` as a user would.
void setControl(QWidget& panel, const core::ParamRow& row, const QString& name, const core::ParamValue& value) {
    const auto child = [&]<class T>(const QString& suffix = {}) {
        return test::child<T>(panel, (name + suffix).toUtf8().constData());
    };
    if (row.automatic) child.operator()<QCheckBox>(QStringLiteral("Automatic"))->click();
    if (std::holds_alternative<bool>(row.initial)) {
        child.operator()<QCheckBox>()->click();
    } else if (!row.words.empty()) {
        auto* box = child.operator()<QComboBox>();
        emit box->activated(box->findData(QVariant::fromValue<qlonglong>(std::get<std::int64_t>(value))));
    } else if (const auto* color = std::get_if<core::Vector3f>(&value)) {
        auto* button = child.operator()<ui::ColorButton>();
        emit button->colorChanged(*color);
    } else {
        const bool slider = row.slider.min < row.slider.max;
        child.operator()<QDoubleSpinBox>(slider ? QStringLiteral("Spin") : QString())
            ->setValue(core::toNumber(value) * row.unit.factor);
    }
}

TEST_F(Panels, EveryParameterHasItsControl) {
    open();
    workspace_.select(2);
    std::vector<std::unique_ptr<QWidget>> panels;
    for (const ui::PanelEntry& entry : ui::panelRegistry()) panels.emplace_back(entry.make(workspace_, nullptr));
    const auto check = [&](const core::ParamRow& row, const auto& current) {
        if (row.group == core::ParamGroup::None) return;
        SCOPED_TRACE(row.key);
        // Enables all controls.
        workspace_.editScene("prepare", [](core::Scene& scene) {
            scene.segments[1].glossy = true;
            scene.segments[1].backSide.method = core::BackSideMethod::Automatic;
            scene.depthFilter = {};
            scene.environment.image = std::make_shared<core::ImageRgb>(4, 2);
        });
        const QString name = ui::ParamControl(row).name();
        QWidget* owner = nullptr;
        for (const auto& panel : panels)
            if (panel->findChild<QWidget*>(name) != nullptr) owner = panel.get();
        ASSERT_NE(owner, nullptr);
        const core::ParamValue wanted = test::otherValue(row, current());
        setControl(*owner, row, name, wanted);
        if (std::holds_alternative<core::Vector3f>(wanted)) {
            EXPECT_EQ(current(), wanted);
        } else {
            EXPECT_NEAR(core::toNumber(current()), core::toNumber(wanted), 2e-3 * std::abs(core::toNumber(wanted)));
        }
    };
    for (const core::SegmentParam& param : core::segmentParams()) check(param, [&] { return param.get(segment(2)); });
    for (const core::SceneParam& param : core::sceneParams())
        check(param, [&] { return param.get(workspace_.scene()); });
}

TEST_F(Panels, AVariationThatIsAddedIsInView) {
    open();
    workspace_.select(2);
    ui::MaterialPanel panel(workspace_);
    panel.resize(320, 420);
    panel.show();
    chooseBrdf(panel, "artist");
    auto* add = test::child<QComboBox>(panel, "driveAdd");
    for (const char* parameter : {"roughness", "albedo"}) {
        const int index = add->findData(QString::fromUtf8(parameter));
        if (index < 0) continue;
        choose(*add, index);
        QTest::qWait(50);
        auto* source = test::child<QComboBox>(panel, (std::string("drive_") + parameter + "_source").c_str());
        EXPECT_FALSE(source->visibleRegion().isEmpty()) << parameter;
    }
    // What is removed leaves no room behind.
    auto* scroll = panel.findChild<QScrollArea*>();
    auto* remove = test::child<QToolButton>(panel, "drive_albedo_remove");
    const int with = scroll->verticalScrollBar()->maximum();
    const int width = panel.minimumSizeHint().width();
    QTest::mouseClick(remove, Qt::LeftButton);
    QTest::qWait(50);
    EXPECT_LT(scroll->verticalScrollBar()->maximum(), with);
    chooseBrdf(panel, "");
    QTest::qWait(50);
    EXPECT_FALSE(scroll->verticalScrollBar()->isVisible());
    EXPECT_EQ(panel.minimumSizeHint().width(), width) << "as wide as with a material";
}

}  // namespace
