// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/selection/min_cut.h"

#include <algorithm>

#include "core/base/error.h"

namespace core {

namespace {

/// Active nodes between two checkpoints.
constexpr std::size_t kNodesPerCheckpoint = 1U << 12U;

}  // namespace

MinCut::MinCut(std::size_t nodeCount) : nodes_(nodeCount) {}

void MinCut::addNode(std::uint32_t node, Capacity costOfRest, Capacity costOfObject) {
    CORE_ASSERT(costOfRest >= 0 && costOfObject >= 0, "capacities are not negative");
    flow_ += std::min(costOfRest, costOfObject);
    Capacity& terminal = nodes_[node].terminal;
    const Capacity before = terminal;
    terminal += costOfRest - costOfObject;
    // What flows straight through was counted as min above; an earlier remainder of the other sign flows now.
    if (before > 0 && costOfRest < costOfObject) flow_ += std::min(before, costOfObject - costOfRest);
    if (before < 0 && costOfRest > costOfObject) flow_ += std::min(-before, costOfRest - costOfObject);
}

void MinCut::addEdge(std::uint32_t a, std::uint32_t b, Capacity cost) {
    CORE_ASSERT(a != b && cost >= 0, "an edge joins two nodes");
    const auto arc = static_cast<std::uint32_t>(arcs_.size());
    arcs_.push_back({b, nodes_[a].firstArc, cost});
    arcs_.push_back({a, nodes_[b].firstArc, cost});
    nodes_[a].firstArc = arc;
    nodes_[b].firstArc = arc + 1;
}

void MinCut::activate(std::uint32_t node) {
    if (nodes_[node].active) return;
    nodes_[node].active = true;
    queue_.push_back(node);
}

/// Grows the tree at `node`; an arc from the object's tree to the other one when they meet.
std::uint32_t MinCut::grow(std::uint32_t node) {
    const Tree tree = nodes_[node].tree;
    for (std::uint32_t arc = nodes_[node].firstArc; arc != kNone; arc = arcs_[arc].next) {
        if (towards(tree, arc) == 0) continue;
        Node& other = nodes_[arcs_[arc].head];
        if (other.tree == Tree::None) {
            other.tree = tree;
            other.parent = sister(arc);
            other.timestamp = nodes_[node].timestamp;
            other.distance = nodes_[node].distance + 1;
            activate(arcs_[arc].head);
        } else if (other.tree != tree) {
            return tree == Tree::Object ? arc : sister(arc);
        } else if (other.timestamp <= nodes_[node].timestamp && other.distance > nodes_[node].distance) {
            // A shorter way to the terminal.
            other.parent = sister(arc);
            other.timestamp = nodes_[node].timestamp;
            other.distance = nodes_[node].distance + 1;
        }
    }
    return kNone;
}

MinCut::Capacity MinCut::bottleneck(std::uint32_t arc) const {
    Capacity least = arcs_[arc].left;
    std::uint32_t node = arcs_[sister(arc)].head;
    while (nodes_[node].parent != kTerminal) {
        least = std::min(least, arcs_[sister(nodes_[node].parent)].left);
        node = arcs_[nodes_[node].parent].head;
    }
    least = std::min(least, nodes_[node].terminal);
    node = arcs_[arc].head;
    while (nodes_[node].parent != kTerminal) {
        least = std::min(least, arcs_[nodes_[node].parent].left);
        node = arcs_[nodes_[node].parent].head;
    }
    return std::min(least, -nodes_[node].terminal);
}

void MinCut::makeOrphan(std::uint32_t node) {
    nodes_[node].parent = kOrphan;
    orphans_.push_back(node);
}

/// Sends as much as possible along the path through `arc`, which joins the trees.
void MinCut::augment(std::uint32_t arc) {
    const Capacity amount = bottleneck(arc);
    arcs_[sister(arc)].left += amount;
    arcs_[arc].left -= amount;
    std::uint32_t node = arcs_[sister(arc)].head;
    while (nodes_[node].parent != kTerminal) {
        const std::uint32_t up = nodes_[node].parent;
        arcs_[up].left += amount;
        arcs_[sister(up)].left -= amount;
        if (arcs_[sister(up)].left == 0) makeOrphan(node);
        node = arcs_[up].head;
    }
    nodes_[node].terminal -= amount;
    if (nodes_[node].terminal == 0) makeOrphan(node);
    node = arcs_[arc].head;
    while (nodes_[node].parent != kTerminal) {
        const std::uint32_t up = nodes_[node].parent;
        arcs_[sister(up)].left += amount;
        arcs_[up].left -= amount;
        if (arcs_[up].left == 0) makeOrphan(node);
        node = arcs_[up].head;
    }
    nodes_[node].terminal += amount;
    if (nodes_[node].terminal == 0) makeOrphan(node);
    flow_ += amount;
}

/// Number of arcs from `node` to its terminal, kNone when its tree hangs on an orphan. Marks the way with the current
/// time.
std::uint32_t MinCut::distanceToTerminal(std::uint32_t node) {
    std::uint32_t distance = 0;
    std::uint32_t at = node;
    while (true) {
        if (nodes_[at].timestamp == time_) {
            distance += nodes_[at].distance;
            break;
        }
        const std::uint32_t parent = nodes_[at].parent;
        ++distance;
        if (parent == kTerminal) {
            nodes_[at].timestamp = time_;
            nodes_[at].distance = 1;
            break;
        }
        if (parent == kOrphan || parent == kNone) return kNone;
        at = arcs_[parent].head;
    }
    std::uint32_t left = distance;
    for (at = node; nodes_[at].timestamp != time_; at = arcs_[nodes_[at].parent].head) {
        nodes_[at].timestamp = time_;
        nodes_[at].distance = left--;
    }
    return distance;
}

void MinCut::processOrphan(std::uint32_t node) {
    const Tree tree = nodes_[node].tree;
    std::uint32_t best = kNone;
    std::uint32_t bestDistance = kNone;
    for (std::uint32_t arc = nodes_[node].firstArc; arc != kNone; arc = arcs_[arc].next) {
        const std::uint32_t other = arcs_[arc].head;
        if (towards(tree, sister(arc)) == 0 || nodes_[other].tree != tree || nodes_[other].parent == kNone) continue;
        const std::uint32_t distance = distanceToTerminal(other);
        if (distance >= bestDistance) continue;
        bestDistance = distance;
        best = arc;
    }
    if (best != kNone) {
        nodes_[node].parent = best;
        nodes_[node].timestamp = time_;
        nodes_[node].distance = bestDistance + 1;
        return;
    }
    for (std::uint32_t arc = nodes_[node].firstArc; arc != kNone; arc = arcs_[arc].next) {
        const std::uint32_t other = arcs_[arc].head;
        if (nodes_[other].tree != tree) continue;
        if (towards(tree, sister(arc)) > 0) activate(other);
        const std::uint32_t parent = nodes_[other].parent;
        if (parent < kOrphan && arcs_[parent].head == node) makeOrphan(other);
    }
    nodes_[node].tree = Tree::None;
    nodes_[node].parent = kNone;
}

void MinCut::adopt() {
    ++time_;
    for (std::size_t i = 0; i < orphans_.size(); ++i) processOrphan(orphans_[i]);
    orphans_.clear();
}

std::vector<std::uint8_t> MinCut::solve(const Progress& progress) {
    for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
        Node& node = nodes_[i];
        if (node.terminal == 0) continue;
        node.tree = node.terminal > 0 ? Tree::Object : Tree::Rest;
        node.parent = kTerminal;
        node.distance = 1;
        activate(i);
    }
    std::size_t handled = 0;
    while (queueHead_ < queue_.size()) {
        if (++handled % kNodesPerCheckpoint == 0) progress.checkpoint(0.5f);
        const std::uint32_t node = queue_[queueHead_];
        if (nodes_[node].tree == Tree::None) {
            nodes_[node].active = false;
            ++queueHead_;
            continue;
        }
        const std::uint32_t meeting = grow(node);
        if (meeting != kNone) {
            augment(meeting);
            adopt();
            continue;  // The same node may reach further.
        }
        nodes_[node].active = false;
        ++queueHead_;
        if (queueHead_ > nodes_.size()) {
            queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(queueHead_));
            queueHead_ = 0;
        }
    }
    std::vector<std::uint8_t> object(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i) object[i] = nodes_[i].tree == Tree::Object ? 1 : 0;
    return object;
}

}  // namespace core
