# SPDX-License-Identifier: GPL-3.0-or-later
"""What the window's package gives a desktop, as `cmake --install` puts it: entry, icon, AppStream data, kinds of files.

usage: desktop_test.py BUILD_FOLDER SOURCE_FOLDER
"""
import configparser
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml

# The profile of the user who runs this has no say.
os.environ["PSICARVE_PROFILE"] = ""
os.environ["PSICARVE_STATE"] = ""
SOURCE = pathlib.Path(sys.argv.pop(2)).resolve()
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
ID = "org.psicarve.hmi"
LANGUAGES = ["ru", "zh_CN"]


def run(*command, **more):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **more)


class Desktop(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.share = pathlib.Path(cls.temporary.name) / "share"
        done = run("cmake", "--install", BUILD, "--prefix", cls.temporary.name, "--component", "hmi")
        assert done.returncode == 0, done.stderr
        cls.environment = {**os.environ, "XDG_DATA_HOME": f"{cls.temporary.name}/home",
                           "XDG_DATA_DIRS": f"{cls.share}:/usr/share"}
        done = run("update-mime-database", cls.share / "mime", env=cls.environment)
        assert (done.returncode, done.stderr) == (0, ""), done.stderr

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def entry(self):
        parser = configparser.ConfigParser(interpolation=None, strict=True)
        parser.optionxform = str
        parser.read(self.share / "applications" / f"{ID}.desktop")
        return parser["Desktop Entry"]

    def test_the_entry_is_valid_and_starts_the_window(self):
        done = run("desktop-file-validate", "--warn-kde", self.share / "applications" / f"{ID}.desktop")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        entry = self.entry()
        program = entry["Exec"].split()[0]
        self.assertTrue((pathlib.Path(self.temporary.name) / "bin" / program).is_file())
        self.assertTrue((self.share / "icons" / "hicolor" / "scalable" / "apps" / f"{entry['Icon']}.svg").is_file())
        for language in LANGUAGES:
            for key in ("GenericName", "Comment", "Keywords"):
                self.assertNotEqual(entry[f"{key}[{language}]"], entry[key])
        self.assertIn(f'setDesktopFileName("{ID}")', (SOURCE / "hmi" / "ui" / "program.cpp").read_text())

    def test_the_appstream_data_is_valid_and_of_this_version(self):
        path = self.share / "metainfo" / f"{ID}.metainfo.xml"
        done = run("appstreamcli", "validate", "--no-net", "--pedantic", path)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotRegex(done.stdout, r"(?m)^[EWIP]: ")
        root = xml.parse(path).getroot()
        version = re.search(r"project\(psicarve VERSION ([0-9.]+)", (SOURCE / "CMakeLists.txt").read_text())[1]
        self.assertEqual(root.find("releases/release").get("version"), version)
        self.assertEqual(root.find("launchable").text, f"{ID}.desktop")
        self.assertEqual(root.find("summary").text, self.entry()["Comment"])

    def test_the_entry_opens_the_kinds_that_the_package_defines(self):
        root = xml.parse(self.share / "mime" / "packages" / f"{ID}.xml").getroot()
        kinds = {child.get("type") for child in root}
        opened = set(self.entry()["MimeType"].strip(";").split(";"))
        self.assertLess(kinds, opened)
        space = "{http://www.freedesktop.org/standards/shared-mime-info}"
        for kind in root:
            languages = [comment.get("{http://www.w3.org/XML/1998/namespace}lang") for comment in kind.findall(f"{space}comment")]
            self.assertEqual(languages, [None, *LANGUAGES])

    def kind_of(self, path):
        done = run("gio", "info", "-a", "standard::content-type", path, env=self.environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        return re.search(r"standard::content-type: (\S+)", done.stdout)[1]

    def test_jobs_snapshots_and_traces_are_recognised_by_name_and_content(self):
        folder = pathlib.Path(self.temporary.name)
        job, snapshot, trace = folder / "a.job", folder / "b.snap", folder / "c.trace"
        psicarve = BUILD / "bin" / "psicarve"
        done = run(psicarve, "slice", SOURCE / "examples" / "small.stl", "-o", job, "--layers", "4", "--points", "4")
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run(psicarve, "replay", job, "--trace", trace)
        self.assertEqual(done.returncode, 0, done.stderr)
        segment = f"/psicarve-desktop-test-{os.getpid()}"
        try:
            self.assertEqual(run(psicarve, "carve", job, "--segment", segment).returncode, 0)
            self.assertEqual(run(psicarve, "snapshot", "save", snapshot, "--segment", segment).returncode, 0)
        finally:
            pathlib.Path(f"/dev/shm{segment}").unlink(missing_ok=True)
        for path, kind in ((job, "job"), (snapshot, "snapshot"), (trace, "trace")):
            self.assertEqual(self.kind_of(path), f"application/x-psicarve-{kind}")
            without_ending = folder / path.stem
            shutil.copy(path, without_ending)
            self.assertEqual(self.kind_of(without_ending), f"application/x-psicarve-{kind}")
        # Packages of Ubuntu end in .snap, too.
        other = folder / "other.snap"
        other.write_bytes(b"hsqs" + bytes(2000))
        self.assertNotEqual(self.kind_of(other), "application/x-psicarve-snapshot")


if __name__ == "__main__":
    unittest.main()
