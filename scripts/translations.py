#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The window's texts in other languages.

    scripts/translations.py update   bring hmi/translations/*.ts up to the sources: new texts come in unfinished,
                                     those that no source has any more go
    scripts/translations.py check    say what is missing, left over, or differs in its %1, %2 ...; exit code 1 then

One catalogue a language, without contexts: the same English words are the same words everywhere. Qt's lupdate is not
used because it finds neither the texts of the part without Qt, phrase("..."), nor the profile's explanations.
Qt Linguist opens the files.
"""

import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CATALOGUES = ROOT / "hmi" / "translations"
CONTEXT = "psicarve"

STRING = r'"(?:[^"\\\n]|\\.)*"'
STRINGS = rf"(?:{STRING}\s*)+"
COMMENT = re.compile(rf"(?P<keep>{STRING}|'(?:[^'\\\n]|\\.)')|//[^\n]*|/\*.*?\*/", re.DOTALL)
# tr("..."), phrase("..."), translate("context", "..."), text("...") of the tables below.
CALL = re.compile(rf"\b(?:tr|phrase)\(\s*({STRINGS})|\btranslate\(\s*{STRING}\s*,\s*({STRINGS})")
# A choice between two texts.
CHOICE = re.compile(rf"\b(?:tr|phrase)\(\s*[^;\"]*?\?\s*({STRINGS}):\s*({STRINGS})")
# A list of texts that are translated where they are shown.
MARKED = re.compile(rf"\bPSICARVE_TEXT\(\s*({STRINGS})\)")
EXPLANATION = re.compile(rf"\b\w+\.(?:number|word)\([^;]*?({STRINGS})\);")
PIN_EXPLANATION = re.compile(rf"\bis_output\(\w+\)\s*\?\s*({STRINGS}):\s*({STRINGS});")
CORE_NAMES = re.compile(r"\b(?:name|remedy)_of\((?:AlarmCause|MachineState|CommandKind|RealtimeStep).*?\n}", re.DOTALL)

# What joins sentences: Chinese has a colon and a semicolon of its own.
WITHOUT_WORDS = {"%1: %2", "%1: %2; %3"}

SIMPLE_ESCAPES = {"n": "\n", "t": "\t", '"': '"', "\\": "\\", "'": "'"}


def unescaped(found):
    if found.group(1):
        return chr(int(found.group(1), 16))
    return SIMPLE_ESCAPES.get(found.group(2), found.group(2))


def unquoted(literals):
    text = "".join(part[1:-1] for part in re.findall(STRING, literals))
    return re.sub(r"\\u([0-9a-fA-F]{4})|\\(.)", unescaped, text)


def without_comments(source):
    return COMMENT.sub(lambda found: found.group("keep") or " ", source)


def texts_in(path):
    source = without_comments(path.read_text(encoding="utf-8"))
    for pattern in (CALL, CHOICE, MARKED):
        for found in pattern.finditer(source):
            for literals in found.groups():
                if literals:
                    yield unquoted(literals)


def source_texts():
    """All texts, each once, in the order of the alphabet."""
    texts = set()
    for folder in ("gcode", "phrase", "profile", "program", "replay", "scene", "session", "ui"):
        for path in sorted((ROOT / "hmi" / folder).rglob("*.[ch]pp")):
            texts.update(texts_in(path))
    table = without_comments((ROOT / "shared" / "profile" / "profile_table.cpp").read_text(encoding="utf-8"))
    for pattern in (EXPLANATION, PIN_EXPLANATION):
        texts.update(unquoted(literals) for found in pattern.finditer(table) for literals in found.groups())
    names = "".join(without_comments((ROOT / "shared" / name).read_text(encoding="utf-8"))
                    for name in ("machine/machine_state_text.cpp", "machine/command.cpp", "computer/realtime_step.cpp"))
    for found in CORE_NAMES.finditer(names):
        texts.update(unquoted(literals) for literals in re.findall(STRINGS, found.group(0)))
    return sorted(text for text in texts if re.search(r"[A-Za-z]{2}", text) or text in WITHOUT_WORDS)


def read_catalogue(path):
    """Text -> translation; an unfinished one is empty."""
    known = {}
    for message in ElementTree.parse(path).getroot().iter("message"):
        translation = message.find("translation")
        is_done = translation is not None and translation.get("type") is None
        known[message.findtext("source")] = (translation.text or "") if is_done else ""
    return known


def write_catalogue(path, texts, known):
    root = ElementTree.Element("TS", version="2.1", language=path.stem.split("_", 1)[1], sourcelanguage="en")
    context = ElementTree.SubElement(root, "context")
    ElementTree.SubElement(context, "name").text = CONTEXT
    for text in texts:
        message = ElementTree.SubElement(context, "message")
        ElementTree.SubElement(message, "source").text = text
        translation = ElementTree.SubElement(message, "translation")
        translation.text = known.get(text, "")
        if not translation.text:
            translation.set("type", "unfinished")
    ElementTree.indent(root, space="    ")
    body = ElementTree.tostring(root, encoding="unicode")
    path.write_text(f'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n{body}\n', encoding="utf-8")


def marks_of(text):
    return sorted(re.findall(r"%[0-9n]", text))


def problems_of(path, texts):
    known = read_catalogue(path)
    for text in texts:
        translation = known.get(text, "")
        if not translation:
            yield f"not translated: {text!r}"
        elif marks_of(text) != marks_of(translation):
            yield f"other marks than in the original: {text!r}: {translation!r}"
        elif text.endswith("…") != translation.endswith("…"):
            yield f"… at the end of one of them alone: {text!r}: {translation!r}"
    for text in sorted(set(known) - set(texts)):
        yield f"in no source any more: {text!r}"


def main(arguments):
    if arguments not in (["update"], ["check"]):
        print(__doc__, file=sys.stderr)
        return 2
    texts = source_texts()
    count = 0
    for path in sorted(CATALOGUES.glob("psicarve_*.ts")):
        if arguments == ["update"]:
            write_catalogue(path, texts, read_catalogue(path))
        for problem in problems_of(path, texts):
            print(f"{path.relative_to(ROOT)}: {problem}")
            count += 1
    print(f"{len(texts)} texts, {count} problems")
    return 1 if count and arguments == ["check"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
