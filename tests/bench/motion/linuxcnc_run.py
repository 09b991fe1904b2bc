# SPDX-License-Identifier: GPL-3.0-or-later
"""Has LinuxCNC run a program, headless, in simulation, and records its commanded positions."""

import os
import pathlib
import pwd
import subprocess
import tempfile

import linuxcnc_config as config

SERVO_S = 0.001


def run(program, speeds, limit_s):
    """Commanded positions of the three axes, one entry a servo tick; speeds: (speed, acceleration) of each."""
    with tempfile.TemporaryDirectory(prefix="layer-time-") as folder:
        files = {
            "machine.ini": config.ini_text(speeds),
            "machine.hal": config.HAL,
            "layer.ngc": program,
            "operate.py": config.OPERATOR.format(limit_s=limit_s),
            "parameters.var": "",
            "tools.tbl": "",
        }
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.write_text(text)
            path.chmod(0o755)
        command = ["timeout", str(limit_s + 60), "linuxcnc", "-r", "machine.ini"]
        environment = dict(os.environ, HOME=folder)
        if os.geteuid() == 0:
            nobody = pwd.getpwnam("nobody")
            for path in (folder, *pathlib.Path(folder).iterdir()):
                os.chown(path, nobody.pw_uid, nobody.pw_gid)
            command = ["runuser", "-u", "nobody", "--", "env", f"HOME={folder}"] + command
        done = subprocess.run(
            command, cwd=folder, env=environment, capture_output=True, text=True, stdin=subprocess.DEVNULL
        )
        outcome = pathlib.Path(folder, "outcome.txt")
        if not outcome.exists() or outcome.read_text() != "finished":
            raise RuntimeError("LinuxCNC did not finish:\n" + (done.stdout + done.stderr)[-2000:])
        return read_samples(pathlib.Path(folder, "samples.txt"))


def read_samples(path):
    samples = []
    for line in path.read_text().splitlines():
        if "overrun" in line:
            raise RuntimeError("LinuxCNC ran faster than its positions could be recorded")
        words = line.split()
        if len(words) >= 3:
            samples.append(tuple(map(float, words[:3])))
    return samples


def carving_part(samples):
    """From the last position of the rest before the first point to the first position of the rest after the last."""
    moving = [i for i in range(1, len(samples)) if samples[i] != samples[i - 1]]
    gaps = [after - before for before, after in zip(moving, moving[1:])]
    start = moving[gaps.index(max(gaps)) + 1]
    return samples[start - 1 : moving[-1] + 1]
