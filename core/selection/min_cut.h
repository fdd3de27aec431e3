// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"

namespace core {

/// Minimum cut between two terminals, object and rest, by augmenting paths in two search trees ([BK04]). Capacities are
/// integers, so that the result is exact and independent of rounding.
class MinCut {
  public:
    using Capacity = std::int64_t;
    /// Largest capacity that may be given; enough for a hard constraint.
    static constexpr Capacity kMaxCapacity = Capacity{1} << 40U;

    explicit MinCut(std::size_t nodeCount);

    /// Costs ≥ 0, at most kMaxCapacity, of leaving `node` out of the object and of taking it in. Adds to earlier ones.
    void addNode(std::uint32_t node, Capacity costOfRest, Capacity costOfObject);
    /// Cost ≥ 0, at most kMaxCapacity, of separating two different nodes.
    void addEdge(std::uint32_t a, std::uint32_t b, Capacity cost);
    /// The cut, once: 1 for nodes of the object. Of several minimal cuts the one with the smallest object. Throws
    /// Error(Cancelled).
    [[nodiscard]] std::vector<std::uint8_t> solve(const Progress& progress = {});
    /// Cost of the cut, valid after `solve`.
    [[nodiscard]] Capacity cost() const { return flow_; }

  private:
    static constexpr std::uint32_t kNone = 0xffffffffU;
    static constexpr std::uint32_t kTerminal = 0xfffffffeU;
    static constexpr std::uint32_t kOrphan = 0xfffffffdU;
    enum class Tree : std::uint8_t { None, Object, Rest };

    struct Node {
        std::uint32_t firstArc = kNone;
        std::uint32_t parent = kNone;  ///< arc to the parent, kTerminal or kOrphan
        std::uint32_t timestamp = 0;
        std::uint32_t distance = 0;  ///< to the terminal, valid at `timestamp`
        Capacity terminal = 0;       ///< what is left from the object's terminal, negative: to the other
        Tree tree = Tree::None;
        bool active = false;
    };
    struct Arc {
        std::uint32_t head;
        std::uint32_t next;  ///< next arc of the same tail
        Capacity left;       ///< residual capacity
    };
    /// The opposite arc; arcs are stored in pairs.
    [[nodiscard]] static std::uint32_t sister(std::uint32_t arc) { return arc ^ 1U; }
    /// Residual capacity of an arc of a node of `tree` from the parent's side to the child's.
    [[nodiscard]] Capacity towards(Tree tree, std::uint32_t arc) const {
        return tree == Tree::Object ? arcs_[arc].left : arcs_[sister(arc)].left;
    }
    void activate(std::uint32_t node);
    [[nodiscard]] std::uint32_t grow(std::uint32_t node);
    void augment(std::uint32_t arc);
    [[nodiscard]] Capacity bottleneck(std::uint32_t arc) const;
    void makeOrphan(std::uint32_t node);
    void adopt();
    void processOrphan(std::uint32_t node);
    [[nodiscard]] std::uint32_t distanceToTerminal(std::uint32_t node);

    std::vector<Node> nodes_;
    std::vector<Arc> arcs_;
    std::vector<std::uint32_t> queue_;  ///< active nodes
    std::size_t queueHead_ = 0;
    std::vector<std::uint32_t> orphans_;
    std::uint32_t time_ = 0;
    Capacity flow_ = 0;
};

}  // namespace core
