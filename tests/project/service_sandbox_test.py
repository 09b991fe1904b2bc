#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The core does all its work with what the unit leaves it.

usage: service_sandbox_test.py UNIT BUILD EXAMPLES WORK

The real core and its guard, on a fake port of the kernel's driver and the real clock, are confined as systemd would
confine the service. The core homes, carves, ends in order; another one is killed, and its guard switches off. No call
is refused to any of them. Before that a program that does what the unit forbids shows that the sandbox is one.
"""

import grp
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import sandbox

# The profile of the user who runs this has no say.
os.environ["PSICARVE_PROFILE"] = ""
os.environ.pop("PSICARVE_STATE", None)
UNIT, BUILD, EXAMPLES, WORK = sys.argv[1:5]
STATE = os.path.join(WORK, "state")
os.environ["STATE_DIRECTORY"] = STATE
BIN = os.path.join(BUILD, "bin")
PATIENCE_S = 120
LIMITS = {"LimitRTPRIO", "LimitMEMLOCK"}
RUNNING = []
SEGMENT = f"/psicarve-sandbox-{os.getpid()}"
FORBIDDEN = """
import mmap, os, socket
def outcome(attempt):
    try: attempt()
    except OSError as error: return error.errno
    return 0
print(outcome(lambda: os.setuid(os.getuid())), outcome(socket.socket), outcome(lambda: open(%r, "w")), flush=True)
mmap.mmap(-1, 4096, prot=mmap.PROT_WRITE | mmap.PROT_EXEC)
"""


def expect(is_so, text):
    if not is_so:
        sys.exit(f"not so: {text}")


def eventually(attempt, text):
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        if attempt():
            return
        time.sleep(0.1)
    sys.exit(f"never: {text}")


def psicarve(*words):
    done = subprocess.run([os.path.join(BIN, "psicarve"), *words, "--segment", SEGMENT], capture_output=True, text=True)
    expect(done.returncode == 0, f"psicarve {' '.join(words)}: {done.stderr}")
    return done.stdout


def status():
    return json.loads(psicarve("status", "--json"))


def quick_machine():
    """A profile of a fast machine, homed where it stands, whose core counts late ticks and goes on."""
    text = subprocess.run([os.path.join(BIN, "psicarve"), "profile", "show", "--built-in"], capture_output=True, text=True,
                          check=True).stdout
    for key, value in {"period_us": "100.0", "missed_alarm_per_s": "0", "start_stop_mm_s": "0.008",
                       "start_stop_deg_s": "0.05", "home": '"none"', "pulses_per_mm": "100.0", "speed_mm_s": "40.0",
                       "accel_mm_s2": "400.0", "spindle_spinup_s": "0.1"}.items():
        text = re.sub(rf"(?m)^{key} = \S+", f"{key} = {value}", text)
    path = os.path.join(WORK, "machine.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


class Core:
    """With the unit's options but for places, and for the rights that no process here can give."""

    def __init__(self, confined, profile, port):
        environment = subprocess.run([os.path.join(BUILD, "tests", "fake_port_environment"), port, profile],
                                     capture_output=True, text=True, check=True).stdout
        found = dict(line.split("=", 1) for line in environment.splitlines())
        try:
            group = ["--group", grp.getgrgid(os.getegid()).gr_name]
        except KeyError:  # a container's, which has no name
            group = []
        rights = ["--allow-no-realtime"] if confined.left_out & LIMITS else []
        self.said = os.path.join(WORK, "core.err")
        with open(self.said, "w", encoding="utf-8") as said:
            self.guard = confined.start(
                [os.path.join(BIN, "psicarve-rtcore"), "--segment", SEGMENT, *group, "--port",
                 f"ppdev:{port}/parport0", "--profile", profile, "--capacity", "50x100", *rights],
                stderr=said, stdin=subprocess.DEVNULL, env={**os.environ, **found})
        RUNNING.append(self)
        eventually(lambda: self.ended() or self.is_ticking(), "the core ticks")
        expect(not self.ended(), f"the core lives: {self.words()}")

    def is_ticking(self):
        """Whatever an earlier core has left in the segment."""
        with open(self.said, encoding="utf-8") as said:
            return "real time:" in said.read() and self.children()

    def kill(self):
        for pid in [*self.children(), self.guard.pid]:
            os.kill(pid, signal.SIGKILL)
        self.guard.wait()

    def ended(self):
        return self.guard.poll() is not None

    def words(self):
        with open(self.said, encoding="utf-8") as said:
            return f"{self.guard.returncode}: {said.read()}"

    def children(self):
        with open(f"/proc/{self.guard.pid}/task/{self.guard.pid}/children", encoding="ascii") as children:
            return [int(child) for child in children.read().split()]

    def wait(self):
        eventually(self.ended, f"the guard ends: {self.words()}")
        return self.guard.returncode


def show_that_it_confines(confined):
    forbidden = os.path.join(WORK, "forbidden")
    probe = confined.start([sys.executable, "-c", FORBIDDEN % forbidden], stdout=subprocess.PIPE, text=True)
    said = probe.communicate(timeout=PATIENCE_S)[0].split()
    expect(said[:2] == ["1", "97"], f"EPERM and EAFNOSUPPORT: {said}")
    expect(("ProtectSystem" in confined.left_out) == (said[2] == "0"), f"the tree: {said[2]}, {confined.left_out}")
    expect(probe.returncode == -signal.SIGSYS, f"memory to write and execute: {probe.returncode}")
    expect(confined.refused == {"setuid"}, f"refused: {confined.refused}")
    confined.refused.clear()


def carve(confined, profile, port):
    core = Core(confined, profile, port)
    psicarve("publish", os.path.join(EXAMPLES, "small.stl"), "--profile", profile, "--layers", "2", "--points", "20")
    psicarve("home")
    psicarve("start", "--carve")
    eventually(lambda: status()["state"] == "ready", f"the job is carved: {status()['state']}")
    seen = status()
    expect(seen["points_done"] == seen["points_total"] > 0, f"all points: {seen['points_done']}")
    # What the kernel refuses without limits is no matter of the unit's, which sets them.
    allowed = {"memory locked", "real-time scheduling"} if confined.left_out & LIMITS else set()
    refused = set(seen["realtime_refused"]) - allowed - {"processors kept awake"}
    expect(not refused, f"real-time treatment: {refused}")
    kept = [os.path.join(STATE, SEGMENT[1:] + ending) for ending in (".checkpoint", ".journal")]
    eventually(lambda: len(os.listdir(STATE)) == 3 and all(map(os.path.exists, kept)),
               f"checkpoint, journal and job: {os.listdir(STATE)}")
    for path in kept:
        expect(os.stat(path).st_mode & 0o777 == 0o644, f"everybody reads {path}: {os.stat(path).st_mode:o}")
    core.guard.send_signal(signal.SIGTERM)
    expect(core.wait() == 0, f"it ends in order: {core.words()}")


def lose(confined, profile, port):
    core = Core(confined, profile, port)
    os.kill(core.children()[0], signal.SIGKILL)
    expect(core.wait() == 128 + signal.SIGKILL, f"the guard ends as its core did: {core.words()}")


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(STATE)
    confined = sandbox.Sandbox(UNIT, STATE)
    show_that_it_confines(confined)
    profile = quick_machine()
    # Where the unit lets the core write; the real port is a device, which no rule of folders is about.
    with tempfile.TemporaryDirectory(dir="/dev/shm") as port:
        try:
            carve(confined, profile, port)
            lose(confined, profile, port)
        finally:
            for core in RUNNING:
                if not core.ended():
                    core.kill()
            if os.path.exists("/dev/shm" + SEGMENT):
                os.unlink("/dev/shm" + SEGMENT)
    expect(not confined.refused, f"the core needs what the unit forbids: {', '.join(sorted(confined.refused))}")
    left_out = ", ".join(sorted(confined.left_out))
    print("confined as the unit says" + (f", but for what nobody may give here: {left_out}" if left_out else ""))


main()
