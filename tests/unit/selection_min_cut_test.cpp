// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <random>

#include "core/selection/min_cut.h"

namespace {

using core::MinCut;

/// A random graph of few nodes, in a form whose cuts can all be tried.
struct SmallGraph {
    struct Edge {
        std::uint32_t a, b;
        MinCut::Capacity cost;
    };
    std::vector<MinCut::Capacity> rest, object;
    std::vector<Edge> edges;

    [[nodiscard]] MinCut::Capacity costOf(std::uint32_t chosen) const {
        MinCut::Capacity cost = 0;
        for (std::size_t i = 0; i < rest.size(); ++i) cost += (chosen >> i & 1U) != 0 ? object[i] : rest[i];
        for (const Edge& edge : edges)
            if ((chosen >> edge.a & 1U) != (chosen >> edge.b & 1U)) cost += edge.cost;
        return cost;
    }
};

SmallGraph randomGraph(std::mt19937& random) {
    const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
    SmallGraph graph;
    const std::uint32_t nodes = 2 + below(9);
    for (std::uint32_t i = 0; i < nodes; ++i) {
        graph.rest.push_back(below(3) == 0 ? 0 : below(20));
        graph.object.push_back(below(3) == 0 ? 0 : below(20));
    }
    for (std::uint32_t a = 0; a < nodes; ++a)
        for (std::uint32_t b = a + 1; b < nodes; ++b)
            if (below(2) == 0) graph.edges.push_back({a, b, below(15)});
    return graph;
}

TEST(MinCut, IsTheCheapestOfAllCuts) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 500; ++trial) {
        const SmallGraph graph = randomGraph(random);
        MinCut cut(graph.rest.size());
        for (std::uint32_t i = 0; i < graph.rest.size(); ++i) {
            // In two parts, as the selection adds colours and seeds.
            cut.addNode(i, graph.rest[i], 0);
            cut.addNode(i, 0, graph.object[i]);
        }
        for (const SmallGraph::Edge& edge : graph.edges) cut.addEdge(edge.a, edge.b, edge.cost);
        std::uint32_t found = 0;
        const std::vector<std::uint8_t> object = cut.solve();
        for (std::size_t i = 0; i < object.size(); ++i) found |= static_cast<std::uint32_t>(object[i]) << i;
        MinCut::Capacity least = graph.costOf(0);
        for (std::uint32_t chosen = 1; chosen < 1U << object.size(); ++chosen)
            least = std::min(least, graph.costOf(chosen));
        ASSERT_EQ(graph.costOf(found), least) << "trial " << trial;
        ASSERT_EQ(cut.cost(), least) << "trial " << trial;
        for (std::uint32_t chosen = 0; chosen < 1U << object.size(); ++chosen) {
            if (graph.costOf(chosen) != least) continue;
            ASSERT_EQ(found & ~chosen, 0U) << "a smaller object costs the same";
        }
    }
}

TEST(MinCut, SolvesAGridLikeItsColumns) {
    // A grid in which one column of edges is cheap: the cut runs there.
    constexpr std::uint32_t kSide = 60;
    MinCut cut(kSide * kSide);
    const auto at = [](std::uint32_t x, std::uint32_t y) { return y * kSide + x; };
    for (std::uint32_t y = 0; y < kSide; ++y) {
        cut.addNode(at(0, y), MinCut::kMaxCapacity, 0);
        cut.addNode(at(kSide - 1, y), 0, MinCut::kMaxCapacity);
        for (std::uint32_t x = 0; x < kSide; ++x) {
            if (x + 1 < kSide) cut.addEdge(at(x, y), at(x + 1, y), x == 41 ? 2 : 10);
            if (y + 1 < kSide) cut.addEdge(at(x, y), at(x, y + 1), 3);
        }
    }
    const std::vector<std::uint8_t> object = cut.solve();
    EXPECT_EQ(cut.cost(), 2 * kSide);
    for (std::uint32_t i = 0; i < object.size(); ++i) ASSERT_EQ(object[i], i % kSide <= 41 ? 1 : 0);
}

TEST(MinCut, CanBeCancelled) {
    const std::atomic<bool> cancel{true};
    MinCut cut(20000);
    for (std::uint32_t i = 0; i + 1 < 20000; ++i) {
        cut.addNode(i, i % 7, i % 5);
        cut.addEdge(i, i + 1, 3);
    }
    EXPECT_THROW((void)cut.solve(core::Progress({}, &cancel)), core::Error);
}

}  // namespace
