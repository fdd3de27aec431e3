#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fails when two sources of one target define a constant of the same name.

A unity build compiles several sources as one, and which ones share a unit changes with every new file, so a name that is
defined twice may break the build long after it was added. --self-test checks the script itself.
"""
import collections
import os
import re
import sys

CONSTANT = re.compile(r"^(?:static )?constexpr\s[\w:<>, *&]*?\b(k[A-Z]\w*)\s*(?:=|\{|\[)", re.M)


def target_of(path):
    parts = path.split("/")
    return "/".join(parts[:2]) if parts[0] in ("tests", "app") else parts[0]


def find_duplicates(sources):
    """Names by target with the files that define them; `sources`: pairs of path and text."""
    found = collections.defaultdict(set)
    for path, text in sources:
        for name in CONSTANT.findall(text):
            found[target_of(path), name].add(path)
    return {key: sorted(paths) for key, paths in found.items() if len(paths) > 1}


def read_sources(root):
    for room in ("app", "core", "gpu", "render", "tests", "ui"):
        for folder, _, names in os.walk(os.path.join(root, room)):
            for name in names:
                if name.endswith(".cpp"):
                    path = os.path.join(folder, name)
                    with open(path, encoding="utf-8") as file:
                        yield os.path.relpath(path, root), file.read()


def self_test():
    twice = [("core/a.cpp", "constexpr int kSize = 1;\n"), ("core/b/c.cpp", "constexpr float kSize{2};\n")]
    assert find_duplicates(twice) == {("core", "kSize"): ["core/a.cpp", "core/b/c.cpp"]}
    assert not find_duplicates([("core/a.cpp", "constexpr int kA = 1;\n"), ("ui/a.cpp", "constexpr int kA = 1;\n")])
    assert not find_duplicates([("core/a.cpp", "    constexpr int kA = 1;\n"), ("core/b.cpp", "    constexpr int kA = 1;\n")])
    print("ok")


def main():
    if "--self-test" in sys.argv:
        self_test()
        return 0
    duplicates = find_duplicates(read_sources(os.path.join(os.path.dirname(__file__), "..", "..")))
    for (target, name), files in sorted(duplicates.items()):
        print(f"{target}: {name} is defined in {', '.join(files)}")
    print(f"{len(duplicates)} constants defined twice in one target")
    return 1 if duplicates else 0


if __name__ == "__main__":
    sys.exit(main())
