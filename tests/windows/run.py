#!/usr/bin/env python3
"""Tries under Wine what the preset `windows` has built: python3 tests/windows/run.py [Installed]"""
import collections
import csv
import os
import pathlib
import random
import shutil
import struct
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hip_path"))
from hip_paths import DESKTOP, MOST_A, ROOT, hand, hold_against_the_desktop  # noqa: E402
import wine  # noqa: E402
from installed_tests import Installed  # noqa: E402,F401
from wine import BUILT, PICTURES, PROGRAM, WINE, apart, shown, there  # noqa: E402

SIZE = (640, 400)


class UnderWine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        wine.begin()
        cls.folder = wine.FOLDER

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

    def test_a_tone_of_440_Hz_reaches_the_end_of_the_sound_card_at_440_Hz(self):
        config = self.folder / "alsa.conf"
        config.write_text(wine.ALSA)
        said = subprocess.run([WINE, BUILT / "moltact_tone.exe"], check=True, capture_output=True, timeout=120,
                              env=os.environ | {"ALSA_CONFIG_PATH": str(config)}).stdout.decode()
        self.assertTrue(said.startswith("playing"), said)
        self.assertGreater(int(said.split()[1]), 48000)
        left = [pair[0] for pair in struct.iter_unpack("<hh", wine.PLAYED.read_bytes())]
        self.assertAlmostEqual(max(left), 16384, delta=20)  # half of what a word holds
        rises = [k for k in range(1, len(left)) if left[k - 1] < 0 <= left[k]]
        self.assertGreater(len(rises), 440)
        # The most frequent period: where the computer stutters, others are longer.
        periods = collections.Counter(b - a for a, b in zip(rises, rises[1:]))
        period, often = periods.most_common(1)[0]
        print(f"tone: {len(rises)} periods, {often} of them of {period} samples")
        self.assertLess(abs(period - 48000 / 440), 1)

    def test_without_a_sound_card_the_sound_says_so(self):
        config = self.folder / "none.conf"
        config.write_text("")
        said = subprocess.run([WINE, BUILT / "moltact_tone.exe"], check=True, capture_output=True, timeout=120,
                              env=os.environ | {"ALSA_CONFIG_PATH": str(config)}).stdout.decode()
        self.assertEqual(said.strip(), "silent 0 There is no sound: this computer has no sound card that can be opened now.")

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
            window = wine.window_of_moltact(until, lambda: running.poll() is None)
            share = wine.show_molecule(window, seen, until)
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
