#!/usr/bin/env python3
"""Tries the browser edition in headless Chromium as a student would: ./test.sh web, or
python3 tests/web/run.py [part of a test's name …]. Pictures of each page go to build/web/pictures.
Each file of tests runs in a process of its own, two at once on two or more processors; a browser waits often."""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import time
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "hip_path")]
ONE_FILE = "--file"


class Timed(unittest.TextTestResult):
    """Prints the seconds that each test took."""

    def startTest(self, test):
        super().startTest(test)
        self.begun = time.monotonic()

    def addSuccess(self, test):
        unittest.TestResult.addSuccess(self, test)
        self.stream.writeln(f"ok, {time.monotonic() - self.begun:.1f} s")


def suite(pattern, names):
    loader = unittest.TestLoader()
    if names:
        loader.testNamePatterns = [f"*{name}*" for name in names]
    return loader.discover(str(HERE), pattern=pattern)


def run_file(file, names):
    """Whether all tests of the file pass; prints what they print when they have ended."""
    child = subprocess.run([sys.executable, __file__, ONE_FILE, file, *names], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    print(child.stdout.decode(errors="replace"), end="", flush=True)
    return child.returncode == 0


if __name__ == "__main__":
    if sys.argv[1:2] == [ONE_FILE]:
        result = unittest.TextTestRunner(verbosity=2, resultclass=Timed).run(suite(sys.argv[2], sys.argv[3:]))
        sys.exit(0 if result.wasSuccessful() else 1)
    names = sys.argv[1:]
    tests = {file.name: suite(file.name, names).countTestCases() for file in HERE.glob("*_tests.py")}
    # The longest first: whole lessons.
    files = sorted((file for file in tests if tests[file]), key=lambda file: (file != "whole_lesson_tests.py", -tests[file]))
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        passed = list(pool.map(lambda file: run_file(file, names), files))
    print(f"{sum(tests.values())} tests in {len(files)} files, {passed.count(False)} files with failures")
    sys.exit(0 if files and all(passed) else 1)
