#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the rooms of core, floor by floor, with the number of includes between them.

Fails on an include that points up (see ORDER) and on a ring between rooms. --self-test checks the script itself.
"""
import argparse
import collections
import os
import re
import sys

# Lower rooms first. `io` stands beside `shading`: it may include everything below it, and no room includes it.
ORDER = ["base", "material", "scene", "geometry", "selection", "analysis", "shading"]
BESIDE = {"io": "shading"}
INCLUDE = re.compile(r'^\s*#\s*include\s*"core/([^"]+)"')


def level(room):
    return ORDER.index(BESIDE.get(room, room))


def points_down(source, target):
    return level(target) < level(source)


def room_of(path):
    """First folder below core of a path relative to core."""
    return path.split("/")[0]


def includes_of(root):
    """Yields (file, included file), both relative to core."""
    core = os.path.join(root, "core")
    for folder, _, names in sorted(os.walk(core)):
        for name in sorted(names):
            if not name.endswith((".h", ".cpp")):
                continue
            path = os.path.join(folder, name)
            with open(path, encoding="utf-8") as text:
                for line in text:
                    match = INCLUDE.match(line)
                    if match:
                        yield os.path.relpath(path, core), match.group(1)


def ring_in(arrows):
    """Rooms of one ring, or an empty list. `arrows` maps a room to the rooms that it includes."""
    state, path = {}, []

    def visit(room):
        state[room] = "open"
        path.append(room)
        for target in sorted(arrows.get(room, ())):
            if state.get(target) == "open":
                return path[path.index(target):] + [target]
            if target not in state:
                ring = visit(target)
                if ring:
                    return ring
        state[room] = "done"
        path.pop()
        return []

    for room in sorted(arrows):
        if room not in state:
            ring = visit(room)
            if ring:
                return ring
    return []


def check(includes):
    """(number of includes by (source room, target room), complaints)."""
    counts, complaints = collections.Counter(), []
    for source, target in includes:
        rooms = room_of(source), room_of(target)
        if rooms[0] == rooms[1]:
            continue
        counts[rooms] += 1
        unknown = [room for room in rooms if room not in ORDER and room not in BESIDE]
        if unknown:
            complaints.append(f"core/{source}: the room {unknown[0]} is not in the order of this script.")
        elif not points_down(*rooms):
            complaints.append(f"core/{source} includes core/{target}, which is not below it.")
    arrows = collections.defaultdict(set)
    for source, target in counts:
        arrows[source].add(target)
    ring = ring_in(arrows)
    if ring:
        complaints.append("Ring between rooms: " + " -> ".join(ring))
    return counts, complaints


def print_graph(counts):
    print(f"Rooms of core: {len(ORDER) + len(BESIDE)}, arrows between them: {len(counts)}, includes: {sum(counts.values())}")
    for room in sorted([*ORDER, *BESIDE], key=lambda name: (-level(name), name)):
        targets = sorted(((level(target), target, count) for (source, target), count in counts.items() if source == room),
                         reverse=True)
        print(f"  {room:9}" + (" -> " + ", ".join(f"{target} {count}" for _, target, count in targets) if targets else ""))


def self_test():
    counts, complaints = check([("scene/a.h", "base/b.h"), ("scene/a.cpp", "base/b.h"), ("io/a.cpp", "scene/a.h"),
                                ("scene/a.cpp", "scene/b.h")])
    assert complaints == [], complaints
    assert counts == {("scene", "base"): 2, ("io", "scene"): 1}, counts
    assert check([("base/a.h", "scene/a.h")])[1], "an arrow up"
    assert check([("io/a.h", "shading/a.h")])[1], "io beside shading"
    assert check([("scene/a.h", "attic/a.h")])[1], "an unknown room"
    assert ring_in({"a": {"b"}, "b": {"c"}, "c": {"b"}}) == ["b", "c", "b"]
    assert ring_in({"a": {"b", "c"}, "b": {"c"}}) == []
    assert INCLUDE.match('#include "core/base/error.h"').group(1) == "base/error.h"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--self-test", action="store_true")
    if parser.parse_args().self_test:
        self_test()
        return 0
    counts, complaints = check(includes_of(os.path.join(os.path.dirname(__file__), "..", "..")))
    print_graph(counts)
    for complaint in complaints:
        print(complaint, file=sys.stderr)
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
