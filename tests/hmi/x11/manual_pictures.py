#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/operator.md and docs/window.md anew, from a real window on a screen of its own, driven
with mouse and keyboard, and a real core on the simulated machine.

    tests/hmi/x11/manual_pictures.py [BUILD] [FOLDER]    (build/dev, docs/pictures)

Needs what the tests of the window need (scripts/deps.sh test). Some two minutes. Look at them before they are kept.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
# Windows that fill the screen, without a frame.
MANAGER = """<?xml version="1.0"?><openbox_config xmlns="http://openbox.org/3.4/rc"><applications>
<application class="*"><decor>no</decor></application>
<application class="*" type="normal"><maximized>yes</maximized></application>
</applications></openbox_config>"""
PATIENCE_S = 300
MODEL_PAGE, LAYERS_PAGE, CARVING_PAGE, PORTS_PAGE, REALTIME_PAGE, _, PROFILE_PAGE = range(7)


class Place:
    """A screen, a core and a window."""

    def __init__(self, build, folder, scratch):
        self.build, self.folder, self.scratch = build, folder, scratch
        self.segment = f"/manual-{os.getpid()}"
        self.children = []
        screen = self.start(["Xvfb", "-displayfd", "1", "-screen", "0", "1280x720x24", "-nolisten", "tcp"],
                            stdout=subprocess.PIPE, text=True)
        self.environment = {**os.environ, "DISPLAY": ":" + screen.stdout.readline().strip(), "HOME": scratch,
                            "XDG_CONFIG_HOME": scratch, "XDG_RUNTIME_DIR": scratch, "LC_ALL": "C.UTF-8",
                            "QT_QPA_PLATFORM": "xcb", "PATH": build + "/bin:" + os.environ["PATH"],
                            "LIBGL_ALWAYS_SOFTWARE": "1"}
        rules = os.path.join(scratch, "openbox.xml")
        with open(rules, "w", encoding="utf-8") as file:
            file.write(MANAGER)
        self.start(["openbox", "--config-file", rules], env=self.environment)
        self.until("the window manager", lambda: self.xdotool("get_num_desktops") == 0)
        self.profile = os.path.join(scratch, "machine.toml")
        with open(self.profile, "w", encoding="utf-8") as file:
            subprocess.run([build + "/bin/psicarve", "profile", "show"], stdout=file, check=True)
        self.core = self.window = None

    def start(self, words, **how):
        how.setdefault("stderr", subprocess.DEVNULL)
        self.children.append(subprocess.Popen(words, **how))
        return self.children[-1]

    def end(self):
        for child in reversed(self.children):
            child.terminate()
            child.wait()
        subprocess.run(["rm", "-f", "/dev/shm" + self.segment], check=False)

    def xdotool(self, *words):
        return subprocess.run(["xdotool", *words], env=self.environment, check=False,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode

    @staticmethod
    def until(what, is_so):
        give_up = time.monotonic() + PATIENCE_S
        while not is_so():
            if time.monotonic() > give_up:
                sys.exit(f"gave up waiting for {what}")
            time.sleep(0.05)

    def start_core(self):
        self.core = self.start([self.build + "/bin/psicarve-rtcore", "--segment", self.segment,
                                "--clock", "virtual", "--profile", self.profile])
        self.until("the core", lambda: "state" in self.status())

    def status(self):
        told = subprocess.run([self.build + "/bin/psicarve", "status", "--json", "--segment", self.segment],
                              capture_output=True, text=True, check=False).stdout
        return json.loads(told) if told.startswith("{") else {}

    def reaches(self, state):
        self.until(state, lambda: self.status().get("state") == state)

    def open_window(self, *words):
        if self.window is not None:
            self.window.terminate()
            self.window.wait()
        self.window = self.start([self.build + "/tests/watched_hmi", "--segment", self.segment, "--opengl",
                                  "--profile", self.profile, *words], env=self.environment, stdin=subprocess.PIPE, text=True,
                                 stdout=subprocess.PIPE)
        self.until("the window", lambda: self.ask("where window").endswith(" ready"))

    def ask(self, question):
        self.window.stdin.write(question + "\n")
        self.window.stdin.flush()
        return self.window.stdout.readline().strip()

    def click(self, name, where=0.5, how="click"):
        self.until(name, lambda: self.ask("where " + name).endswith(" ready"))
        x, y, width = (int(word) for word in self.ask("where " + name).split()[:3])
        self.xdotool("mousemove", str(round(x + (where - 0.5) * width)), str(y), how, "1")
        if how == "click":
            self.let_go_of_mouse()

    def press(self, key):
        self.xdotool("key", key)

    def let_go_of_mouse(self):
        """To where it shows no tooltip."""
        self.xdotool("mousemove", "700", "25")

    def picture(self, name, part="", settling_s=1.5):
        """`settling_s`: what follows from the last click has been drawn by then."""
        time.sleep(settling_s)
        path = os.path.join(self.folder, name + ".png")
        if self.ask(f"picture {path} {part}".strip()) != "saved":
            sys.exit(f"{path} was not written")
        print(path, flush=True)


def by_hand(place):
    place.start_core()
    place.open_window()
    place.click("home")
    place.reaches("ready")
    place.click("arm_keys")
    place.picture("operator_keys")
    place.click("arm_keys")
    place.click("go_to")
    place.until("the dialog", lambda: place.ask("where move_go") != "none")
    place.picture("operator_go_to", "move_dialog")
    place.press("Escape")
    place.click(f"tab {PORTS_PAGE}")
    place.click("drives_off")
    place.reaches("off")
    place.click("arm_wiring")
    place.click("test_output")
    place.xdotool("type", "16")
    place.press("Return")
    place.click("hold_high", how="mousedown")
    place.reaches("testing")  # a busy computer has let go of it already: then once more, with less beside
    place.picture("operator_wiring")
    place.xdotool("mouseup", "1")
    place.click("arm_wiring")
    place.click(f"tab {REALTIME_PAGE}")
    place.click("check_computer")
    place.until("the rows", lambda: place.ask("where check_computer").endswith(" ready"))
    place.picture("operator_computer")
    place.click(f"tab {PROFILE_PAGE}")
    place.click("profile_calibrate")
    place.picture("operator_calibrate", "calibration_dialog")
    place.press("Escape")


def a_job(place):
    place.open_window(ROOT + "/examples/figurine.stl")
    place.click("slice")
    place.click("publish")
    place.click("home")
    place.reaches("ready")
    place.until("the plan", lambda: place.status().get("planned_seconds") is not None)
    place.picture("operator_model")
    place.click(f"tab {CARVING_PAGE}")
    place.click("start")
    # A virtual clock waits for no picture.
    place.until("a third", lambda: place.status().get("layer", 0) > 150)
    place.picture("window", settling_s=0.1)
    place.click(f"tab {LAYERS_PAGE}")
    place.picture("operator_layers", settling_s=0.4)
    place.click(f"tab {CARVING_PAGE}")
    place.press("F1")
    place.reaches("alarm")
    place.picture("operator_alarm")


def a_program(place):
    path = os.path.join(place.scratch, "pocket.ngc")
    with open(path, "w", encoding="utf-8") as program:
        program.write("G21 G90 G17\nG0 X48 Z48 Y10 C0\nM3\nG1 F400 X30\nG1 Y60 C720\nG2 X36 Y66 I6 J0\n"
                      "S8000\nG1 X44 Y40\nG1 X101\nG0 X48\nM5\nM2\n")
    place.start_core()
    place.open_window(path)
    place.click("home")
    place.reaches("ready")
    place.click("program_again")
    place.let_go_of_mouse()
    place.picture("program")


def a_replay(place):
    job, trace = (os.path.join(place.scratch, "owl." + kind) for kind in ("job", "trace"))
    psicarve = place.build + "/bin/psicarve"
    for words in (["slice", ROOT + "/examples/figurine.stl", "--layers", "250", "--points", "250", "-o", job],
                  ["carve", job, "--segment", place.segment + "-trace", "--trace", trace]):
        subprocess.run([psicarve, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    place.click("reset_alarm")
    place.reaches("off")
    place.core.terminate()
    place.core.wait()
    place.open_window(trace)
    place.click(f"tab {CARVING_PAGE}")
    place.click("timeline", where=0.55)
    place.until("the piece at that time", lambda: "/ 250" in place.ask("text carving_point"))
    place.picture("replay")


def main():
    words = sys.argv[1:]
    if len(words) > 2 or any(word.startswith("-") for word in words):
        sys.exit(__doc__)
    build = os.path.abspath(words[0] if words else ROOT + "/build/dev")
    folder = os.path.abspath(words[1] if len(words) > 1 else ROOT + "/docs/pictures")
    with tempfile.TemporaryDirectory() as scratch:
        place = Place(build, folder, scratch)
        try:
            by_hand(place)
            a_job(place)
            a_replay(place)
            a_program(place)
        finally:
            place.end()


if __name__ == "__main__":
    main()
