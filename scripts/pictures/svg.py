# SPDX-License-Identifier: GPL-3.0-or-later
"""A page of SVG with a title, readable on light and on dark paper. Lengths are in pixels; colours are names of COLOURS."""

from xml.sax.saxutils import escape

# name: on light paper, on dark paper
COLOURS = {"paper": ("#FFFFFF", "#14181D"), "ink": ("#1B1F24", "#E3E8EE"), "dim": ("#5B646E", "#9AA5B1"),
           "grid": ("#D9DDE2", "#323A43"), "r1": ("#0F62A8", "#6DB3F2"), "r2": ("#B4500A", "#F29B57"),
           "psi": ("#00785A", "#4CC9A0"), "y": ("#6B3FA0", "#BE98EE"), "limit": ("#B3261E", "#FF8A80"),
           "body": ("#E8D9BF", "#5A4A32"), "band": ("#DCE9F5", "#1F3448"), "steel": ("#C3CAD2", "#48525D")}


def number(value):
    """Two decimals at most, so that a file is short, and the same everywhere."""
    return f"{value:.2f}".rstrip("0").rstrip(".").replace("-0", "0") if abs(value) < 0.005 else \
        f"{value:.2f}".rstrip("0").rstrip(".")


class Page:
    def __init__(self, width, height, title):
        self.width, self.height, self.title = width, height, title
        self.parts = []

    def add(self, kind, fill=None, stroke=None, wide=1, inside=None, **attributes):
        classes = [f"f-{fill}" if fill else "f-none"] + ([f"s-{stroke}"] if stroke else [])
        if stroke:
            attributes["stroke-width"] = wide
        told = " ".join(f'{name.replace("_", "-")}="{number(value) if isinstance(value, float) else value}"'
                        for name, value in attributes.items())
        start = f'<{kind} class="{" ".join(classes)}" {told}'
        self.parts.append(f"{start}/>" if inside is None else f"{start}>{escape(inside)}</{kind}>")

    def text(self, x, y, words, fill="ink", anchor="start", size=13, **more):
        self.add("text", fill, x=float(x), y=float(y), text_anchor=anchor, font_size=size, inside=words, **more)

    def line(self, x1, y1, x2, y2, stroke="ink", wide=1, **more):
        self.add("line", None, stroke, wide, x1=float(x1), y1=float(y1), x2=float(x2), y2=float(y2), **more)

    def path(self, points, stroke="ink", wide=1.5, fill=None, is_closed=False, **more):
        way = "M" + " L".join(f"{number(x)} {number(y)}" for x, y in points) + ("Z" if is_closed else "")
        self.add("path", fill, stroke, wide, d=way, **more)

    def rect(self, x, y, width, height, fill, stroke=None, **more):
        self.add("rect", fill, stroke, x=float(x), y=float(y), width=float(width), height=float(height), **more)

    def circle(self, x, y, radius, fill=None, stroke=None, wide=1, **more):
        self.add("circle", fill, stroke, wide, cx=float(x), cy=float(y), r=float(radius), **more)

    def arrow(self, x1, y1, x2, y2, stroke="ink", wide=1.5, both=False):
        """A line with a head at its end, or at both."""
        self.line(x1, y1, x2, y2, stroke, wide)
        length = ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5
        along = ((x2 - x1) / length, (y2 - y1) / length)
        for (x, y), way in [((x2, y2), 1)] + ([((x1, y1), -1)] if both else []):
            back = (x - 8 * way * along[0], y - 8 * way * along[1])
            side = (3.5 * along[1], -3.5 * along[0])
            self.path([(x, y), (back[0] + side[0], back[1] + side[1]), (back[0] - side[0], back[1] - side[1])],
                      stroke, 1, stroke, True)

    def write(self, file):
        def rules(scheme):
            return "".join(f".f-{name}{{fill:{pair[scheme]}}}.s-{name}{{stroke:{pair[scheme]}}}"
                           for name, pair in COLOURS.items())
        with open(file, "w", encoding="utf-8", newline="\n") as out:
            out.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{self.width}" height="{self.height}" '
                      f'viewBox="0 0 {self.width} {self.height}" role="img" '
                      'font-family="DejaVu Sans, Verdana, sans-serif">\n'
                      f"<title>{escape(self.title)}</title>\n"
                      f"<style>{rules(0)}.f-none{{fill:none}}"
                      f"@media (prefers-color-scheme:dark){{{rules(1)}}}</style>\n"
                      f'<rect class="f-paper" width="{self.width}" height="{self.height}"/>\n')
            out.write("\n".join(self.parts) + "\n</svg>\n")


class Plot:
    """A rectangle of a page with linear axes."""

    def __init__(self, page, place, horizontal, vertical):
        self.page, self.place = page, place  # left, top, width, height
        self.horizontal, self.vertical = horizontal, vertical  # first and last value

    def x(self, value):
        return self.place[0] + self.place[2] * (value - self.horizontal[0]) / (self.horizontal[1] - self.horizontal[0])

    def y(self, value):
        return self.place[1] + self.place[3] * (self.vertical[1] - value) / (self.vertical[1] - self.vertical[0])

    def at(self, points):
        return [(self.x(a), self.y(b)) for a, b in points]

    def frame(self, across, up, name="", unit=""):
        """Lines and numbers at the values of both axes; the vertical axis' name stands above."""
        left, top, width, height = self.place
        for value in up:
            self.page.line(left, self.y(value), left + width, self.y(value), "grid")
            self.page.text(left - 7, self.y(value) + 4, f"{value:g}".replace("-", "−"), "dim", "end", 12)
        for value in across:
            self.page.line(self.x(value), top, self.x(value), top + height, "grid")
            self.page.text(self.x(value), top + height + 17, f"{value:g}".replace("-", "−"), "dim", "middle", 12)
        if unit:
            self.page.text(left + width, top + height + 34, unit, "dim", "end", 12)
        if name:
            self.page.text(left, top - 8, name, "ink", "start", 13)
