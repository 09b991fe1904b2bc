# SPDX-License-Identifier: GPL-3.0-or-later
"""The jobs of the motion benchmark: models, profiles, tables and single layers, made in a working folder."""

import dataclasses
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[2]
YARDSTICKS = {"reference": (ROOT / "tests" / "reference", "[!r]*.py"), "linuxcnc": (HERE, "linuxcnc*.py")}
NO_FEED_MM_S = 1000.0  # more than any axis does


@dataclasses.dataclass(frozen=True)
class Programs:
    psicarve: pathlib.Path
    job_from_csv: pathlib.Path

    @staticmethod
    def in_build(build):
        return Programs(build / "bin" / "psicarve", build / "tests" / "job_from_csv")


@dataclasses.dataclass(frozen=True)
class Machine:
    """A profile to carve with, and how finely models are sliced for it."""

    name: str
    profile: tuple  # words for the command line
    points: int


MACHINES = (
    Machine("default", (), 500),
    Machine("dense", (), 2400),  # the built-in profile: three points to four pulses of psi
    Machine("fine", ("--profile", str(ROOT / "examples" / "fine.toml")), 1000),
)


BAD_CARVINGS = (4, 6)  # exit codes of a carving that ended in an alarm, or was not as the job asks
found_wrong = []  # what verification said of such, in words


def run(*words, also_good=()):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    if done.returncode not in (0, *also_good):
        sys.exit(f"{' '.join(map(str, words))}\nended with {done.returncode}: {done.stderr}{done.stdout}")
    return done.stdout


def model_file(name, work, scan):
    """The mesh of a job; `scan` stands for a mesh file of the user's, if any."""
    if name == "figurine":
        return ROOT / "examples" / "figurine.stl"
    if name == "own-scan":
        return scan
    if name == "bunny":
        return bunny_file(work)
    path = work / f"{name}.stl"
    if not path.exists():
        run(sys.executable, "-B", HERE / "make_models.py", name, path)
    return path


def bunny_file(work):
    """The Stanford bunny, a real scan, out of Debian's glmark2-data: downloaded, never installed."""
    path = work / "bunny" / "usr" / "share" / "glmark2" / "models" / "bunny.obj"
    if not path.exists():
        with tempfile.TemporaryDirectory(dir=work) as folder:
            done = subprocess.run(["apt-get", "-qq", "download", "glmark2-data"], cwd=folder, capture_output=True, text=True)
            packages = list(pathlib.Path(folder).glob("glmark2-data_*.deb"))
            if done.returncode != 0 or not packages:
                sys.exit(f"bunny: glmark2-data cannot be downloaded (apt-get update?): {done.stderr}")
            run("dpkg-deb", "-x", packages[0], work / "bunny")
    return path


def profile_file(programs, machine, work, planner, feed_mm_s=None):
    text = run(programs.psicarve, "profile", "show", *machine.profile)
    text = re.sub(r'(?m)^planner = "\w+"', f'planner = "{planner}"', text)
    if feed_mm_s is not None:
        text = re.sub(r"(?m)^feed_mm_s = [0-9.]+", f"feed_mm_s = {feed_mm_s}", text)
    path = work / f"{machine.name}-{planner}{'' if feed_mm_s is None else '-no-feed'}.toml"
    path.write_text(text)
    return path


def table_file(programs, machine, work, name, layers, scan):
    """The whole job's table as CSV: every planner and every single layer starts from this one."""
    job, table = work / f"{name}-{machine.name}.job", work / f"{name}-{machine.name}.csv"
    words = ["--layers", layers, "--points", machine.points, *machine.profile]
    if name in ("own-scan", "bunny"):
        words += ["--height", "30", "--axis-at", "best"]
    if name == "bunny":
        words += ["--up", "y"]
    run(programs.psicarve, "slice", model_file(name, work, scan), "-o", job, *words)
    table.write_text(run(programs.psicarve, "snapshot", "export", job, "--format", "csv"))
    return table


def carve(programs, table, profile, work, layer=None):
    """What `replay --json` says after carving the table, or one layer of it, on the virtual clock.

    What was wrong with it goes to `found_wrong`.
    """
    job = work / "carved.job"
    run(programs.job_from_csv, table, profile, job, *([] if layer is None else [f"{layer}-{layer}"]))
    report = json.loads(run(programs.psicarve, "replay", job, "--json", also_good=BAD_CARVINGS))
    if report["alarms"] or report["verified"] is not True:
        part = "" if layer is None else f", layer {layer}"
        found_wrong.append(f"{table.stem}{part}, {profile.stem}: {report.get('error', report['alarms'])}")
    return report


def remembered(work, kind, inputs, compute):
    """compute() once for the same inputs (texts) and sources of the yardstick."""
    folder, pattern = YARDSTICKS[kind]
    parts = [*inputs, *(source.read_text() for source in sorted(folder.glob(pattern)))]
    digest = hashlib.sha256("\0".join(parts).encode()).hexdigest()[:24]
    path = work / f"{kind}-{digest}.json"
    if not path.exists():
        path.write_text(json.dumps(compute()))
    return json.loads(path.read_text())
