# SPDX-License-Identifier: GPL-3.0-or-later
"""Random programs with parameters, expressions and O words, as rs274 and psicarve both take them.

Not made, as LinuxCNC has them otherwise (docs/gcode.md): a label twice, break and continue in repeat, a continue with
a break of the same loop further down, break or continue beside a do loop, M98 L0, a subroutine behind its call by
name.
"""


class RandomFlow:
    has_inches = False

    def __init__(self, chance):
        self.chance = chance
        self.label = 0
        self.lines = []
        self.depth = 0
        self.names = ["a", "_all", "long name"]
        self.in_sub = False
        self.loops = chance.choice((("while", "repeat"), ("do", "while", "repeat")))

    def parameter(self):
        if self.chance.random() < 0.3:
            return f"#<{self.chance.choice(self.names)}>"
        return f"#{self.chance.choice((1, 2, 3, 31, 100, 4999))}"

    def number(self):
        return self.chance.choice((f"{self.chance.uniform(-20, 20):.2f}", str(self.chance.randint(0, 9)),
                                   f".{self.chance.randint(1, 9)}", f"{self.chance.randint(1, 30)}."))

    def value(self, depth=0):
        """What can stand behind a letter or an operator."""
        kind = self.chance.randrange(8)
        if depth > 3 or kind < 2:
            return self.number()
        if kind < 4:
            return self.parameter()
        if kind == 4:
            return self.chance.choice(("-", "+")) + self.chance.choice((self.parameter(), f"[{self.sum(depth + 1)}]"))
        if kind == 5:
            name = self.chance.choice(("ABS", "sin", "COS", "FIX", "FUP", "ROUND", "SQRT", "ATAN", "EXP", "LN", "ACOS"))
            inner = self.sum(depth + 1)
            if name == "SQRT":
                return f"SQRT[ABS[{inner}]]"
            if name == "LN":
                return f"LN[ABS[{inner}] + 1]"
            if name == "EXP":
                return f"EXP[SIN[{inner}]]"
            if name == "ACOS":
                return f"ACOS[COS[{inner}]]"
            if name == "ATAN":
                return f"ATAN[{inner}]/[{self.number()}]"
            return f"{name}[{inner}]"
        return f"[{self.sum(depth + 1)}]"

    def sum(self, depth=0):
        parts = [self.value(depth)]
        for _ in range(self.chance.randint(0, 3)):
            operator = self.chance.choice(("+", "-", "*", "/", " MOD ", " LT ", " gt ", " LE ", "GE", " AND ", " or ",
                                           " XOR ", "**"))
            if operator in ("/", " MOD "):
                parts += [operator, f"[ABS[{self.value(depth + 1)}] + 1.5]"]
            elif operator == "**":
                parts += ["+", f"[[{self.value(depth + 1)}] MOD 7] ** {self.chance.randint(0, 3)}"]
            else:
                parts += [operator, self.value(depth)]
        return "".join(parts)

    def short_sum(self):
        """rs274 reads lines of 256 bytes."""
        while len(made := self.sum()) > 50:
            pass
        return made

    def bounded(self):
        return f"[[{self.short_sum()}] MOD {self.chance.randint(20, 60)} - 10]"

    def motion(self):
        letters = [x for x in "XYZA" if self.chance.random() < 0.6] or ["X"]
        word = self.chance.choice(("G0", "G1", "G[0 + 1]", "G0 G90"))
        ends = (x + self.chance.choice((self.bounded, self.number, self.bounded))() for x in letters[:3])
        self.lines.append(f"{word} " + " ".join(ends))

    def assign(self):
        count = self.chance.choice((1, 1, 2))
        self.lines.append(" ".join(f"{self.parameter()} = {self.bounded()}" for _ in range(count)))

    def places(self):
        letter, which = self.chance.choice((("X", 5420), ("Y", 5421), ("Z", 5422), ("A", 5423)))
        name = f"#<_{letter.lower()}>" if self.chance.random() < 0.5 else f"#{which}"
        self.lines.append(f"G0 {letter}[{name} / 2 + {self.number()}]")

    def condition(self):
        return self.short_sum()

    def branch(self):
        self.label += 1
        label = self.label
        self.lines.append(f"o{label} if [{self.condition()}]")
        self.block()
        if self.chance.random() < 0.4:
            self.lines.append(f"o{label} elseif [{self.condition()}]")
            self.block()
        if self.chance.random() < 0.5:
            self.lines.append(f"o{label} else")
            self.block()
        self.lines.append(f"o{label} endif")

    def counted_loop(self):
        """Its count is a parameter that nothing else sets."""
        self.label += 1
        label, count = self.label, f"#{200 + self.label}"
        kind = self.chance.choice(self.loops)
        most = self.chance.randint(0, 4)
        self.lines.append(f"{count} = 0")
        self.lines.append({"while": f"O{label} while [{count} LT {most}]", "do": f"o{label} do",
                           "repeat": f"o{label} repeat [{most}]"}[kind])
        self.lines.append(f"{count} = [{count} + 1]")
        self.block()
        if kind == "while" and "do" not in self.loops and self.chance.random() < 0.4:
            self.label += 1
            self.lines += [f"o{self.label} if [{self.condition()}]", f"o{label} {self.chance.choice(('break', 'continue'))}",
                           f"o{self.label} endif"]
            self.block()
        self.lines.append({"while": f"o{label} endwhile", "do": f"o{label} while [{count} LT {most}]",
                           "repeat": f"o{label} endrepeat"}[kind])

    def call(self):
        if self.in_sub:
            return self.motion()
        values = " ".join(f"[{self.bounded()}]" for _ in range(self.chance.randint(0, 3)))
        self.lines.append(f"o<{self.chance.choice(('first', 'se cond'))}> call {values}")
        self.lines.append("G0 X[#<_value> + 1] Y#<_value_returned>")

    def call_by_number(self):
        if self.in_sub:
            return self.assign()
        self.lines.append(f"M98 P{self.chance.choice((900, 901))} L{self.chance.randint(1, 2)}")

    def block(self):
        self.depth += 1
        steps = [self.motion] * 4 + [self.assign] * 3 + [self.places]
        if self.depth < 4:
            steps += [self.branch, self.counted_loop, self.call]
        for _ in range(self.chance.randint(1, 3)):
            self.chance.choice(steps)()
        self.depth -= 1

    def subroutine(self, name):
        self.in_sub = True
        self.lines += [f"o<{name}> sub", "#<a> = #1"]
        self.lines.append("#<long name> = [#2 + #3]")
        self.block()
        if self.chance.random() < 0.5:
            self.label += 1
            self.lines += [f"o{self.label} if [{self.condition()}]", f"o<{name}> return [{self.bounded()}]",
                           f"o{self.label} endif"]
            self.block()
        self.lines.append(f"o<{name}> endsub" + self.chance.choice(("", f" [{self.bounded()}]")))
        self.in_sub = False

    def text(self):
        self.subroutine("first")
        self.subroutine("second")
        self.lines += ["G21 G90 G94 F200", "#<a> = 1 #<_all> = 2 #<longname> = 3"]
        steps = [self.motion, self.assign, self.places, self.branch, self.counted_loop, self.counted_loop, self.call,
                 self.call_by_number]
        for _ in range(self.chance.randint(3, 10)):
            self.chance.choice(steps)()
        self.lines.append("M2")
        for number in (900, 901):
            self.lines += [f"O{number}", f"G0 X[#1 MOD 9] Y{self.number()}", "#1 = [#1 + 1]", "M99"]
        return "\n".join(self.lines + [""])
