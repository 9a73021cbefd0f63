#!/usr/bin/env python3
"""Tries under Wine what the preset `windows` has built: python3 tests/windows/run.py. Wine's own folder is a new one."""
import os
import pathlib
import shutil
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "trace"))
from traces import ROOT, hold_against_the_desktop  # noqa: E402

BUILT = ROOT / "build" / "windows"
WINE = shutil.which("wine64") or "/usr/lib/wine/wine64"  # where Debian has it


class UnderWine(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        given = os.environ.get("WINEPREFIX")
        cls.folder = None if given else tempfile.mkdtemp(prefix="moltact-wine-")
        os.environ.update(WINEPREFIX=given or cls.folder, WINEDEBUG="-all")

    @classmethod
    def tearDownClass(cls):
        if cls.folder:
            shutil.rmtree(cls.folder, ignore_errors=True)

    def test_a_hand_over_ubiquitin_gives_the_desktops_trace_to_1e_9_A_in_exact_and_paper(self):
        hold_against_the_desktop(self, [WINE, BUILT / "moltact_trace.exe"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
