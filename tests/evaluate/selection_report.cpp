// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/evaluate/selection_report.h"

#include <cmath>
#include <map>
#include <optional>

#include "core/base/clock.h"
#include "core/selection/mask_operations.h"
#include "core/selection/selector.h"
#include "tests/evaluate/markdown.h"

namespace evaluate {

namespace {

using core::BinaryMask;
using core::Pixel;

constexpr int kMaxClicks = 12;
constexpr double kEnough = 0.9;
constexpr std::size_t kMinPixels = 400;

std::size_t areaOf(const BinaryMask& mask) {
    std::size_t area = 0;
    for (const std::uint8_t value : mask.pixels()) area += value;
    return area;
}

double overlapOf(const BinaryMask& a, const BinaryMask& b) {
    std::size_t both = 0, any = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        both += a[i] & b[i];
        any += a[i] | b[i];
    }
    return any == 0 ? 1 : static_cast<double>(both) / static_cast<double>(any);
}

/// Squared distance of each selected pixel to the nearest other one, the picture's surroundings included.
core::Image<double> squaredDepth(const BinaryMask& mask) {
    const int w = mask.width(), h = mask.height();
    core::Image<double> column(w, h), result(w, h);
    for (int x = 0; x < w; ++x) {
        double steps = 0;
        for (int y = 0; y < h; ++y) column(x, y) = steps = mask(x, y) != 0 ? steps + 1 : 0;
        steps = 0;
        for (int y = h - 1; y >= 0; --y) column(x, y) = std::min(column(x, y), steps = mask(x, y) != 0 ? steps + 1 : 0);
    }
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            if (mask(x, y) == 0) continue;
            const double edge = std::min(x + 1, w - x);
            double least = std::min(column(x, y) * column(x, y), edge * edge);
            for (int k = 1; k * k < least; ++k)
                for (const int px : {x - k, x + k})
                    if (px >= 0 && px < w) least = std::min(least, k * k + column(px, y) * column(px, y));
            result(x, y) = least;
        }
    return result;
}

/// Largest 4-connected region of a mask.
BinaryMask largestPiece(BinaryMask mask) {
    std::vector<Pixel> largest;
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x) {
            if (mask(x, y) == 0) continue;
            std::vector<Pixel> piece{{x, y}};
            mask(x, y) = 0;
            for (std::size_t i = 0; i < piece.size(); ++i)
                for (const Pixel& step : core::kNeighbors) {
                    const Pixel next{piece[i].x + step.x, piece[i].y + step.y};
                    if (!mask.contains(next.x, next.y) || mask(next.x, next.y) == 0) continue;
                    mask(next.x, next.y) = 0;
                    piece.push_back(next);
                }
            if (piece.size() > largest.size()) largest = std::move(piece);
        }
    BinaryMask result(mask.width(), mask.height());
    for (const Pixel& p : largest) result(p.x, p.y) = 1;
    return result;
}

struct Click {
    Pixel pixel;
    bool add;
};

std::optional<Click> nextClick(const BinaryMask& truth, const BinaryMask& found) {
    BinaryMask missing = truth, excess = found;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (found[i] != 0) missing[i] = 0;
        if (truth[i] != 0) excess[i] = 0;
    }
    missing = largestPiece(std::move(missing));
    excess = largestPiece(std::move(excess));
    const bool add = areaOf(missing) >= areaOf(excess);
    const core::Image<double> depth = squaredDepth(add ? missing : excess);
    const auto deepest = std::ranges::max_element(depth.pixels());
    if (*deepest == 0) return std::nullopt;
    const int index = static_cast<int>(deepest - depth.pixels().begin());
    return Click{{index % depth.width(), index / depth.width()}, add};
}

/// Pixels of a mask beside others.
BinaryMask outlineOf(const BinaryMask& mask) {
    BinaryMask outline = mask;
    const BinaryMask inside = core::shrinkMask(mask, 1);
    for (std::size_t i = 0; i < mask.size(); ++i)
        if (inside[i] != 0) outline[i] = 0;
    return outline;
}

/// Mean distance of the found outline from the true one [px].
double outlineDistance(const BinaryMask& truth, const BinaryMask& found) {
    const core::Image<double> distance = squaredDepth(core::invertMask(outlineOf(truth)));
    const BinaryMask outline = outlineOf(found);
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < outline.size(); ++i)
        if (outline[i] != 0) sum += std::sqrt(distance[i]), ++count;
    return count == 0 ? std::nan("") : sum / static_cast<double>(count);
}

Json objectReport(const core::Selector& selector, const BinaryMask& truth) {
    BinaryMask found(truth.width(), truth.height());
    core::SelectionSeeds seeds;
    double overlap = 0, first = 0, seconds = 0;
    int clicks = 0;
    while (clicks < kMaxClicks && overlap < kEnough) {
        const std::optional<Click> click = nextClick(truth, found);
        if (!click) break;
        (click->add ? seeds.add : seeds.remove).push_back(click->pixel);
        const core::Clock::time_point start = core::Clock::now();
        found = selector.select(seeds);
        seconds += core::secondsSince(start);
        overlap = overlapOf(truth, found);
        if (++clicks == 1) first = overlap;
    }
    return {{"pixels", areaOf(truth)},
            {"clicks", overlap >= kEnough ? clicks : kMaxClicks + 1},
            {"first_overlap", first},
            {"overlap", overlap},
            {"outline_distance", outlineDistance(truth, found)},
            {"click_seconds", seconds / std::max(1, clicks)}};
}

}  // namespace

Json selectionReport(const core::Scene& scene, const std::string& name) {
    const core::Photo& photo = *scene.photo;
    std::map<std::uint16_t, std::size_t> areas;
    for (const std::uint16_t label : photo.labels.pixels())
        if (label != 0) ++areas[label];
    std::erase_if(areas, [](const auto& entry) { return entry.second < kMinPixels; });
    const auto largest = std::ranges::max_element(areas, {}, [](const auto& entry) { return entry.second; });
    if (areas.size() > 1) areas.erase(largest);
    const core::Clock::time_point start = core::Clock::now();
    const core::Selector selector({photo.color, photo.depth, photo.camera, photo.depthSampleSpacing});
    Json report = {{"case", name}, {"preparation_seconds", core::secondsSince(start)}, {"objects", Json::array()}};
    for (const auto& [label, area] : areas) {
        BinaryMask truth(photo.labels.width(), photo.labels.height());
        for (std::size_t i = 0; i < truth.size(); ++i) truth[i] = photo.labels[i] == label ? 1 : 0;
        Json object = objectReport(selector, truth);
        object["segment"] = scene.findSegment(label)->name;
        report["objects"].push_back(std::move(object));
    }
    return report;
}

void printSelections(std::ostream& out, const Json& reports) {
    if (reports.empty()) return;
    out << "\n### Selection by clicks\n\n";
    Table table(out, {"object", "pixels", "clicks", "overlap after one", "overlap", "outline [px]", "click [ms]"});
    for (const Json& report : reports)
        for (const Json& object : report.at("objects"))
            table.row({report.at("case").get<std::string>() + ": " + object.at("segment").get<std::string>(),
                       fixed(object.at("pixels"), 0), fixed(object.at("clicks"), 0),
                       percent(object.at("first_overlap")), percent(object.at("overlap")),
                       fixed(object.at("outline_distance"), 2),
                       fixed(1000 * object.at("click_seconds").get<double>(), 1)});
}

}  // namespace evaluate
