# SPDX-License-Identifier: GPL-3.0-or-later
"""Bash, zsh and fish complete our programs' command lines with the scripts of the build.

usage: shells_test.py BUILD_FOLDER
"""
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import unittest

# Profile, folder and shell of the user who runs this have no say.
os.environ["PSICARVE_PROFILE"] = ""
os.environ["PSICARVE_STATE"] = ""
for place in ("XDG_CONFIG_HOME", "XDG_DATA_HOME"):
    os.environ.pop(place, None)
BUILD = pathlib.Path(sys.argv.pop(1)).resolve()
PAGES = BUILD / "packaging" / "pages"
HERE = pathlib.Path(__file__).resolve().parent
# A line that ends where Tab is pressed, and all that is offered there among the test's files.
LINES = [
    ("psicarve sl", ["slice"]),
    ("psicarve snapshot ", ["diff", "export", "info", "save"]),
    ("psicarve slice --up ", ["x", "y", "z"]),
    ("psicarve slice --up=", ["x", "y", "z"]),
    ("psicarve slice a.stl --joi", ["--joining"]),
    ("psicarve --profile p.toml slice --joining ", ["continuous", "spiral", "zigzag"]),
    ("psicarve slice ", ["a.stl", "b.STL", "sub/"]),
    ("psicarve snapshot info ", ["c d.job", "sub/"]),
    ("psicarve profile check ", ["c d.job", "p.toml", "sub/"]),
    ("psicarve back-off ", ["psi", "r1", "r2", "y"]),
    ("psicarve home r1 r", ["r1", "r2"]),
    ("psicarve slice --tool b", ["ball:"]),
    ("psicarve calibrate --r1-at ", ["here"]),
    ("psicarve completion ", ["bash", "fish", "zsh"]),
    ("psicarve --group roo", ["root"]),
    ("psicarve-rtcore --clock ", ["real", "virtual"]),
    ("psicarve-rtcore --allow", ["--allow-no-realtime"]),
    ("psicarve-hmi --language ", ["en", "ru", "zh_CN"]),
    ("psicarve profile set p.", ["p.toml"]),
    ("psicarve profile set axis.r1.sp", ["axis.r1.speed_mm_s="]),
    ("psicarve profile set tool.shape=ball p.", ["p.toml"]),
]
# As people quote: fish offers what is behind what was typed.
FISH_LINES = LINES + [
    ("psicarve slice ~/", ["~/a.stl", "~/b.STL", "~/sub/"]),
    ("psicarve slice $HOME/", ["$HOME/a.stl", "$HOME/b.STL", "$HOME/sub/"]),
    ("psicarve snapshot info c\\ ", ["c d.job"]),
    ("psicarve snapshot info \"c ", ["c d.job"]),
    ("psicarve snapshot info \"c", ["c d.job"]),
    ("psicarve --profile=~/p", ["~/p.toml"]),
    ("psicarve profile set axis.r1.speed_mm_s=", ["axis.r1.speed_mm_s="]),
    ("psicarve --profile=", ["c d.job", "p.toml", "sub/"]),
]
# As bash splits it: there is no value to offer.
BASH_WORDS = LINES + [
    ("psicarve profile set axis.r1.speed_mm_s=", []),
    ("psicarve profile set axis.r1.speed_mm_s=p", []),
    ("psicarve slice --tool ball:", []),
    ("psicarve --profile=p", ["p.toml"]),
]
# What bash makes of a line when Tab is pressed at its end.
BASH_LINES = [
    ("psicarve snapshot info ~/c", "psicarve snapshot info ~/c\\ d.job "),
    ("psicarve snapshot info $HOME/c", "psicarve snapshot info $HOME/c\\ d.job "),
    ("psicarve snapshot info c\\ ", "psicarve snapshot info c\\ d.job "),
    ("psicarve snapshot info \"c", "psicarve snapshot info \"c d.job\" "),
    ("psicarve profile set axis.r1.speed_mm_s", "psicarve profile set axis.r1.speed_mm_s="),
    ("psicarve profile set axis.r1.speed_mm_s=", "psicarve profile set axis.r1.speed_mm_s="),
    ("psicarve profile set p.", "psicarve profile set p.toml "),
    ("psicarve profile set tool.shape=ball p.", "psicarve profile set tool.shape=ball p.toml "),
    ("psicarve profile set su", "psicarve profile set sub/"),
    ("psicarve slice --tool ball:", "psicarve slice --tool ball:"),
    ("psicarve slice --up=", "psicarve slice --up="),
]


def commands():
    """Every command of psicarve, as words, from the help pages themselves."""
    found = []

    def look(words):
        text = subprocess.run([BUILD / "bin" / "psicarve", *words, "--help"], capture_output=True, text=True, check=True).stdout
        if "\nSubcommands:\n" not in text:
            return
        for name in re.findall(r"^  ([a-z-]+)  ", text.split("\nSubcommands:\n")[1], re.M):
            found.append(words + [name])
            look(words + [name])

    look([])
    return found


class Shells(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        for name in ("a.stl", "b.STL", "c d.job", "p.toml", "x.txt"):
            (pathlib.Path(cls.folder.name) / name).touch()
        (pathlib.Path(cls.folder.name) / "sub").mkdir()
        os.environ["HOME"] = cls.folder.name

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def run_shell(self, arguments, text):
        done = subprocess.run(arguments, input=text, capture_output=True, text=True, cwd=self.folder.name, timeout=120,
                              env={**os.environ, "LC_ALL": "C.UTF-8"})
        self.assertEqual(done.stderr, "")
        self.assertEqual(done.returncode, 0)
        return done.stdout

    def test_bash(self):
        script = "".join(f"source {PAGES}/bash/{name}\n" for name in ("psicarve", "psicarve-rtcore", "psicarve-hmi"))
        for line, _ in BASH_WORDS:
            # As readline splits it.
            words = [word for word in re.split(r" |([=:])", line) if word is not None]
            words = [word for at, word in enumerate(words) if word or at == len(words) - 1]
            function = "_" + words[0].replace("-", "_")
            quoted = " ".join(f"'{word}'" for word in words)
            script += (f"COMP_WORDS=({quoted}); COMP_CWORD={len(words) - 1}; {function}\n"
                       "for reply in \"${COMPREPLY[@]}\"; do if [[ -d $reply ]]; then reply+=/; fi; printf '%s\\n' \"$reply\"; done\n"
                       "echo ==\n")
        answers = self.run_shell(["bash", "--norc"], script).split("==\n")
        for (line, wanted), answer in zip(BASH_WORDS, answers):
            with self.subTest(line=line):
                self.assertEqual(sorted(answer.splitlines()), sorted(wanted))

    def test_fish(self):
        script = "".join(f"source {PAGES}/fish/{name}.fish\n" for name in ("psicarve", "psicarve-rtcore", "psicarve-hmi"))
        script += "".join(f"complete -C '{line}'\necho ==\n" for line, _ in FISH_LINES)
        answers = self.run_shell(["fish", "--no-config"], script).split("==\n")
        for (line, wanted), answer in zip(FISH_LINES, answers):
            # Fish gives an option and its value as one word.
            got = [re.sub(r"^--[a-z0-9-]+=", "", row.split("\t")[0]) for row in answer.splitlines()]
            with self.subTest(line=line):
                self.assertEqual(sorted(got), sorted(wanted))

    def at_terminal(self, shell, setting, line, keys, **environment):
        """What the shell says from the line and the keys until END; it is set up by what prints READY."""
        pid, terminal = pty.fork()
        if pid == 0:
            os.chdir(self.folder.name)
            os.environ.update(LC_ALL="C.UTF-8", TERM="dumb", **environment)
            os.execvp(shell[0], shell)
        said = ""

        def read_until(word):
            nonlocal said
            while word not in said:
                if not select.select([terminal], [], [], 60)[0]:
                    self.fail(f"{shell[0]} says no {word}: {said}")
                try:
                    said += os.read(terminal, 65536).decode(errors="replace")
                except OSError:
                    self.fail(f"{shell[0]} has ended: {said}")

        os.write(terminal, f"{setting}\n".encode())
        read_until("READY\r\n")
        said = ""
        os.write(terminal, line.encode() + keys)
        read_until("END\r\n")
        os.close(terminal)
        os.waitpid(pid, 0)
        return said

    def zsh_offers(self, line):
        said = self.at_terminal(["zsh", "-f", "-i"], f"source {HERE}/zsh_completion.zsh", line, b"\t",
                                COMPLETIONS=str(PAGES / "zsh"))
        return {hit.rstrip("\r").replace("\\", "") for hit in re.findall(r"HIT:([^\n]*)\n", said) if hit.strip()}

    def test_bash_makes_of_a_line(self):
        for line, wanted in BASH_LINES:
            said = self.at_terminal(["bash", "--norc", "-i"], f"source {HERE}/bash_completion.bash", line, b"\t\x07",
                                    COMPLETIONS=str(PAGES / "bash"))
            with self.subTest(line=line):
                self.assertEqual(re.search(r"LINE<(.*)>", said)[1], wanted)

    def test_zsh(self):
        # A zsh for each line: those that differ in kind.
        for line, wanted in LINES[::2]:
            with self.subTest(line=line):
                # Of a folder it says that it is one in another way.
                self.assertEqual(self.zsh_offers(line), {word.rstrip("/") for word in wanted})

    def test_each_command_is_offered_by_every_shell(self):
        every = commands()
        self.assertGreater(len(every), 30)
        texts = {shell: (PAGES / shell / name).read_text()
                 for shell, name in (("bash", "psicarve"), ("zsh", "_psicarve"), ("fish", "psicarve.fish"))}
        for words in every:
            self.assertIn(f"command='{' '.join(words)}' ;;", texts["bash"])
            self.assertIn(f"\n_psicarve_{'_'.join(words).replace('-', '_')}() {{", texts["zsh"])
            self.assertIn(f" -a {words[-1]} -d ", texts["fish"])

    def test_the_program_prints_what_is_installed(self):
        for shell, name in (("bash", "psicarve"), ("zsh", "_psicarve"), ("fish", "psicarve.fish")):
            printed = subprocess.run([BUILD / "bin" / "psicarve", "completion", shell], capture_output=True, check=True).stdout
            self.assertEqual(printed, (PAGES / shell / name).read_bytes())

    def test_each_command_has_a_page_without_warnings(self):
        names = ["psicarve", "psicarve-rtcore", "psicarve-hmi"] + ["-".join(["psicarve", *words]) for words in commands()]
        self.assertEqual(sorted(path.stem for path in (PAGES / "man1").iterdir()), sorted(names))
        pages = [*(PAGES / "man1").iterdir(), *(PAGES / "man5").iterdir()]
        lint = subprocess.run(["mandoc", "-T", "lint", *pages], capture_output=True, text=True)
        self.assertEqual((lint.returncode, lint.stdout, lint.stderr), (0, "", ""))
        groff = subprocess.run(["groff", "-man", "-ww", "-z", "-Tutf8", *pages], capture_output=True, text=True)
        self.assertEqual((groff.returncode, groff.stderr), (0, ""))
        for path in pages:
            text = path.read_text()
            sections = re.findall(r"^\.SH (.*)$", text, re.M)
            self.assertEqual(sections[0], "NAME", path)
            if path.suffix == ".1":
                self.assertLessEqual({"SYNOPSIS", "DESCRIPTION", "OPTIONS", "EXIT STATUS", "SEE ALSO"}, set(sections), path)
        shown = subprocess.run(["man", "--warnings", "-l", PAGES / "man1" / "psicarve-slice.1"], capture_output=True, text=True,
                               env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "100"})
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        self.assertIn("--joining=continuous|zigzag|spiral", shown.stdout)

    def test_the_page_of_profiles_has_every_key(self):
        page = (PAGES / "man5" / "psicarve-profile.5").read_text()
        toml = subprocess.run([BUILD / "bin" / "psicarve", "profile", "show", "--built-in"], capture_output=True, text=True, check=True).stdout
        table = ""
        count = 0
        for line in toml.splitlines():
            if match := re.match(r"\[(.*)\]", line):
                table = match[1] + "."
            elif match := re.match(r"([a-z0-9_]+) *=", line):
                self.assertIn(f"\n\\fB{table}{match[1]}\\fR", page)
                count += 1
        self.assertGreater(count, 50)

    def test_help_of_the_window_on_a_full_disk_is_an_error(self):
        for option in ("--help", "--version"):
            with open("/dev/full", "w") as full:
                done = subprocess.run([BUILD / "bin" / "psicarve-hmi", option], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual((done.returncode, done.stderr),
                             (3, "psicarve-hmi: standard output: No space left on device\n"))


if __name__ == "__main__":
    unittest.main()
