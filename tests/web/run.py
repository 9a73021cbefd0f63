#!/usr/bin/env python3
"""Tries the browser edition in headless Chromium as a student would: ./test.sh web, or
python3 tests/web/run.py [part of a test's name …]. Pictures of each page go to build/web/pictures."""
import pathlib
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "hip_path")]

if __name__ == "__main__":
    loader = unittest.TestLoader()
    if sys.argv[1:]:
        loader.testNamePatterns = [f"*{name}*" for name in sys.argv[1:]]
    suite = loader.discover(str(HERE), pattern="*_tests.py")
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
