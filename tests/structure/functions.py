#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the longest and the most branched functions of the program, and fails on those over the limits.

A function's lines run from its signature to its closing brace. Its branches are the tokens in BRANCHES; lambdas count into
the function around them. Initialisers of tables are not functions. Works on tokens, without a compiler: it understands the
C++ of this code base, not all of C++. --self-test checks the script itself.
"""
import argparse
import os
import re
import sys
from typing import NamedTuple

FOLDERS = ["core", "render", "gpu", "ui", "app"]
MAX_LINES = 80
MAX_BRANCHES = 20
BRANCHES = {"if", "for", "while", "case", "catch", "?", "&&", "||"}
SHOWN = 10

TOKEN = re.compile(r"""
    (?P<skip> //[^\n]* | /\*.*?\*/ | ^[ \t]*\#(?:[^\n\\]|\\.)* | \s+ )
  | (?P<string> (?:u8|[uUL])?R"(?P<delimiter>[^()\s\\]*)\(.*?\)(?P=delimiter)" | (?:u8|[uUL])?"(?:[^"\\]|\\.)*"
              | (?<![0-9A-Fa-f])'(?:[^'\\]|\\.)+' )
  | (?P<word> [A-Za-z_~][A-Za-z0-9_]* | [0-9](?:[0-9A-Za-z_.]|'(?=[0-9A-Fa-f])|(?<=[eEpP])[+-])* )
  | (?P<mark> :: | -> | && | \|\| | . )
""", re.VERBOSE | re.DOTALL | re.MULTILINE)

CLOSING = {"(": ")", "{": "}", "[": "]"}
AFTER_SIGNATURE = {"const", "noexcept", "override", "final", "mutable", "try", ")", ">", "&", "&&"}


class Token(NamedTuple):
    text: str
    line: int


class Function(NamedTuple):
    name: str
    path: str
    line: int
    lines: int
    branches: int


def tokens_of(text):
    result, line, position = [], 1, 0
    for match in TOKEN.finditer(text):
        line += text.count("\n", position, match.start())
        position = match.start()
        if match.lastgroup == "skip":
            continue
        result.append(Token('""' if match["string"] else match[0], line))
    return result


def closing(tokens, start):
    """Index of the bracket that closes the one at `start`."""
    depth = 0
    for i in range(start, len(tokens)):
        if tokens[i].text in CLOSING:
            depth += 1
        elif tokens[i].text in CLOSING.values():
            depth -= 1
            if depth == 0:
                return i
    return len(tokens) - 1


def closing_angle(words, start):
    """Index of the `>` that closes the `<` at `start`, both in a list of texts."""
    depth = 0
    for i in range(start, len(words)):
        depth += {"<": 1, ">": -1}.get(words[i], 0)
        if depth == 0:
            return i
    return len(words) - 1


def without_prefix(head):
    """Tokens of a declaration without template parameters, attributes and access specifiers."""
    words = [token.text for token in head]
    i = 0
    while i < len(words):
        if words[i] == "template" and i + 1 < len(words) and words[i + 1] == "<":
            i = closing_angle(words, i + 1) + 1
        elif words[i:i + 2] == ["[", "["]:
            i = closing(head, i) + 1
        elif words[i] in ("public", "private", "protected", "signals", "slots", ":"):
            i += 1
        else:
            break
    return head[i:]


def top_level(head):
    """Texts of a declaration outside its brackets; a bracketed group is one `()`, `{}` or `[]`, an operator one word."""
    result, i = [], 0
    while i < len(head):
        text = head[i].text
        if text == "operator":
            while i + 1 < len(head) and (head[i + 1].text != "(" or head[i + 2].text == ")" and text == "operator"):
                i += 1
                text += head[i].text
        elif text in CLOSING:
            i = closing(head, i)
            text += CLOSING[text]
        result.append(text)
        i += 1
    return result


def kind_of(head):
    """What the `{` after a declaration opens: "scope", "function", "value" or "block" (nothing to look into)."""
    words = top_level(head)
    if not words:
        return "block"
    if "namespace" in words or words[:2] == ["extern", '""']:
        return "scope"
    if words[0] == "enum" or "=" in words:
        return "value"
    parameters = words.index("()") if "()" in words else None
    if words[0] in ("class", "struct", "union") and words[-1] != ")" and (parameters is None or parameters < 3):
        return "scope"
    if parameters is None:
        return "value"
    after = words[parameters + 1:]
    initialises = ":" in after and "->" not in after[:after.index(":")]
    last = head[-1].text
    if initialises:
        return "function" if last in (")", "}") else "value"
    if "->" in after or last in AFTER_SIGNATURE:
        return "function"
    return "value"


def name_of(head):
    words = top_level(head)
    end = words.index("()")
    begin = end - 1
    while begin > 0 and (words[begin - 1] == "::" or words[begin] == "::"):
        begin -= 1
    return "".join(words[begin:end]) or "?"


def branches_in(tokens):
    count = 0
    for i, token in enumerate(tokens):
        if token.text not in BRANCHES:
            continue
        before, after = tokens[i - 1].text if i else "", tokens[i + 1].text if i + 1 < len(tokens) else ""
        is_reference = token.text == "&&" and (before in ("auto", ">", "const") or after in (")", ",", ">"))
        count += not is_reference
    return count


def functions_in(text, path=""):
    tokens, found = tokens_of(text), []
    head, i = [], 0
    while i < len(tokens):
        text = tokens[i].text
        if text == "{":
            declaration = without_prefix(head)
            kind = kind_of(declaration)
            if kind == "scope":
                head = []
            else:
                end = closing(tokens, i)
                if kind == "function":
                    first = declaration[0].line
                    found.append(Function(name_of(declaration), path, first, tokens[end].line - first + 1,
                                          branches_in(declaration) + branches_in(tokens[i:end])))
                    head = []
                elif kind == "value":
                    head = head + tokens[i:end + 1]
                i = end
        elif text in (";", "}"):
            head = []
        elif text in CLOSING:
            end = closing(tokens, i)
            head = head + tokens[i:end + 1]
            i = end
        else:
            head = head + [tokens[i]]
        i += 1
    return found


def all_functions(root):
    for folder in FOLDERS:
        for where, _, names in sorted(os.walk(os.path.join(root, folder))):
            for name in sorted(names):
                if name.endswith((".h", ".cpp")):
                    path = os.path.join(where, name)
                    with open(path, encoding="utf-8") as text:
                        yield from functions_in(text.read(), os.path.relpath(path, root))


SAMPLE = r'''
#define TABLE(x) { if (x) }
namespace a { namespace {
constexpr int kTable[] = {1, 2, 3};
const std::map<int, int> other{{1, 2}};
enum class E { A, B };
template <class T = int>
[[nodiscard]] std::vector<T> first(const T& t, int n = 3) {
    // if a comment && a string: "for"
    const char* s = "while (true) {"; const char* raw = R"x(case ")" if)x"; const char c = '{';
    const int million = 1'000'000;
    for (auto&& v : t) if (v && n || c == '\'') return {};
    return std::move(t);
}
}
struct Plain : Base {
    Plain(int v) : v_{v}, w_(v) { if (v) w_ = 0; }
    bool operator()(int v) const { return v ? true : false; }
    bool operator==(const Plain&) const = default;
    [[nodiscard]] auto back() const -> std::pair<int, int> { return {v_, w_}; }
  private:
    int v_{0};
    std::function<void()> call = [] { if (true) return; };
};
Plain::~Plain() {
    const auto inner = [&](int i) {
        switch (i) { case 1: case 2: break; }
    };
    try { inner(1); } catch (...) {}
}
}
'''


def self_test():
    found = {f.name: (f.lines, f.branches) for f in functions_in(SAMPLE)}
    expected = {"first": (7, 4), "Plain": (1, 1), "operator()": (1, 1), "back": (1, 0), "Plain::~Plain": (6, 3)}
    assert found == expected, found
    lines = {f.name: f.line for f in functions_in(SAMPLE)}
    assert SAMPLE.split("\n")[lines["first"] - 1].startswith("[[nodiscard]]"), lines
    assert functions_in("int a(int x) {\n#if 1\n  return x;\n#endif\n}")[0].lines == 5


def print_table(title, functions):
    print(title)
    for f in functions:
        print(f"  {f.lines:4} lines {f.branches:3} branches  {f.path}:{f.line} {f.name}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--self-test", action="store_true", help="check this script")
    options = parser.parse_args()
    if options.self_test:
        self_test()
        return 0
    functions = list(all_functions(os.path.join(os.path.dirname(__file__), "..", "..")))
    print_table("Longest functions", sorted(functions, key=lambda f: -f.lines)[:SHOWN])
    print_table("Most branches", sorted(functions, key=lambda f: -f.branches)[:SHOWN])
    over = [f for f in functions if f.lines > MAX_LINES or f.branches > MAX_BRANCHES]
    print(f"{len(functions)} functions; {len(over)} over the limits of {MAX_LINES} lines and {MAX_BRANCHES} branches")
    return 1 if over else 0


if __name__ == "__main__":
    sys.exit(main())
