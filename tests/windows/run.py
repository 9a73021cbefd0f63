#!/usr/bin/env python3
"""Tries under Wine what the preset `windows` has built: python3 tests/windows/run.py. Wine's own folder is a new one, its
display a virtual one, and OpenGL comes from Mesa in software."""
import csv
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hip_path"))
from hip_paths import DESKTOP, MOST_A, ROOT, hand, hold_against_the_desktop  # noqa: E402

BUILT = ROOT / "build" / "windows"
PROGRAM = BUILT / "moltact" / "moltact.exe"
PICTURES = BUILT / "pictures"  # what was seen, for a person to look at
WINE = shutil.which("wine64") or "/usr/lib/wine/wine64"  # where Debian has it
SIZE = (640, 400)
VIEW = (700, 150, 400, 400)  # width, height and corner of a part of the window that shows the molecule


def there(path):
    """A path of this system as a program under Wine names it."""
    return "Z:" + str(path).replace("/", "\\")


def colours(picture, *changed):
    """The bytes red, green, blue of each pixel."""
    return subprocess.run(["convert", picture, *changed, "-depth", "8", "rgb:-"], check=True, capture_output=True).stdout


def apart(one, other, *changed):
    """How far two pictures are apart in the mean (of 255), and the share of their bytes that differ by more than 16."""
    a, b = colours(one, *changed), colours(other, *changed)
    if len(a) != len(b):
        raise AssertionError(f"{one} and {other} differ in size")
    differences = [abs(x - y) for x, y in zip(a, b)]
    return sum(differences) / len(a), sum(d > 16 for d in differences) / len(a)


def shown(picture, *changed):
    """The share of pixels that have another colour than most."""
    bytes_of = colours(picture, *changed)
    pixels = [bytes_of[k:k + 3] for k in range(0, len(bytes_of), 3)]
    return 1 - pixels.count(max(set(pixels), key=pixels.count)) / len(pixels)


class UnderWine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-wine-"))
        reading, writing = os.pipe()
        cls.display = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                                       pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        number = os.read(reading, 16).decode().strip()
        os.environ.update(WINEPREFIX=str(cls.folder / "wine"), WINEDEBUG="-all", DISPLAY=f":{number}", MOLTACT_LANGUAGE="en")
        PICTURES.mkdir(exist_ok=True)

    @classmethod
    def tearDownClass(cls):
        server = pathlib.Path(WINE).with_name("wineserver64")
        subprocess.run([server if server.exists() else "wineserver", "-k"], stderr=subprocess.DEVNULL)
        cls.display.terminate()
        cls.display.wait()
        shutil.rmtree(cls.folder, ignore_errors=True)

    def moltact(self, *arguments, status=0):
        done = subprocess.run([WINE, PROGRAM, *arguments], capture_output=True, timeout=300)
        self.assertEqual(done.returncode, status, done.stderr.decode(errors="replace"))
        return (done.stdout + done.stderr).decode()

    def desktop(self, *arguments, status=0):
        done = subprocess.run([DESKTOP, *arguments], capture_output=True, timeout=300)
        self.assertEqual(done.returncode, status, done.stderr.decode(errors="replace"))
        return (done.stdout + done.stderr).decode()

    def test_a_hand_over_ubiquitin_gives_the_desktops_contacts_to_1e_9_A_in_exact_and_paper(self):
        hold_against_the_desktop(self, [WINE, BUILT / "moltact_hip_path.exe"])

    def test_info_and_check_say_what_they_say_on_the_desktop(self):
        for command in (["info", "1ubq"], ["info", "1ubq", "--json"], ["info", "2hhb"], ["--help"], ["render", "--help"]):
            self.assertEqual(self.moltact(*command), self.desktop(*command))
        lessons = [ROOT / "lessons" / name for name in ("first-touch.md", "first-touch.de.md", "bond-or-contact.md")]
        self.assertEqual(self.moltact("check", *map(there, lessons)), self.desktop("check", *lessons))

    def test_what_is_wrong_is_said_and_given_as_the_status(self):
        self.assertIn("there is no such file", self.moltact("info", there(self.folder / "none.pdb"), status=1))
        self.moltact("render", status=2)

    def test_replay_feels_what_it_feels_on_the_desktop(self):
        seed = random.randrange(1 << 30)
        print(f"seed {seed}")
        path = self.folder / "path.csv"
        path.write_text("x,y,z\n" + "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in hand(random.Random(seed))[:1500]))
        for method in ("exact", "grid04", "mesh320"):
            rows = []
            for run, named in ((self.moltact, there), (self.desktop, str)):
                out = self.folder / f"{run.__name__}.csv"
                run("replay", "1ubq", "--path", named(path), "--out", named(out), "--method", method)
                rows.append(list(csv.reader(out.open()))[1:])
            self.assertEqual(len(rows[0]), len(rows[1]))
            most = max((abs(float(a) - float(b)) for ours, theirs in zip(*rows) for a, b in zip(ours, theirs) if a != b),
                       default=0.0)
            print(f"{method}: {len(rows[0])} ticks, farthest apart {most:.2g}")
            self.assertLessEqual(most, MOST_A)

    def test_names_outside_ascii_are_read_written_and_told(self):
        file = self.folder / "Größe µ 蛋白.pdb"
        shutil.copy(ROOT / "molecules" / "1ubq.pdb", file)
        self.assertIn("602", self.moltact("info", there(file)))
        missing = self.folder / "Übung 蛋白.pdb"
        self.assertIn("Übung 蛋白.pdb", self.moltact("info", there(missing), status=1))
        out = self.folder / "Bücher 蛋白.glb"
        self.moltact("export", there(file), there(out))
        self.assertEqual(out.read_bytes()[:4], b"glTF")

    def test_a_picture_without_a_window_is_the_desktops(self):
        drawn = []
        for run, named in ((self.moltact, there), (self.desktop, str)):
            drawn.append(PICTURES / f"render-{run.__name__}.png")
            run("render", "1ubq", "--out", named(drawn[-1]), "--size", "{}x{}".format(*SIZE), "--label",
                'residue for residue 48', "--legend")
        self.assertGreater(shown(drawn[0]), 0.2)
        mean, share = apart(*drawn)
        print(f"render: {mean:.3f} of 255 apart in the mean, {share:.3%} by more than 16")
        self.assertLess(mean, 0.5)
        self.assertLess(share, 0.002)

    def test_a_script_in_the_windows_application_draws_what_it_draws_on_the_desktop(self):
        drawn = []
        for run, named in ((self.moltact, there), (self.desktop, str)):
            drawn.append(PICTURES / f"script-{run.__name__}.png")
            run(named(ROOT / "lessons" / "first-touch.md"), "--screenshot", named(drawn[-1]), "--size", "1280x800", "--script",
                named(ROOT / "docs" / "pictures" / "ubiquitin.script"))
        mean, share = apart(*drawn)
        print(f"script: {mean:.3f} of 255 apart in the mean, {share:.3%} by more than 16")
        self.assertLess(mean, 1.0)
        self.assertLess(share, 0.01)

    def test_the_window_opens_a_lesson_shows_its_molecule_and_goes_when_it_is_closed(self):
        offscreen, seen = PICTURES / "window-desktop.png", PICTURES / "window.png"
        lesson = ROOT / "lessons" / "first-touch.md"
        self.desktop(lesson, "--screenshot", offscreen, "--size", "1280x800")
        running = subprocess.Popen([WINE, PROGRAM, there(lesson)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        try:
            until = time.monotonic() + 120
            window = ""
            while not window and time.monotonic() < until:
                self.assertIsNone(running.poll(), "the program ended before its window was there")
                window = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Moltact$"], capture_output=True,
                                        text=True).stdout.split("\n")[0]
                time.sleep(0.5)
            self.assertTrue(window, "no window came")
            share = 0.0
            while share < 0.3 and time.monotonic() < until:
                time.sleep(2)
                subprocess.run(["import", "-window", window, seen], check=True)
                share = shown(seen, "-crop", "{}x{}+{}+{}".format(*VIEW), "+repage")
            print(f"window: {share:.1%} of its view is not background")
            self.assertGreater(share, 0.3)
            subprocess.run(["xdotool", "windowfocus", window, "key", "ctrl+q"], check=True)
            self.assertEqual(running.wait(60), 0)
        finally:
            if running.poll() is None:
                running.kill()
            running.stderr.close()


if __name__ == "__main__":
    unittest.main(verbosity=2)
