#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How fast the layers of a job can be carved at best: a yardstick for the look-ahead planner, in other code.

usage: reference_time.py JOB.csv PROFILE.toml [--layers A-B] [--bending] [--halvings N] [--json]

JOB.csv is what `psicarve snapshot export JOB --format csv` prints, PROFILE.toml what `psicarve profile show` prints.
Every layer is solved by itself, from rest to rest: links between layers are not part of it. Two times are given, that
of the curve of least bending in the tolerance's tube, and the least over all curves in it that was found; both with
the fastest timing the axes' limits and the feed allow, and both on grids refined until halving the cells changes less
than 0.3 %.
"""

import argparse
import dataclasses
import json
import sys

from layer_time import least_layer_time
from least_bending import NoCurve
from machine_limits import read_layers, read_limits


def layer_range(text):
    first, _, last = text.partition("-")
    return range(int(first), int(last or first) + 1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("job")
    parser.add_argument("profile")
    parser.add_argument("--layers", type=layer_range, help="A-B or A: only these, counted from 0")
    parser.add_argument("--bending", action="store_true", help="only the curve of least bending")
    parser.add_argument("--halvings", type=int, default=5, help="at most; default 5")
    parser.add_argument("--json", action="store_true")
    options = parser.parse_args()
    limits = read_limits(options.profile)
    found = []
    for layer in read_layers(options.job, limits):
        if options.layers is not None and layer.number not in options.layers:
            continue
        try:
            found.append(least_layer_time(layer, limits, halvings=options.halvings, bending_only=options.bending))
        except NoCurve as error:
            sys.exit(f"reference_time.py: {error}")
        if not options.json:
            say(found[-1])
    if options.json:
        total = sum(layer.seconds for layer in found)
        print(json.dumps({"seconds": total, "layers": [dataclasses.asdict(layer) for layer in found]}))


def say(layer):
    print(
        f"layer {layer.layer}: {layer.points} points, {layer.seconds:.4f} s, along the curve of least bending "
        f"{layer.bending_seconds:.4f} s ({layer.cells} cells, last halving {100.0 * layer.change:.2f} %)",
        flush=True,
    )


if __name__ == "__main__":
    main()
