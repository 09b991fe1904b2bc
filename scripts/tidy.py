#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs clang-tidy over the sources of shared/, rtcore/ and hmi/; what has passed once is not looked at again.

usage: tidy.py ROOT BUILD     BUILD holds compile_commands.json and a finished Ninja build

Of a unity build it looks at the units: five times quicker, for headers are read once a unit, but the static
analyser leaves out what a unit includes, and that is all of it. A build of one file a unit gets it all.

A file's stamp is a hash over .clang-tidy, this script, clang-tidy's version, the file's compile command, the contents of
the file and of all headers of ours that it includes (as Ninja recorded them), whichever folder ROOT is, and the sizes and
dates of all other headers. The stamps are kept in $XDG_CACHE_HOME/psicarve/tidy (~/.cache if unset), each until it has
not been asked for in sixty days, or in BUILD/tidy where nothing can be written there.
"""

import concurrent.futures
import contextlib
import hashlib
import json
import os
import subprocess
import sys
import tempfile
import time

TIDY = "clang-tidy-14"
CHECKED = ("shared", "rtcore", "hmi")
LONGEST_UNASKED_S = 60 * 24 * 3600


def recorded_headers(root, build):
    """Source file -> what its object depends on, below root and elsewhere, from Ninja's own record."""
    text = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    headers = {}
    for block in text.split("\n\n"):
        lines = [line.strip() for line in block.splitlines() if line.startswith("    ")]
        paths = [os.path.realpath(os.path.join(build, line)) for line in lines]
        ours = sorted(path for path in paths if path.startswith(root + os.sep))
        if ours:
            headers[os.path.realpath(os.path.join(build, lines[0]))] = ours, sorted(set(paths) - set(ours))
    return headers


def size_and_date_of(path):
    """Of a file that may be gone, since it was compiled with."""
    try:
        status = os.stat(path)
    except OSError:
        return b"gone"
    return f"{status.st_size} {status.st_mtime_ns}".encode()


def stamp_of(root, command, files, foreign, version):
    """The hash under which a clean verdict is remembered; of `foreign` files only size and date are looked at."""
    digest = hashlib.sha256()
    here = root.encode()  # in commands, and in units, which name what they include in full

    def add(text):
        digest.update(text.replace(here, b"ROOT") + b"\0")

    add(version.encode())
    add(command["command"].encode())
    for path in [os.path.join(root, ".clang-tidy"), os.path.realpath(__file__), *files]:
        add(path.encode())
        with open(path, "rb") as file:
            add(file.read())
    for path in foreign:
        add(path.encode())
        add(size_and_date_of(path))
    return digest.hexdigest()


def stamp_folder(build):
    """Where the stamps are; stamps that have not been asked for in a long time are removed."""
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    folder = os.path.join(cache, "psicarve", "tidy")
    try:
        os.makedirs(folder, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError:
        folder = os.path.join(build, "tidy")
        os.makedirs(folder, exist_ok=True)
    oldest = time.time() - LONGEST_UNASKED_S
    for entry in os.scandir(folder):
        with contextlib.suppress(OSError):  # another run was quicker
            if entry.stat().st_mtime < oldest:
                os.remove(entry.path)
    return folder


def has_passed(stamp):
    """Whether there is such a stamp, which has been asked for then."""
    with contextlib.suppress(OSError):
        os.utime(stamp)
        return True
    return False


def is_unit(path):
    """Whether it is a file that CMake made, which only includes sources of ours."""
    return os.path.basename(path).startswith("unity_")


def check(build, path):
    """clang-tidy's findings in one file or unit; empty when it is clean."""
    # The analyser, which looks at no function of a unit, looks long at what there is besides.
    left_out = ["--checks=-bugprone-suspicious-include,-clang-analyzer-*"] if is_unit(path) else []
    run = subprocess.run([TIDY, "--quiet", "-p", build, *left_out, path], capture_output=True, text=True)
    return "" if run.returncode == 0 else run.stdout + run.stderr


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    root, build = (os.path.realpath(path) for path in sys.argv[1:])
    with open(os.path.join(build, "compile_commands.json")) as file:
        commands = {os.path.realpath(entry["file"]): entry for entry in json.load(file)}
    version = subprocess.run([TIDY, "--version"], capture_output=True, text=True, check=True).stdout
    headers = recorded_headers(root, build)
    stamps = stamp_folder(build)

    def stamp(path):
        return stamp_of(root, commands[path], *headers.get(path, ([path], [])), version)

    todo = {}
    sources = sorted(
        path
        for path in commands
        if os.path.relpath(path, build if is_unit(path) else root).split(os.sep)[0] in CHECKED
    )
    for path in sources:
        before = stamp(path)
        if path not in headers or not has_passed(os.path.join(stamps, before)):
            todo[path] = before

    dirty = 0
    print(f"tidy: {len(sources)} files or units, {len(todo)} to look at", flush=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for path, findings in zip(todo, pool.map(lambda path: check(build, path), todo)):
            if findings:
                dirty += 1
                print(findings, flush=True)
            elif stamp(path) == todo[path]:  # unchanged meanwhile
                open(os.path.join(stamps, todo[path]), "w").close()
    print(f"tidy: {dirty} with findings")
    return 1 if dirty else 0


if __name__ == "__main__":
    sys.exit(main())
