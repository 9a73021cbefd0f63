"""What the tests of the page share: where the page is, a server for it, and what a student does."""
import functools
import http.server
import os
import pathlib
import threading
import unittest

from browser import Browser

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = pathlib.Path(os.environ.get("MOLTACT_PAGE", ROOT / "build" / "web" / "moltact.html"))
DESKTOP = pathlib.Path(os.environ.get("MOLTACT_DESKTOP", ROOT / "build" / "release" / "moltact"))
PICTURES = ROOT / "build" / "web" / "pictures"
MOST_BYTES = 12 << 20


class Served:
    """A folder, the build's unless another is named, over HTTP on this computer."""

    def __init__(self, folder=PAGE.parent, file="moltact.html"):
        self.folder, self.file = folder, file

    def __enter__(self):
        handler = functools.partial(Quiet, directory=str(self.folder))
        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        return f"http://127.0.0.1:{self.server.server_port}/{self.file}"

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def end_headers(self):
        self.send_header("Access-Control-Allow-Origin", "*")
        super().end_headers()


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

    def open_lesson(self, browser, lesson="first-touch", url=None):
        browser.open(url or PAGE.as_uri())
        browser.click(f"welcome/lesson/{lesson}")
        browser.wait_for("task/0", "current")

    def leave_at_second_step(self, browser):
        """Does the first task of the first lesson and goes on; what is kept is written a little later."""
        self.open_lesson(browser)
        self.press(browser, until=("task/0", "done"))
        browser.click("lesson/next")
        browser.wait_for("lesson/step", "Two atoms")

    def goes_on_at_second_step(self, browser):
        browser.open(PAGE.as_uri())
        browser.click("welcome/lesson/first-touch")
        browser.wait_for("lesson/step", "Two atoms")

    def press(self, browser, notches=0, until=""):
        at = browser.place("view")
        browser.mouse("mouseMoved", *at)
        browser.frames(10)
        browser.mouse("mousePressed", *at, button="left", buttons=1)
        browser.frames(10)
        for _ in range(notches):
            browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=at[0], y=at[1], deltaX=0, deltaY=-100, buttons=1)
            browser.frames(2)
        if until:
            browser.wait_for(*until)
        browser.mouse("mouseReleased", *at, button="left")
        browser.frames(5)
