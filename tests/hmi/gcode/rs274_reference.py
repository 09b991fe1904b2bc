# SPDX-License-Identifier: GPL-3.0-or-later
"""Canonical motion of LinuxCNC's interpreter, as psicarve's --canon writes it, and random programs to compare.

usage: rs274_reference.py write [--rs274 FILE]
       rs274_reference.py compare --psicarve FILE [--rs274 FILE] [--count N] [--seed N] [--flow]

write    makes tests/data/gcode/reference/ anew from tests/data/gcode/good/
compare  runs random valid programs through both and tells every difference; exit code 1 if there is one;
         --flow: programs with parameters, expressions and O words

rs274 comes with Debian's linuxcnc-uspace. It need not be installed: unpack the package and what it links with
`dpkg-deb -x`, and name the folder of its libraries in LD_LIBRARY_PATH.
"""
import argparse
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

from rs274_flow import RandomFlow

DATA = pathlib.Path(__file__).resolve().parents[2] / "data" / "gcode"
CALL = re.compile(r"^\s*\d+\s+N\S*\s+([A-Z0-9_]+)\((.*)\)$")
# What both sides tell alike: number and kind of these are compared.
KINDS = {"rapid", "feed", "arc", "dwell", "speed", "spindle", "tool", "tool_change", "stop", "end"}
TOLERANCE_MM = 0.0003
TOLERANCE_INCH_MM = 0.004


def rs274_calls(rs274, program, skips_deleted=False):
    with tempfile.TemporaryDirectory() as folder:
        tools = pathlib.Path(folder, "tool.tbl")
        tools.write_text("".join(f"T{n} P{n} Z0 D1\n" for n in range(1, 10)))
        pathlib.Path(folder, "sim.var").touch()
        words = [rs274, "-g", "-t", tools, "-v", pathlib.Path(folder, "sim.var")] + (["-b"] if skips_deleted else [])
        done = subprocess.run([str(w) for w in words + [program]], capture_output=True, text=True, timeout=20,
                              stdin=subprocess.DEVNULL, cwd=folder)
    calls, said = [], []
    for line in done.stdout.splitlines():
        found = CALL.match(line)
        if found:
            calls.append((found[1], found[2]))
    for line in done.stderr.splitlines():
        if line != "executing":
            said.append(line)
    return calls, said


class Machine:
    """Follows what rs274 tells, which is in program coordinates and units, and places it."""

    def __init__(self):
        self.mm = 1.0
        self.origin, self.shift, self.tool = [0.0] * 6, [0.0] * 6, [0.0] * 6
        self.turn = 0.0
        self.place = [0.0] * 6
        self.feed, self.per_turn, self.rpm = (0.0, 0.0), False, 0.0
        self.plane = "XY"
        self.is_on = False
        self.records = []

    def lengths(self, numbers):
        return [n * (self.mm if i < 3 else 1.0) for i, n in enumerate(numbers[:6])]

    def to_machine(self, program):
        at = [p + s for p, s in zip(program, self.shift)]
        angle = math.radians(self.turn)
        x, y = at[0], at[1]
        at[0], at[1] = x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)
        return [a + o + t for a, o, t in zip(at, self.origin, self.tool)]

    def feed_to(self, end):
        least_mm = TOLERANCE_MM if self.mm == 1.0 else TOLERANCE_INCH_MM
        is_linear = any(abs(a - b) > least_mm for a, b in zip(end[:3], self.place[:3]))
        is_rotary = any(abs(a - b) > 1e-9 for a, b in zip(end[3:], self.place[3:]))
        number = self.feed[0] if is_rotary and not is_linear else self.feed[1]
        return number * (self.rpm if self.per_turn else 1.0)

    def move(self, kind, program, **more):
        end = self.to_machine(program)
        record = {"k": kind, "end": end}
        if kind != "rapid":
            record["f"] = self.feed_to(end)
        record.update(more)
        self.place = end
        self.records.append(record)

    def arc(self, n):
        axes = {"XY": (0, 1, 2), "ZX": (2, 0, 1), "YZ": (1, 2, 0)}[self.plane]
        program, centre = [0.0] * 6, [0.0] * 6
        for axis, value in zip(axes, (n[0], n[1], n[5])):
            program[axis] = centre[axis] = value * self.mm
        centre[axes[0]], centre[axes[1]] = n[2] * self.mm, n[3] * self.mm
        program[3:6] = n[6:9]
        placed = self.to_machine(centre)
        self.move("arc", program, plane=self.plane, ctr=[placed[axes[0]], placed[axes[1]]], rot=int(n[4]))

    def spindle(self, word):
        if word == "off" and not self.is_on:
            return
        self.is_on = word != "off"
        self.records.append({"k": "spindle", "dir": word})

    def take(self, name, text, following):
        n = [float(x) for x in re.findall(r"[-+]?\d+\.?\d*", text)]
        if name == "USE_LENGTH_UNITS":
            self.mm = 25.4 if "INCHES" in text else 1.0
        elif name == "SET_G5X_OFFSET":
            self.origin = self.lengths(n[1:])
        elif name == "SET_G92_OFFSET":
            self.shift = self.lengths(n)
        elif name == "USE_TOOL_LENGTH_OFFSET":
            self.tool = self.lengths(n)
        elif name == "SET_XY_ROTATION":
            self.turn = n[0]
        elif name == "SELECT_PLANE":
            self.plane = {"XY": "XY", "XZ": "ZX", "YZ": "YZ"}[text[-2:]]
        elif name == "SET_FEED_MODE":
            self.per_turn = n[1] == 1
        elif name == "SET_FEED_RATE":
            self.feed = (n[0], n[0] * self.mm)
        elif name == "STRAIGHT_TRAVERSE":
            self.move("rapid", self.lengths(n))
        elif name == "STRAIGHT_FEED":
            self.move("feed", self.lengths(n))
        elif name == "ARC_FEED":
            self.arc(n)
        elif name == "DWELL":
            self.records.append({"k": "dwell", "s": n[0]})
        elif name == "SET_SPINDLE_SPEED":
            self.rpm = n[1]
            self.records.append({"k": "speed", "rpm": n[1]})
        elif name.startswith("START_SPINDLE"):
            self.spindle("cw" if name.endswith("_CLOCKWISE") else "ccw")
        elif name == "STOP_SPINDLE_TURNING" and following != "SET_SPINDLE_MODE":  # that is M2's
            self.spindle("off")
        elif name == "SELECT_TOOL":
            self.records.append({"k": "tool", "t": n[0]})
        elif name == "CHANGE_TOOL":
            self.records.append({"k": "tool_change", "t": n[0]})
        elif name == "PALLET_SHUTTLE" and following != "PROGRAM_STOP":
            pass  # M30's
        elif name in ("OPTIONAL_PROGRAM_STOP", "PALLET_SHUTTLE"):
            self.records.append({"k": "stop", "why": "optional" if name[0] == "O" else "pallet"})
        elif name == "PROGRAM_STOP" and self.records[-1].get("why") != "pallet":
            self.records.append({"k": "stop", "why": "program"})
        elif name == "PROGRAM_END":
            self.records.append({"k": "end"})


def reference_of(rs274, program, skips_deleted=False):
    """Records, and what rs274 complained of."""
    for _ in range(5):  # two that run at once may end without a word
        calls, said = rs274_calls(rs274, program, skips_deleted)
        if calls or said:
            break
    machine = Machine()
    for at, (name, text) in enumerate(calls):
        machine.take(name, text, calls[at + 1][0] if at + 1 < len(calls) else "")
    return machine.records, said


def rounded(value):
    if isinstance(value, float):
        return round(value, 6) + 0.0
    return [rounded(v) for v in value] if isinstance(value, list) else value


def write(rs274):
    for program in sorted((DATA / "good").glob("*.ngc")):
        records, said = reference_of(rs274, program, program.name.startswith("deleted"))
        if program.read_text().count("%") == 2:
            records.append({"k": "end"})  # rs274 leaves without a word
        if said or not records or records[-1]["k"] != "end":
            sys.exit(f"{program.name}: {said} {records[-1:]}")
        lines = (json.dumps({k: rounded(v) for k, v in r.items()}, separators=(",", ":")) for r in records)
        (DATA / "reference" / f"{program.stem}.canon").write_text("\n".join(lines) + "\n")
        print(f"{program.name}: {len(records)} records")


def ours_of(psicarve, program):
    done = subprocess.run([psicarve, "gcode", "check", "--canon", "--no-machine", program], capture_output=True,
                          text=True, timeout=20)
    records = [r for r in map(json.loads, done.stdout.splitlines()) if r["k"] in KINDS]
    is_on, kept = False, []
    for record in records:
        if record["k"] == "spindle":
            if record["dir"] == "off" and not is_on:
                continue
            is_on = record["dir"] != "off"
        kept.append(record)
    return kept, done.stderr


def numbers(record, key):
    value = record.get(key, [])
    return value if isinstance(value, list) else [value]


def difference(ours, theirs, tolerance_mm):
    for at, (a, b) in enumerate(zip(ours, theirs)):
        for key in ("k", "plane", "rot", "dir", "why", "t"):
            if a.get(key) != b.get(key):
                return f"record {at}: {key}: {a} | {b}"
        for key in ("end", "ctr", "s", "rpm"):
            if any(abs(x - y) > tolerance_mm for x, y in zip(numbers(a, key), numbers(b, key))):
                return f"record {at}: {key}: {a} | {b}"
        if b.get("f") in (0.1, 0.1 * 25.4) and a["f"] < b["f"]:
            continue  # under G93 rs274 feeds at least 0.1 units a minute
        if abs(a.get("f", 0.0) - b.get("f", 0.0)) > max(tolerance_mm, 2e-3 * abs(b.get("f", 0.0))):
            return f"record {at}: f: {a} | {b}"
    return None if len(ours) == len(theirs) else f"{len(ours)} | {len(theirs)} records"


class RandomProgram:
    """Valid blocks: those that rs274 and psicarve both take, but for the deviations of docs/gcode.md."""

    def __init__(self, chance):
        self.chance = chance
        self.mm, self.is_incremental, self.absolute_centres = 1.0, False, False
        self.is_inverse, self.is_turned, self.plane = False, False, "XY"
        self.has_inches = False
        self.may_turn = chance.random() < 0.5  # else G92: rs274 loses its place where both meet
        # rs274 does not convert a tool's length to new units, and loses its place at M6 alone
        self.may_measure = chance.random() < 0.5
        self.lines = ["G21 G90 G94 F200", "S500"]

    def number(self, low, high):
        return f"{self.chance.uniform(low, high) / self.mm:.{self.chance.choice((1, 2, 3))}f}"

    def axes(self, letters, low=-40.0, high=40.0):
        kept = [x for x in letters if self.chance.random() < 0.7] or [letters[0]]
        self.chance.shuffle(kept)
        return " ".join(x + self.number(low, high) for x in kept)

    def feed(self):
        if self.is_inverse:
            return f" F{self.chance.uniform(0.5, 9):.2f}"
        return f" F{self.chance.uniform(50, 900) / self.mm:.1f}" if self.chance.random() < 0.2 else ""

    def straight(self):
        rotary = self.chance.random() < 0.2
        self.lines.append(self.chance.choice(("G0 ", "G1 ", "g1")) + self.axes("XYZABC" if rotary else "XYZ") + self.feed())

    def arc_by_radius(self):
        first, second = {"XY": "XY", "ZX": "ZX", "YZ": "YZ"}[self.plane]
        if self.is_turned and self.plane != "XY":
            return
        a, b = self.chance.uniform(1, 20), self.chance.uniform(1, 20)
        radius = math.hypot(a, b) / 2 * self.chance.uniform(1.1, 3) * self.chance.choice((1, 1, -1))
        across = ({"XY": "Z", "ZX": "Y", "YZ": "X"}[self.plane] + self.number(-5, 5)) if self.chance.random() < 0.3 else ""
        turns = f" P{self.chance.randint(1, 3)}" if self.chance.random() < 0.3 else ""
        self.lines.append("G91" if not self.is_incremental else "G17 G91" if self.plane == "XY" else "G91")
        self.lines.append(f"{self.chance.choice(('G2', 'G3'))} {first}{a / self.mm:.4f} {second}{b / self.mm:.4f}"
                          f" {across} R{radius / self.mm:.4f}{turns}{self.feed()}")
        self.lines.append("G91" if self.is_incremental else "G90")

    def arc_by_centre(self):
        if self.is_turned and self.plane != "XY":
            return
        if self.absolute_centres:
            return
        first, second = self.plane
        letters = {"X": "I", "Y": "J", "Z": "K"}
        radius, begin, sweep = self.chance.uniform(2, 15), self.chance.uniform(0, 6.28), self.chance.uniform(0.3, 6)
        is_whole = self.chance.random() < 0.3
        c1, c2 = -radius * math.cos(begin), -radius * math.sin(begin)
        e1, e2 = c1 + radius * math.cos(begin + sweep), c2 + radius * math.sin(begin + sweep)
        words = [f"{letters[first]}{c1 / self.mm:.5f}", f"{letters[second]}{c2 / self.mm:.5f}"]
        if not is_whole:
            words += [f"{first}{e1 / self.mm:.5f}", f"{second}{e2 / self.mm:.5f}"]
        if self.chance.random() < 0.3:
            words.append({"XY": "Z", "ZX": "Y", "YZ": "X"}[self.plane] + self.number(-5, 5))
        if self.chance.random() < 0.3:
            words.append(f"P{self.chance.randint(1, 3)}")
        self.chance.shuffle(words)
        self.lines.append("G91")
        self.lines.append(self.chance.choice(("G2 ", "G3 ")) + " ".join(words) + self.feed())
        self.lines.append("G91" if self.is_incremental else "G90")

    def cycle(self):
        if self.is_inverse:
            return
        across = {"XY": "Z", "ZX": "Y", "YZ": "X"}[self.plane]
        clear, depth = self.chance.uniform(0, 10), self.chance.uniform(1, 12)
        bottom = -depth if self.is_incremental else clear - depth
        kind = self.chance.choice(("G81", "G82 P0.3", f"G83 Q{self.number(2, 5)}"))
        holes = f" L{self.chance.randint(1, 3)}" if self.chance.random() < 0.3 else ""
        self.lines.append(f"{self.chance.choice(('G98', 'G99'))} {kind} {self.axes(self.plane)} {across}{bottom / self.mm:.3f}"
                          f" R{clear / self.mm:.3f}{holes}")
        for _ in range(self.chance.randint(0, 3)):
            change = ""
            if not self.is_incremental and self.chance.random() < 0.4:  # another R and depth, or another kind
                clear = self.chance.uniform(0, 12)
                change = f" R{clear / self.mm:.3f} {across}{(clear - self.chance.uniform(1, 9)) / self.mm:.3f}"
                if self.chance.random() < 0.5:
                    change += self.chance.choice((" G81", " G82 P0.2", f" G83 Q{self.number(2, 5)}"))
            self.lines.append(self.chance.choice(("", "", "G98 ", "G99 ")) + self.axes(self.plane) + change)
            if self.may_measure and self.chance.random() < 0.2:
                self.lines.append(f"G43.1 {across}{self.number(-5, 5)}")
        self.lines.append("G80")

    def modes(self):
        words = ["G17", "G18", "G19", "G90", "G91", "G93", "G94", "G95"]
        word = self.chance.choice(words if self.may_measure else words + ["G20", "G21"])
        self.plane = {"G17": "XY", "G18": "ZX", "G19": "YZ"}.get(word, self.plane)
        self.is_incremental = {"G90": False, "G91": True}.get(word, self.is_incremental)
        self.is_inverse = {"G93": True, "G94": False, "G95": False}.get(word, self.is_inverse)
        self.mm = {"G20": 25.4, "G21": 1.0}.get(word, self.mm)
        self.has_inches = self.has_inches or self.mm != 1.0
        self.lines.append(word)
        if word in ("G94", "G20", "G21") and not self.is_inverse:
            self.lines.append("G94")
            self.lines.append(f"F{self.chance.uniform(50, 900) / self.mm:.1f}")
        if word == "G95":
            self.lines.append(f"F{self.chance.uniform(0.1, 0.9) / self.mm:.3f}")

    def offsets(self):
        kind = self.chance.randrange(7)
        if kind == 0:
            self.lines.append(f"G10 L2 P{self.chance.randint(0, 9)} {self.axes('XYZC')}")
        elif kind == 1:
            self.lines.append(f"G10 L20 P{self.chance.randint(0, 9)} {self.axes('XYZ')}")
        elif kind == 2:
            self.lines.append(self.chance.choice(("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")))
            self.is_turned = True
        elif kind == 3 and not self.may_turn:
            self.lines.append(f"G92 {self.axes('XYZA')}")
        elif kind == 4:
            self.lines.append(self.chance.choice(("G92.1", "G92.2", "G92.3")))
        elif kind == 5 and self.may_measure:
            self.lines.append(self.chance.choice((f"G43.1 {self.axes('XZ')}", "G49")))
        elif kind == 6 and self.may_turn:
            self.lines.append(f"G10 L2 P0 R{self.chance.choice((0, 15, 30, -45, 90))}")
            self.is_turned = True

    def places(self):
        words = ["G28", f"G28 {self.axes('XYZ')}", "G28.1", "G30", f"G30 {self.axes('XY')}", "G30.1"]
        if self.is_turned:
            words = ["G28", "G28.1", "G30", "G30.1"]
        if not self.is_incremental:
            words += [f"G53 G0 {self.axes('XYZ')}"]
            if not self.is_inverse:
                words += [f"G53 G1 {self.axes('XYZ')}"]
        self.lines.append(self.chance.choice(words))

    def others(self):
        self.lines.append(self.chance.choice(("M3", "M5", f"S{self.chance.randint(10, 3000)}", "G4 P0.5", "M8", "M9",
                                              "T2" if self.may_measure or self.may_turn else "T1 M6", "M0", "M1", "G61", "G61.1", "G64", f"G64 P{self.number(0.1, 1)}",
                                              "(comment)", "; comment", "", "M48", "M49", "T3")))

    def text(self):
        steps = [self.straight] * 6 + [self.arc_by_radius, self.arc_by_centre] * 2 + \
            [self.cycle, self.modes, self.modes, self.offsets, self.places, self.others, self.others]
        for _ in range(self.chance.randint(5, 40)):
            self.chance.choice(steps)()
        return "\n".join(self.lines + ["M2", ""])


def compare(psicarve, rs274, count, seed, kind):
    different = refused = 0
    for number in range(count):
        made = kind(random.Random(seed * 1_000_003 + number))
        with tempfile.NamedTemporaryFile("w", suffix=".ngc") as file:
            file.write(text := made.text())
            file.flush()
            theirs, said = reference_of(rs274, file.name)
            ours, errors = ours_of(psicarve, file.name)
        if said and errors:
            refused += 1
            continue
        found = f"only rs274 refuses: {said}" if said else f"only psicarve refuses: {errors}" if errors else \
            difference(ours, theirs, TOLERANCE_INCH_MM if made.has_inches else TOLERANCE_MM)
        if found:
            different += 1
            print(f"program {number}: {found}")
            pathlib.Path(tempfile.gettempdir(), f"gcode_different_{number}.ngc").write_text(text)
    print(f"{count} programs, {different} differ, {refused} refused by both")
    return 1 if different else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("write", "compare"))
    parser.add_argument("--rs274", default="rs274")
    parser.add_argument("--psicarve")
    parser.add_argument("--count", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--flow", action="store_const", const=RandomFlow, default=RandomProgram)
    given = parser.parse_args()
    if given.what == "write":
        return write(given.rs274)
    return compare(given.psicarve, given.rs274, given.count, given.seed, given.flow)


sys.exit(main())
