#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""pictures_test.py SOURCES PROGRAMS WORK: the scripts draw the pictures of docs/pictures anew, byte for byte.

After a change that moves pulses draw them anew (scripts/pictures/motion.py build/dev/bin), look at them, and commit them.
"""

import os
import shutil
import subprocess
import sys


def main(sources, programs, work):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    scripts = os.path.join(sources, "scripts", "pictures")
    for words in (["machine.py", os.path.join(work, "machine.svg")], ["motion.py", programs, work]):
        subprocess.run([sys.executable, "-B", os.path.join(scripts, words[0]), *words[1:]], check=True)
    wrong = []
    for name in ("machine.svg", "speed.svg", "corner.svg", "tick.svg"):
        with open(os.path.join(work, name), "rb") as drawn, \
                open(os.path.join(sources, "docs", "pictures", name), "rb") as committed:
            if drawn.read() != committed.read():
                wrong.append(name)
    for name in wrong:
        print(f"docs/pictures/{name} is not what its script draws: {os.path.join(work, name)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
