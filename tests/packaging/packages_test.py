# SPDX-License-Identifier: GPL-3.0-or-later
"""The Debian packages, made of what is built already: Debian's own judge, and an installation below a folder.

usage: packages_test.py BUILD_FOLDER SOURCE_FOLDER
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

# The profile of the user who runs this has no say.
os.environ["PSICARVE_PROFILE"] = ""
os.environ["PSICARVE_STATE"] = ""
SOURCE = pathlib.Path(sys.argv.pop(2)).resolve()
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
NAMES = ["psicarve", "psicarve-core", "psicarve-hmi"]
# What maintainer scripts, debhelper's among them, would ask of the computer that the test runs on.
ASKED_OF_THE_COMPUTER = ["systemctl", "deb-systemd-invoke", "udevadm", "modprobe", "invoke-rc.d"]
PROGRAMS = {"psicarve": "psicarve", "psicarve-core": "psicarve-rtcore", "psicarve-hmi": "psicarve-hmi"}


def run(*command, **more):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=500, **more)


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.output = pathlib.Path(cls.temporary.name) / "packages"
        done = run(SOURCE / "packaging" / "build_packages.sh", "--from", BUILD, "--output", cls.output)
        assert done.returncode == 0, done.stderr
        cls.files = {path.name.split("_")[0]: path for path in cls.output.glob("*.deb")}
        cls.version = re.search(r"project\(psicarve VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def field(self, package, name):
        return run("dpkg-deb", "--field", self.files[package], name).stdout.strip()

    def test_three_packages_of_this_version_need_what_they_link(self):
        self.assertEqual(sorted(self.files), NAMES)
        for name in NAMES:
            self.assertEqual(self.field(name, "Version"), self.version)
        needs = {name: self.field(name, "Depends") for name in NAMES}
        self.assertIn("libqt6widgets6", needs["psicarve-hmi"])
        self.assertIn("libcairo2", needs["psicarve"])
        for library in ("libqt6", "libcairo"):
            self.assertNotIn(library, needs["psicarve-core"])
        self.assertNotIn("libqt6", needs["psicarve"])
        self.assertIn("psicarve-core", self.field("psicarve", "Recommends"))

    def test_debian_finds_nothing_wrong(self):
        done = run("lintian", "--no-cfg", "--allow-root", "--tag-display-limit", "0", "--fail-on", "error,warning",
                   *sorted(self.files.values()))
        self.assertEqual((done.returncode, done.stdout), (0, ""))

    def dpkg(self, root, *arguments):
        # No account of this computer is changed: below the folder, without its libraries, by a root who is none.
        stubs = pathlib.Path(self.temporary.name) / "stubs"
        stubs.mkdir(exist_ok=True)
        for name in ASKED_OF_THE_COMPUTER:
            (stubs / name).write_text(f'#!/bin/sh\necho "{name} $*" >>"{stubs}/asked"\n')
            (stubs / name).chmod(0o755)
        # A user's PATH on Debian is without the folders that dpkg looks for its programs in.
        path = f"{stubs}:{os.environ['PATH']}:/usr/sbin:/sbin"
        return run("fakeroot", "dpkg", f"--root={root}", "--force-script-chrootless", "--force-depends", "--no-triggers",
                   "--force-not-root", f"--log={root}/log",
                   # Whatever this computer leaves out of what it installs.
                   "--path-include=/usr/share/*", *arguments, env={**os.environ, "LC_ALL": "C.UTF-8", "PATH": path})

    def test_they_install_run_and_go_without_a_trace(self):
        root = pathlib.Path(self.temporary.name) / "root"
        for folder in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "etc", "run"):
            (root / folder).mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        done = self.dpkg(root, "--install", *self.files.values())
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        # An upgrade has systemd read the service anew; below a folder it is no matter of this computer's.
        self.assertIn("systemctl --system daemon-reload", (root / "var/lib/dpkg/info/psicarve-core.postinst").read_text())
        self.assertFalse((pathlib.Path(self.temporary.name) / "stubs" / "asked").exists())
        for package, program in PROGRAMS.items():
            said = run(root / "usr/bin" / program, "--version")
            self.assertEqual(said.returncode, 0, said.stderr)
            self.assertIn(self.version, said.stdout)
            self.assertTrue((root / "usr/share/man/man1" / f"{program}.1.gz").is_file())
            self.assertTrue((root / "usr/share/bash-completion/completions" / program).is_file())
            self.assertTrue((root / "usr/share/doc" / package / "copyright").is_file())
        # The core beside it is its own, found as it is on a computer.
        done = run(root / "usr/bin/psicarve", "carve", SOURCE / "examples/small.stl", "--layers", "4", "--points", "4",
                   "--segment", f"/psicarve-packages-test-{os.getpid()}")
        self.assertEqual(done.returncode, 0, done.stderr)
        pathlib.Path(f"/dev/shm/psicarve-packages-test-{os.getpid()}").unlink(missing_ok=True)
        self.look_at_the_computer_of_a_machine(root)
        kept = root / "var/lib/psicarve/psicarve.checkpoint"
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.touch()
        done = self.dpkg(root, "--purge", *NAMES)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        left = [str(path) for path in root.rglob("*psicarve*") if path.is_file()]
        self.assertEqual(left, [])

    def look_at_the_computer_of_a_machine(self, root):
        self.assertRegex((root / "etc/passwd").read_text(), r"(?m)^psicarve:")
        self.assertRegex((root / "etc/group").read_text(), r"(?m)^psicarve:")
        service = (root / "lib/systemd/system/psicarve-rtcore.service").read_text()
        self.assertIn("\nExecStart=/usr/bin/psicarve-rtcore ", service)
        # A user who has a port enables it.
        self.assertEqual(list(root.rglob("*.wants")), [])
        self.assertIn("GROUP=\"psicarve\"", (root / "lib/udev/rules.d/60-psicarve.rules").read_text())
        self.assertIn("@psicarve - rtprio", (root / "etc/security/limits.d/psicarve.conf").read_text())

    def test_the_script_says_what_it_cannot_do(self):
        script = SOURCE / "packaging" / "build_packages.sh"
        self.assertEqual(run(script, "--form", BUILD).returncode, 2)
        self.assertEqual(run(script, "--from").returncode, 2)
        empty = run(script, "--from", self.temporary.name)
        self.assertEqual(empty.returncode, 1)
        self.assertIn("has no bin/psicarve", empty.stderr)


if __name__ == "__main__":
    unittest.main()
