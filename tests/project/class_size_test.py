#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A class of more than fifteen data members says in its comment what its members are, and why they are together.

Members are those whose names end in an underscore: a plain structure, which only carries values, has none.
"""
import os
import re
import subprocess
import sys
import unittest

MOST_MEMBERS = 15
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
CLASS = re.compile(r"^[ \t]*(?:class|struct)\s+(?:[A-Z_]+\s+)?(\w+)[^;{()]*\{", re.MULTILINE)
MEMBER = re.compile(r"\b\w+_\s*(?:=[^;]*|\[\w+\])?;")


def without_comments(text):
    """The same text, at the same places, without what follows //."""
    return re.sub(r"//[^\n]*", lambda found: " " * len(found.group()), text)


def own_part(code, begin):
    """The body of a class from behind its brace to its end, without what stands in braces within it."""
    depth = 1
    own = []
    for at in range(begin, len(code)):
        if code[at] == "{":
            depth += 1
        elif code[at] == "}":
            depth -= 1
            if depth == 0:
                break
        elif depth == 1:
            own.append(code[at])
    return "".join(own)


def comment_before(text, begin):
    lines = text[:begin].rstrip("\n").split("\n")
    comment = []
    while lines and lines[-1].lstrip().startswith("///"):
        comment.insert(0, lines.pop())
    return " ".join(line.lstrip().lstrip("/").strip() for line in comment)


def violations(name, text):
    """Of one header: classes with too many members and no sentence on them."""
    code = without_comments(text)
    for found in CLASS.finditer(code):
        # A call such as a method's body in the class leaves statements in braces, which are not counted.
        count = len(MEMBER.findall(own_part(code, found.end())))
        if count > MOST_MEMBERS and not re.search(r"\bmembers\b", comment_before(text, found.start())):
            yield f"{name}: {found.group(1)} has {count} data members: split it, or say in its comment why they stay"


def header(count, comment="/// Counts."):
    members = "\n".join(f"    int m{number}_ = 0;  ///< counted" for number in range(count))
    return f"namespace n {{\n{comment}\nclass Wide {{\npublic:\n    int sum() {{ return m0_; }}\nprivate:\n{members}\n}};\n}}\n"


class Rule(unittest.TestCase):
    def test_finds_a_class_of_one_too_many(self):
        self.assertEqual([], list(violations("a.hpp", header(MOST_MEMBERS))))
        self.assertEqual(1, len(list(violations("a.hpp", header(MOST_MEMBERS + 1)))))

    def test_takes_a_sentence_on_its_members(self):
        told = header(MOST_MEMBERS + 1, "/// Counts. Its members are\n/// what is counted.")
        self.assertEqual([], list(violations("a.hpp", told)))

    def test_does_not_take_what_only_stands_further_up(self):
        far = header(MOST_MEMBERS + 1, "/// On members.\n\n/// Counts.")
        self.assertEqual(1, len(list(violations("a.hpp", far))))

    def test_holds_in_this_tree(self):
        listed = subprocess.run(["git", "ls-files", "hmi/*.hpp", "rtcore/*.hpp", "shared/*.hpp"], cwd=ROOT,
                                capture_output=True, text=True, check=False).stdout.split()
        if not listed:  # a tree without git: an archive
            listed = [os.path.relpath(os.path.join(folder, name), ROOT) for top in ("hmi", "rtcore", "shared")
                      for folder, _, names in os.walk(os.path.join(ROOT, top)) for name in names
                      if name.endswith(".hpp")]
        self.assertGreater(len(listed), 500)
        found = []
        for name in listed:
            with open(os.path.join(ROOT, name), encoding="utf-8") as file:
                found += violations(name, file.read())
        self.assertEqual([], found, "\n".join(found))


if __name__ == "__main__":
    sys.exit(unittest.main())
