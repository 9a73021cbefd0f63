#!/usr/bin/env python3
"""Tries the browser edition in headless Chromium as a student would: ./test.sh web, or
python3 tests/web/run.py [part of a test's name …]. Pictures of each page go to build/web/pictures."""
import functools
import http.server
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest

sys.path.insert(0, os.path.dirname(__file__))
from browser import Browser  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "build" / "web" / "moltact.html"
DESKTOP = ROOT / "build" / "release" / "moltact"
PICTURES = ROOT / "build" / "web" / "pictures"
MOST_BYTES = 12 << 20


class Served:
    """The build's folder over HTTP on this computer."""

    def __enter__(self):
        handler = functools.partial(Quiet, directory=str(PAGE.parent))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{self.server.server_port}/moltact.html"

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


class PageTest(unittest.TestCase):
    def browser(self, **options):
        browser = Browser(**options)
        self.addCleanup(browser.close)
        return browser

    def picture(self, browser, name):
        PICTURES.mkdir(parents=True, exist_ok=True)
        browser.screenshot(PICTURES / f"{name}.png")

    def no_errors(self, browser):
        bad = [line for line in browser.console() if "rror" in line or "INVALID" in line]
        self.assertEqual(bad, [])


class TheFile(PageTest):
    def test_is_at_most_12_MiB_and_names_no_other_file_or_server(self):
        self.assertLessEqual(PAGE.stat().st_size, MOST_BYTES)
        text = PAGE.read_text()
        for mark in ('<script src', '<link rel="stylesheet"', 'src="http', '@import'):
            self.assertNotIn(mark, text)


class Welcome(PageTest):
    def test_opens_from_a_file_with_all_lessons_and_asks_nobody_for_anything(self):
        browser = self.browser()
        took_s = browser.open(PAGE.as_uri())
        for lesson in ("first-touch", "bonds-and-creases", "dna-grooves-blind"):
            browser.wait_for(f"welcome/lesson/{lesson}")
        self.picture(browser, "welcome")
        others = [url for url in browser.requests() if not url.startswith((PAGE.as_uri(), "data:", "blob:"))]
        self.assertEqual(others, [])
        self.no_errors(browser)
        print(f"welcome page after {took_s:.1f} s")


if __name__ == "__main__":
    names = sys.argv[1:]
    loader = unittest.TestLoader()
    if names:
        loader.testNamePatterns = [f"*{name}*" for name in names]
    suite = loader.loadTestsFromModule(sys.modules[__name__])
    result = unittest.TextTestRunner(verbosity=2).run(suite)
    sys.exit(0 if result.wasSuccessful() else 1)
