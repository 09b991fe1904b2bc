#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Judges and lays out the documents (*.md).

    scripts/documents.py check           says what is wrong, exit code 1 then: lines over 120 columns (those of tables may
                                         be longer), rows of a table with other cells than its head, links to files or
                                         headings that are not there, two decisions of one number
    scripts/documents.py wrap [FILE...]  lays paragraphs and list entries with such a line out anew, and nothing else
"""

import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
MOST_COLUMNS = 120
FENCE, TABLE, HEADING = re.compile(r"\s*```"), re.compile(r"\s*\|"), re.compile(r"#{1,6} ")
ENTRY = re.compile(r"(\s*)([-*+]|\d+[.)]) +(?=\S)")
# What would begin something else where it stands first in a line.
BEGINS_ANOTHER = re.compile(r"([-+*>|]|#+|\d+[.)]|=+|-+)$|[>|]|```")


def documents(root):
    listed = subprocess.run(["git", "-c", "safe.directory=*", "ls-files", "-co", "--exclude-standard", "--", "*.md"],
                            cwd=root, stdout=subprocess.PIPE, text=True, check=False).stdout.split()
    if not listed:  # no checkout
        listed = [os.path.relpath(os.path.join(folder, name), root)
                  for top in (".", "docs", "docs/decisions") for folder in [os.path.join(root, top)]
                  if os.path.isdir(folder) for name in sorted(os.listdir(folder)) if name.endswith(".md")]
    return [name for name in listed if os.path.exists(os.path.join(root, name))]


def lines_of(file):
    with open(file, encoding="utf-8") as text:
        return text.read().split("\n")


def is_code(lines):
    """Of each line: whether it stands in a fence or in an indented block."""
    out, is_fenced, is_indented, before, in_entry = [], False, False, "", False
    for line in lines:
        if FENCE.match(line):
            is_fenced = not is_fenced
            out.append(True)
        else:
            in_entry = bool(ENTRY.match(line)) or (in_entry and (not line.strip() or line.startswith(" ")))
            if line.strip():
                is_indented = line.startswith("    ") and not in_entry and (not before.strip() or is_indented)
            out.append(is_fenced or is_indented)
        before = line
    return out


def words_of(text):
    """Words, with spans of code and their blanks as one."""
    return re.findall(r"(?:`[^`]*`|[^\s`]|`)+", text)


def laid_out(words, first, rest):
    """Lines of these words, the first of which begins with `first`, the others with `rest`."""
    lines, now = [], []
    for word in words:
        start = rest if lines else first
        if now and len(start) + len(" ".join(now + [word])) > MOST_COLUMNS:
            carried = [word]
            while len(now) > 1 and BEGINS_ANOTHER.match(carried[0]):
                carried.insert(0, now.pop())
            lines.append(start + " ".join(now))
            now = carried
        else:
            now.append(word)
    return lines + [(rest if lines else first) + " ".join(now)]


def wrapped(lines):
    code = is_code(lines)
    out, block = [], []

    def end_block():
        if any(len(line) > MOST_COLUMNS for line in block):
            entry = ENTRY.match(block[0])
            first = entry[0] if entry else re.match(r"\s*", block[0])[0]
            words = words_of(" ".join([block[0][len(first):], *[line.strip() for line in block[1:]]]))
            out.extend(laid_out(words, first, " " * len(first)))
        else:
            out.extend(block)
        block.clear()

    for line, is_of_code in zip(lines, code):
        if is_of_code or not line.strip() or TABLE.match(line) or HEADING.match(line):
            end_block()
            out.append(line)
            continue
        if ENTRY.match(line) and block:
            end_block()
        block.append(line)
    end_block()
    return out


def anchors(lines):
    """What GitHub calls the headings."""
    found = set()
    for line, is_of_code in zip(lines, is_code(lines)):
        if HEADING.match(line) and not is_of_code:
            words = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip()).lower()
            found.add(re.sub(r"[^\w\- ]", "", words).replace(" ", "-"))
    return found


def cells(row):
    return len(re.findall(r"(?<!\\)\|", row))


def problems_of(root, name):
    file = os.path.join(root, name)
    lines = lines_of(file)
    head = None
    for number, (line, is_of_code) in enumerate(zip(lines, is_code(lines)), 1):
        is_row = bool(TABLE.match(line)) and not is_of_code
        if len(line) > MOST_COLUMNS and not is_row:
            yield f"{name}:{number}: {len(line)} columns, at most {MOST_COLUMNS}: scripts/documents.py wrap {name}"
        if is_row and head and cells(line) != cells(head):
            yield f"{name}:{number}: a row of {cells(line) - 1} cells below a head of {cells(head) - 1}"
        head = (head or line) if is_row else None
    plain = "\n".join("" if is_of_code else re.sub(r"`[^`]*`", "", line) for line, is_of_code in zip(lines, is_code(lines)))
    for target in re.findall(r"\]\(([^)\s]+)\)", plain):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        other = os.path.normpath(os.path.join(os.path.dirname(file), path)) if path else file
        if not os.path.exists(other):
            yield f"{name}: links to {target}, which is not there"
        elif anchor and anchor not in anchors(lines_of(other)):
            yield f"{name}: links to {target}, where no heading is called so"


def problems_of_decisions(root, names):
    seen = {}
    for name in names:
        found = re.match(r"docs/decisions/(\d{4})-", name)
        if not found:
            continue
        number = int(found[1])
        if number in seen:
            yield f"{name}: decision {number} is {seen[number]}"
        seen[number] = name
        if not lines_of(os.path.join(root, name))[0].startswith(f"# {number}. "):
            yield f"{name}: its heading has another number"


def check(root):
    names = documents(root)
    found = [problem for name in names for problem in problems_of(root, name)] + list(problems_of_decisions(root, names))
    print("\n".join(found) if found else f"{len(names)} documents, nothing wrong")
    return 1 if found or not names else 0


def wrap(root, names):
    for name in names or documents(root):
        file = os.path.join(root, name) if not os.path.isabs(name) else name
        lines = lines_of(file)
        new = wrapped(lines)
        if new != lines:
            with open(file, "w", encoding="utf-8", newline="\n") as out:
                out.write("\n".join(new))
    return 0


def main(words):
    if words[:1] == ["check"] and len(words) <= 2:
        return check(os.path.abspath(words[1]) if len(words) == 2 else ROOT)
    if words[:1] == ["wrap"]:
        return wrap(ROOT, words[1:])
    print(__doc__, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
