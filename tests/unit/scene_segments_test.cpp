// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/segments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "core/base/error.h"
#include "core/scene/mask.h"
#include "core/scene/masks.h"
#include "core/scene/segment_areas.h"

namespace {

using core::MaskUse;
using testing::HasSubstr;
using Mask = core::BinaryMask;
using Labels = std::vector<std::uint16_t>;

/// 4x1 pixels: label 3 ("pot", edited), 3, 7, none.
core::Scene fourPixels() {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(4, 1);
    photo->labels(0, 0) = photo->labels(1, 0) = 3;
    photo->labels(2, 0) = 7;
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    scene.findSegment(std::uint16_t{3})->name = "pot";
    scene.findSegment(std::uint16_t{3})->edit.emplace();
    return scene;
}

Mask pixels(std::initializer_list<int> selected) {
    Mask mask(4, 1);
    for (const int x : selected) mask(x, 0) = 1;
    return mask;
}

TEST(WithSegment, ANewNameGetsTheFirstFreeLabel) {
    const core::Scene before = fourPixels();
    core::Scene scene = core::withSegment(before, pixels({1, 3}), "lid");
    ASSERT_NE(scene.findSegment("lid"), nullptr);
    EXPECT_EQ(scene.findSegment("lid")->label, 1);
    EXPECT_EQ(scene.photo->labels(0, 0), 3);
    EXPECT_EQ(scene.photo->labels(1, 0), 1);
    EXPECT_EQ(scene.photo->labels(3, 0), 1);
    EXPECT_TRUE(scene.findSegment("pot")->edit);
    EXPECT_EQ(before.photo->labels(1, 0), 3) << "the old scene is untouched";
}

TEST(WithSegment, AnExistingOneBecomesTheSelectionAndKeepsItsEdit) {
    for (const char* name : {"pot", "3", "03"}) {
        core::Scene scene = core::withSegment(fourPixels(), pixels({1, 3}), name);
        EXPECT_EQ(scene.segments.size(), 2U);
        EXPECT_EQ(scene.photo->labels(0, 0), 0);
        EXPECT_EQ(scene.photo->labels(3, 0), 3);
        EXPECT_TRUE(scene.findSegment("pot")->edit);
    }
}

TEST(WithSegment, ANumberIsALabel) {
    core::Scene scene = core::withSegment(fourPixels(), pixels({3}), "65535");
    EXPECT_EQ(scene.photo->labels(3, 0), 65535);
    EXPECT_EQ(scene.findSegment(std::uint16_t{65535})->name, "segment 65535");
}

TEST(WithSegment, WhatIsCoveredGoesUnlessItIsEdited) {
    core::Notes notes;
    core::Scene scene = core::withSegment(fourPixels(), pixels({2, 3}), "lid", &notes);
    EXPECT_EQ(scene.findSegment(std::uint16_t{7}), nullptr);
    EXPECT_EQ(notes.size(), 1U);
    EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({0, 1}), "lid"), core::Error);
}

TEST(WithSegment, RefusesWhatMakesNoSegment) {
    EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({}), "lid"), core::Error);
    for (const char* name : {"", "0", "65536", "99999999999999999999"})
        EXPECT_THROW((void)core::withSegment(fourPixels(), pixels({3}), name), core::Error) << name;
}

/// Every label is one pixel.
core::Scene allLabels() {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(65536, 1);
    for (int x = 0; x < 65536; ++x) photo->labels(x, 0) = static_cast<std::uint16_t>(x);
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    return scene;
}

TEST(WithSegment, SaysWhenAllLabelsAreTaken) {
    const core::Scene scene = allLabels();
    Mask mask(65536, 1);
    mask(0, 0) = 1;
    EXPECT_THROW((void)core::withSegment(scene, mask, "one more"), core::Error);
    EXPECT_EQ(core::withSegment(scene, mask, "12").photo->labels(0, 0), 12);
}

/// The English sentence of the error; "" = none.
template <class Act>
std::string refusal(const Act& act) {
    try {
        (void)act();
    } catch (const core::Error& error) {
        EXPECT_EQ(error.kind(), core::ErrorKind::Usage);
        return error.what();
    }
    return {};
}

/// A scene from rows of digits; segments are called "s1" ... .
core::Scene sceneOf(const std::vector<std::string>& rows) {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (std::size_t i = 0; i < photo->labels.size(); ++i)
        photo->labels[i] = static_cast<std::uint16_t>(rows[i / rows[0].size()][i % rows[0].size()] - '0');
    photo->source.segments = "labels.png";
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    for (core::Segment& segment : scene.segments) segment.name = "s" + std::to_string(segment.label);
    return scene;
}

core::Segment& segmentOf(core::Scene& scene, int label) {
    core::Segment* segment = scene.findSegment(static_cast<std::uint16_t>(label));
    if (segment == nullptr) throw std::logic_error("no segment " + std::to_string(label));
    return *segment;
}

void giveMaterial(core::Scene& scene, int label, float albedo) {
    core::Segment& segment = segmentOf(scene, label);
    segment.edit.emplace();
    segment.edit->albedo = {albedo, 0, 0};
    core::Drive& drive = segment.edit->drives.emplace_back();
    drive.parameter = "albedo";
    auto mask = std::make_shared<core::Mask>(scene.photo->labels.width(), scene.photo->labels.height());
    mask->change(0, 0, 2, 2, [](int x, int y, float) { return 0.25f * static_cast<float>(x + y); });
    drive.mask = mask;
}

std::vector<std::string> rowsOf(const core::Scene& scene) {
    const core::LabelImage& labels = scene.photo->labels;
    std::vector<std::string> rows(static_cast<std::size_t>(labels.height()));
    for (std::size_t i = 0; i < labels.size(); ++i)
        rows[i / static_cast<std::size_t>(labels.width())] += static_cast<char>('0' + labels[i]);
    return rows;
}

Mask maskOf(const std::vector<std::string>& rows) {
    const core::Scene scene = sceneOf(rows);
    Mask mask(scene.photo->labels.width(), scene.photo->labels.height());
    for (std::size_t i = 0; i < mask.size(); ++i) mask[i] = static_cast<std::uint8_t>(scene.photo->labels[i]);
    return mask;
}

/// What every change keeps: one segment for each label that occurs, sorted, unique names, masks that fit.
void expectWhole(const core::Scene& scene) {
    std::set<std::uint16_t> present(scene.photo->labels.pixels().begin(), scene.photo->labels.pixels().end());
    present.erase(0);
    Labels labels;
    std::set<std::string> names;
    for (const core::Segment& segment : scene.segments) {
        labels.push_back(segment.label);
        EXPECT_TRUE(names.insert(segment.name).second) << segment.name;
    }
    EXPECT_EQ(labels, Labels(present.begin(), present.end()));
    EXPECT_NO_THROW(core::requireMasksFit(scene));
}

/// Random labels 0 to 4 on 9x7 pixels; 2 and 4 may be locked, 1 has a material.
core::Scene randomScene(std::mt19937& random) {
    std::vector<std::string> rows(7, std::string(9, '0'));
    for (std::string& row : rows)
        for (char& pixel : row) pixel = static_cast<char>('0' + random() % 5);
    rows[0].replace(0, 5, "01234");
    core::Scene scene = sceneOf(rows);
    giveMaterial(scene, 1, 0.5f);
    segmentOf(scene, 2).locked = random() % 2 == 0;
    segmentOf(scene, 4).locked = random() % 2 == 0;
    return scene;
}

Mask randomMask(std::mt19937& random, std::uint32_t percent) {
    Mask mask(9, 7);
    for (std::uint8_t& pixel : mask.pixels()) pixel = random() % 100 < percent ? 1 : 0;
    return mask;
}

TEST(CombineSegment, AgreesWithItsDefinitionAtEveryPixel) {
    std::mt19937 random(1);
    int changes = 0, refusals = 0;
    for (int round = 0; round < 2000; ++round) {
        core::Scene before = randomScene(random);
        const Mask mask = randomMask(random, std::array{1U, 20U, 60U, 97U}[static_cast<std::size_t>(round % 4)]);
        const auto label = static_cast<std::uint16_t>(1 + random() % 4);
        const auto use = static_cast<MaskUse>(random() % 4);
        core::LabelImage expected = before.photo->labels;
        bool common = false, free = false, any = false;
        for (std::size_t i = 0; i < mask.size(); ++i) {
            const std::uint16_t old = before.photo->labels[i];
            const bool lockedPixel = old != 0 && segmentOf(before, old).locked, selected = mask[i] != 0;
            any = any || selected;
            common = common || (selected && old == label);
            free = free || (selected && !lockedPixel);
            switch (use) {
                case MaskUse::Replace:
                    expected[i] = selected && !lockedPixel ? label : old == label ? 0 : old;
                    break;
                case MaskUse::Add:
                    expected[i] = selected && !lockedPixel ? label : old;
                    break;
                case MaskUse::TakeFrom:
                    expected[i] = old == label && selected ? 0 : old;
                    break;
                case MaskUse::Intersect:
                    expected[i] = old == label && !selected ? 0 : old;
                    break;
            }
        }
        const bool takes = use == MaskUse::TakeFrom || use == MaskUse::Intersect;
        const bool editLost = std::ranges::count(expected.pixels(), 1) == 0;
        const bool refused = !any || segmentOf(before, label).locked || (takes ? !common : !free) || editLost;
        core::Notes notes;
        core::Scene after;
        const std::string sentence =
            refusal([&] { return after = core::combineSegment(before, label, mask, use, &notes); });
        EXPECT_EQ(!sentence.empty(), refused) << sentence;
        if (refused) {
            ++refusals;
            continue;
        }
        ++changes;
        ASSERT_EQ(after.photo->labels, expected) << "round " << round;
        expectWhole(after);
        EXPECT_EQ(segmentOf(after, 1).edit, segmentOf(before, 1).edit);
        EXPECT_EQ(after.photo == before.photo, expected == before.photo->labels) << "nothing changed: the same photo";
        EXPECT_EQ(after.photo->source.segments.empty(), expected != before.photo->labels);
        EXPECT_TRUE(after.photo->color.shares(before.photo->color));
    }
    EXPECT_GT(changes, 500);
    EXPECT_GT(refusals, 200);
}

TEST(CombineSegment, LockedPixelsStayAndAreNamed) {
    core::Scene scene = sceneOf({"1230"});
    segmentOf(scene, 2).locked = true;
    core::Notes notes;
    EXPECT_EQ(rowsOf(core::combineSegment(scene, 1, maskOf({"0110"}), MaskUse::Add, &notes))[0], "1210");
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_THAT(notes[0].english(), HasSubstr("\"s2\" is locked"));
    EXPECT_THAT(notes[1].english(), HasSubstr("\"s3\" is gone"));
    EXPECT_THAT(refusal([&] { return core::combineSegment(scene, 1, maskOf({"0100"}), MaskUse::Add); }),
                HasSubstr("\"s2\" is locked"));
    EXPECT_THAT(refusal([&] { return core::combineSegment(scene, 2, maskOf({"0001"}), MaskUse::Add); }),
                HasSubstr("\"s2\" is locked"));
    EXPECT_THAT(refusal([&] { return core::withSegment(scene, maskOf({"0001"}), "s2"); }),
                HasSubstr("\"s2\" is locked"));
    EXPECT_EQ(rowsOf(core::withSegment(scene, maskOf({"0111"}), "lid"))[0], "1244");
    EXPECT_THAT(refusal([&] { return core::withSegment(scene, maskOf({"0100"}), "lid"); }),
                HasSubstr("\"s2\" is locked"));
    EXPECT_NE(refusal([&] { return core::combineSegment(scene, 9, maskOf({"0001"}), MaskUse::Add); }), "");
}

TEST(MergeSegments, TheFirstKeepsNameEditAndFlags) {
    core::Scene scene = sceneOf({"1234", "1230"});
    giveMaterial(scene, 2, 0.2f);
    giveMaterial(scene, 3, 0.3f);
    segmentOf(scene, 2).glossy = true;
    core::Notes notes;
    core::Scene merged = core::mergeSegments(scene, Labels{2, 1, 3, 1}, &notes);
    EXPECT_EQ(rowsOf(merged), (std::vector<std::string>{"2224", "2220"}));
    EXPECT_EQ(segmentOf(merged, 2), segmentOf(scene, 2));
    expectWhole(merged);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].english(), "The material of \"s3\" is gone: \"s2\" keeps its own.");
    EXPECT_NE(refusal([&] { return core::mergeSegments(scene, Labels{2}); }), "");
    EXPECT_NE(refusal([&] { return core::mergeSegments(scene, Labels{2, 2}); }), "");
    EXPECT_NE(refusal([&] { return core::mergeSegments(scene, Labels{}); }), "");
    EXPECT_NE(refusal([&] { return core::mergeSegments(scene, Labels{2, 9}); }), "");
}

TEST(MergeSegments, LockedOnesStayAsTheyAre) {
    core::Scene scene = sceneOf({"1234"});
    segmentOf(scene, 3).locked = true;
    core::Notes notes;
    EXPECT_EQ(rowsOf(core::mergeSegments(scene, Labels{1, 2, 3}, &notes))[0], "1134");
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), HasSubstr("\"s3\" is locked"));
    EXPECT_THAT(refusal([&] { return core::mergeSegments(scene, Labels{1, 3}); }), HasSubstr("\"s3\" is locked"));
    EXPECT_THAT(refusal([&] { return core::mergeSegments(scene, Labels{3, 1}); }), HasSubstr("\"s3\" is locked"));
}

TEST(DeleteSegments, LeavesNoPixel) {
    core::Scene scene = sceneOf({"1234", "1034"});
    giveMaterial(scene, 1, 0.2f);
    segmentOf(scene, 4).locked = true;
    core::Notes notes;
    const core::Scene after = core::deleteSegments(scene, Labels{1, 3, 4}, &notes);
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"0204", "0004"}));
    expectWhole(after);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), HasSubstr("\"s4\" is locked"));
    EXPECT_THAT(refusal([&] { return core::deleteSegments(scene, Labels{4}); }), HasSubstr("\"s4\" is locked"));
    EXPECT_TRUE(core::deleteSegments(sceneOf({"11"}), Labels{1}).segments.empty());
    EXPECT_EQ(rowsOf(core::deleteSegments(sceneOf({"10"}), Labels{1}))[0], "00") << "a segment of one pixel";
}

TEST(DuplicateSegment, TakesTheSelectionWithEverythingElse) {
    core::Scene scene = sceneOf({"1123", "1003"});
    giveMaterial(scene, 1, 0.2f);
    segmentOf(scene, 1).glossy = true;
    segmentOf(scene, 1).name = "pot";
    core::Scene after = core::duplicateSegment(scene, 1, maskOf({"0110", "0110"}));
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"1443", "1443"}));
    core::Segment expected = segmentOf(scene, 1);
    expected.label = 4;
    expected.name = "pot 2";
    EXPECT_EQ(segmentOf(after, 4), expected);
    expectWhole(after);
    after = core::duplicateSegment(after, 4, maskOf({"0010", "0000"}));
    EXPECT_EQ(segmentOf(after, 2).name, "pot 3") << "label 2 had become free";
    EXPECT_NE(refusal([&] {
                  return core::duplicateSegment(scene, 1, maskOf({"1100", "1000"}));
              }),
              "")
        << "the edited one would be empty";
    EXPECT_NE(refusal([&] { return core::duplicateSegment(scene, 1, maskOf({"0000", "0000"})); }), "");
}

/// The 4-connected piece of each pixel, by flooding; -1 where the label is another.
std::vector<int> floodedPieces(const core::LabelImage& labels, std::uint16_t label) {
    std::vector<int> piece(labels.size(), -1);
    int count = 0;
    for (std::size_t start = 0; start < labels.size(); ++start) {
        if (labels[start] != label || piece[start] >= 0) continue;
        std::vector<std::size_t> open{start};
        piece[start] = count;
        while (!open.empty()) {
            const auto x = static_cast<int>(open.back()) % labels.width(),
                       y = static_cast<int>(open.back()) / labels.width();
            open.pop_back();
            for (const auto& [u, v] : {std::pair{x - 1, y}, {x + 1, y}, {x, y - 1}, {x, y + 1}}) {
                if (!labels.contains(u, v) || labels(u, v) != label) continue;
                const std::size_t next = labels.index(u, v);
                if (piece[next] >= 0) continue;
                piece[next] = count;
                open.push_back(next);
            }
        }
        ++count;
    }
    return piece;
}

/// What splitting means, straight from its definition: for each pixel of the label the rank of its piece.
std::vector<int> expectedPieces(const core::LabelImage& labels, std::uint16_t label) {
    const std::vector<int> piece = floodedPieces(labels, label);
    const int count = *std::ranges::max_element(piece) + 1;
    std::vector<std::size_t> pixels(static_cast<std::size_t>(count));
    for (const int p : piece)
        if (p >= 0) ++pixels[static_cast<std::size_t>(p)];
    std::vector<int> order(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) order[static_cast<std::size_t>(i)] = i;
    std::ranges::stable_sort(order, std::greater(), [&](int p) { return pixels[static_cast<std::size_t>(p)]; });
    std::map<int, int> rank;
    for (int i = 0; i < count; ++i) rank[order[static_cast<std::size_t>(i)]] = i;
    const auto speck = [&](int p) { return rank[p] > 0 && pixels[static_cast<std::size_t>(p)] < core::kSmallestPiece; };
    std::map<int, int> target;
    for (int p = 0; p < count; ++p) {
        target[p] = rank[p];
        if (!speck(p)) continue;
        int nearest = 1 << 30;
        for (const int q : order) {
            if (speck(q)) continue;
            int distance = 1 << 30;
            for (std::size_t a = 0; a < piece.size(); ++a)
                for (std::size_t b = 0; b < piece.size(); ++b) {
                    if (piece[a] != p || piece[b] != q) continue;
                    const auto w = static_cast<std::size_t>(labels.width());
                    distance = std::min(distance, std::abs(static_cast<int>(a % w) - static_cast<int>(b % w)) +
                                                      std::abs(static_cast<int>(a / w) - static_cast<int>(b / w)));
                }
            if (distance < nearest) target[p] = rank[q];
            nearest = std::min(nearest, distance);
        }
    }
    std::vector<int> result;
    for (const int p : piece) result.push_back(p < 0 ? -1 : target[p]);
    return result;
}

TEST(SplitSegment, AgreesWithItsDefinitionAtEveryPixel) {
    std::mt19937 random(2);
    int splits = 0, specks = 0;
    for (int round = 0; round < 300; ++round) {
        auto photo = std::make_shared<core::Photo>();
        photo->labels = core::LabelImage(22, 17, 0);
        for (std::uint16_t& pixel : photo->labels.pixels())
            pixel = random() % 100 < std::array{45U, 60U, 20U}[static_cast<std::size_t>(round % 3)] ? 1 : 0;
        // Larger areas beside the noise.
        for (int area = 0; area < 3; ++area) {
            const int x0 = static_cast<int>(random() % 18), y0 = static_cast<int>(random() % 13);
            for (int y = y0; y < y0 + 4; ++y)
                for (int x = x0; x < x0 + 4; ++x) photo->labels(x, y) = area == 2 ? 7 : 1;
        }
        core::Scene scene;
        scene.photo = photo;
        core::addMissingSegments(scene);
        giveMaterial(scene, 1, 0.3f);
        segmentOf(scene, 1).name = "cups";
        const std::vector<int> expected = expectedPieces(photo->labels, 1);
        const int count = *std::ranges::max_element(expected) + 1;
        const std::vector<int> flooded = floodedPieces(photo->labels, 1);
        specks += *std::ranges::max_element(flooded) + 1 - count;
        EXPECT_EQ(core::segmentPieces(photo->labels, 1, false).count, static_cast<std::size_t>(count));
        if (count == 1) {
            EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 1); }), HasSubstr("in one piece"));
            continue;
        }
        ++splits;
        core::Scene after = core::splitSegment(scene, 1);
        expectWhole(after);
        std::vector<int> labelOf{1};
        for (int label = 2; static_cast<int>(labelOf.size()) < count; ++label)
            if (label != 7) labelOf.push_back(label);
        for (std::size_t i = 0; i < expected.size(); ++i)
            ASSERT_EQ(after.photo->labels[i],
                      expected[i] < 0 ? photo->labels[i] : labelOf[static_cast<std::size_t>(expected[i])])
                << "round " << round << " pixel " << i;
        EXPECT_EQ(segmentOf(after, 1).name, "cups");
        EXPECT_EQ(segmentOf(after, 2).name, "cups 2");
        for (const int label : labelOf) EXPECT_EQ(segmentOf(after, label).edit, segmentOf(scene, 1).edit);
    }
    EXPECT_GT(splits, 150);
    EXPECT_GT(specks, 1000);
}

TEST(SplitSegment, RefusesLockedOnesAndOnePixel) {
    core::Scene scene = sceneOf({"1011", "2000"});
    EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 1); }), HasSubstr("in one piece")) << "specks";
    EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 2); }), HasSubstr("in one piece"));
    segmentOf(scene, 1).locked = true;
    EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 1); }), HasSubstr("is locked"));
}

TEST(SegmentExtents, AreThoseOfThePixels) {
    std::mt19937 random(3);
    for (int round = 0; round < 100; ++round) {
        const core::Scene scene = randomScene(random);
        const core::LabelImage& labels = scene.photo->labels;
        const auto extents = core::segmentExtents(labels);
        for (std::uint16_t label = 1; label < 6; ++label) {
            core::SegmentExtent expected;
            for (int y = 0; y < labels.height(); ++y)
                for (int x = 0; x < labels.width(); ++x) {
                    if (labels(x, y) != label) continue;
                    if (expected.pixels++ == 0) expected = {.pixels = 1, .x0 = x, .y0 = y, .x1 = x, .y1 = y};
                    expected.x0 = std::min(expected.x0, x);
                    expected.x1 = std::max(expected.x1, x);
                    expected.y1 = y;
                }
            expected.hash = extents[label].hash;
            EXPECT_EQ(extents[label], expected);
        }
        core::LabelImage changed = labels;
        const std::uint16_t old = changed[11];
        changed[11] = old == 3 ? 1 : 3;
        const auto after = core::segmentExtents(changed);
        EXPECT_NE(after[3].hash, extents[3].hash);
        for (std::uint16_t label = 1; label < 5; ++label)
            if (label != old && label != changed[11]) {
                EXPECT_EQ(after[label], extents[label]);
            }
    }
}

TEST(WithSegments, NewOnesGetOnlyPixelsWithoutSegment) {
    core::Scene scene = sceneOf({"11000000", "11000000", "11000000"});
    segmentOf(scene, 1).name = "object 2";
    const core::Scene objects = sceneOf({"99905500", "99705500", "99700033"});
    core::Notes notes;
    core::Scene after = core::withSegments(scene, objects.photo->labels, &notes);
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"11003300", "11403300", "11400022"}))
        << "most of 9 is a segment already";
    EXPECT_EQ(segmentOf(after, 2).name, "object 1");
    EXPECT_EQ(segmentOf(after, 3).name, "object 3");
    EXPECT_EQ(segmentOf(after, 4).name, "object 4");
    EXPECT_TRUE(notes.empty());
    expectWhole(after);
    EXPECT_NE(refusal([&] { return core::withSegments(after, objects.photo->labels); }), "") << "none is new";
    EXPECT_EQ(segmentOf(after = core::withSegments(scene, objects.photo->labels, nullptr, "Ding"), 4).name, "Ding 3");
    EXPECT_NE(refusal([&] { return core::withSegments(scene, core::LabelImage(8, 3, 0)); }), "");
}

TEST(WithSegments, NeverMoreThanThereAreLabels) {
    core::Scene scene = allLabels();
    core::Notes notes;
    const core::LabelImage objects(65536, 1, 1);
    EXPECT_THAT(refusal([&] { return core::withSegments(scene, objects); }), HasSubstr("not a segment already"));
    core::LabelImage one(65536, 1, 0);
    one(0, 0) = 5;
    EXPECT_THAT(refusal([&] { return core::withSegments(scene, one); }), HasSubstr("no label is free"));
    scene = core::deleteSegments(scene, Labels{17, 300});
    core::LabelImage three(65536, 1, 0);
    three(0, 0) = 3;
    three(17, 0) = 1;
    three(300, 0) = 2;
    scene = core::withSegments(scene, three, &notes);
    EXPECT_EQ(scene.segments.size(), 65535U);
    EXPECT_EQ(scene.photo->labels(0, 0), 0);
    EXPECT_EQ(scene.photo->labels(17, 0), 17);
    EXPECT_EQ(scene.photo->labels(300, 0), 300);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_THAT(notes[0].english(), HasSubstr("for 1 of the objects"));
    expectWhole(scene);
}

TEST(AllLabels, EveryOperationWorksOnThem) {
    const core::Scene scene = allLabels();
    Labels labels;
    for (int label = 1; label <= 65535; ++label) labels.push_back(static_cast<std::uint16_t>(label));
    EXPECT_EQ(core::mergeSegments(scene, labels).segments.size(), 1U);
    EXPECT_EQ(core::deleteSegments(scene, labels).segments.size(), 0U);
    core::Notes notes;
    Mask all(65536, 1, 1);
    EXPECT_EQ(core::combineSegment(scene, 65535, all, MaskUse::Add, &notes).segments.size(), 1U);
    ASSERT_EQ(notes.size(), 1U) << "one sentence, not 65534";
    EXPECT_THAT(notes[0].english(), HasSubstr("65534 segments are gone"));
    EXPECT_THAT(refusal([&] { return core::duplicateSegment(scene, 1, all); }), HasSubstr("no label is free"));
    EXPECT_THAT(refusal([&] { return core::withImportedSegments(scene, scene.photo->labels, "map"); }),
                HasSubstr("no label is free"));
    EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 65535); }), HasSubstr("in one piece"));
}

TEST(SplitSegment, SaysWhenThereAreMorePiecesThanLabels) {
    auto photo = std::make_shared<core::Photo>();
    photo->labels = core::LabelImage(11 * 400, 400, 0);
    for (int y = 0; y < 400; y += 2)
        for (int x = 0; x < 11 * 400; ++x) photo->labels(x, y) = x % 11 == 10 ? 0 : 1;
    core::Scene scene;
    scene.photo = photo;
    core::addMissingSegments(scene);
    EXPECT_THAT(refusal([&] { return core::splitSegment(scene, 1); }), HasSubstr("needs 79999 new segments"));
}

TEST(WithImportedSegments, NamesAndNumbersFollowTheFile) {
    const core::Scene scene = sceneOf({"1100", "1100"});
    core::Scene after = core::withImportedSegments(scene, sceneOf({"0990", "0090"}).photo->labels, "s1");
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"1220", "1120"}));
    EXPECT_EQ(segmentOf(after, 2).name, "s1 2") << "s1 is taken";
    after = core::withImportedSegments(scene, sceneOf({"0770", "0210"}).photo->labels, "map");
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"1770", "1230"})) << "1 is taken, the others keep their number";
    EXPECT_EQ(segmentOf(after, 7).name, "map 7");
    EXPECT_EQ(segmentOf(after, 3).name, "map 1");
    expectWhole(after);
    core::Scene locked = scene;
    segmentOf(locked, 1).locked = true;
    core::Notes notes;
    after = core::withImportedSegments(locked, sceneOf({"5060", "5000"}).photo->labels, "map", &notes);
    EXPECT_EQ(rowsOf(after), (std::vector<std::string>{"1160", "1100"}));
    EXPECT_EQ(notes.size(), 1U);
    expectWhole(after);
    EXPECT_NE(refusal([&] {
                  return core::withImportedSegments(locked, sceneOf({"5000", "5000"}).photo->labels, "map");
              }),
              "");
    EXPECT_NE(refusal([&] { return core::withImportedSegments(scene, core::LabelImage(4, 2, 0), "map"); }), "");
}

TEST(MaskOfSegments, IsTheirPixels) {
    const core::Scene scene = sceneOf({"1230"});
    EXPECT_EQ(core::maskOfSegments(scene.photo->labels, Labels{1, 3}), maskOf({"1010"}));
    EXPECT_EQ(core::maskOfSegments(scene.photo->labels, Labels{0}), maskOf({"0000"}));
}

}  // namespace
