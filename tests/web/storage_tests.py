"""What the page keeps, and what it does where it cannot."""
import json
import os
import pathlib
import shutil
import tempfile
import time

from page import PAGE, PageTest, Served

# As a private window of some browsers.
FORBIDDEN = """
Object.defineProperty(globalThis, "indexedDB", {value: {open() { throw new DOMException("not here", "SecurityError"); }}});
"""

# From `full = true` on, what is written ends as it does where the disk is full: the change is aborted with
# QuotaExceededError. (Storage.overrideQuotaForOrigin no longer reaches IndexedDB in Chromium 156.)
FULL = """
const put = IDBObjectStore.prototype.put;
IDBObjectStore.prototype.put = function (...what) {
  const change = this.transaction;
  if (globalThis.full && !Object.hasOwn(change, "error")) {
    Object.defineProperty(change, "error", {value: new DOMException("no room", "QuotaExceededError")});
    queueMicrotask(() => change.abort());
  }
  return put.apply(this, what);
};
"""


class Storage(PageTest):
    def goes_on_and_hands_in(self, browser, says):
        """A student who is told once that nothing is kept, works on, and hands in what was done."""
        self.press(browser, until=("task/0", "done"))
        browser.frames(30)
        # Beside it, after the first touch, whether one wants to hear it.
        said = browser.said()
        told = [k for k, m in enumerate(said) if says in m]
        self.assertEqual(len(told), 1, said)
        self.assertEqual([m for m in said if says not in m and "hear what you touch" not in m], [])
        browser.click(f"message/{told[0]}/dismiss")
        self.press(browser, notches=3, until=("task/1", "done"))
        browser.click("lesson/next")
        browser.wait_for("lesson/step", "Two atoms")
        browser.evaluate("new Promise((done) => setTimeout(done, 1000))")
        self.assertEqual([m for m in browser.said() if "hear what you touch" not in m], [])
        browser.click("menu/lesson")
        browser.click("menu/lesson/hand-in")
        for _ in range(100):
            found = list(pathlib.Path(browser.downloads).glob("first-touch-*.jsonl"))
            if found and not list(pathlib.Path(browser.downloads).glob("*.crdownload")):
                break
            browser.frames(5)
        self.assertTrue(found, "nothing was downloaded")
        events = [json.loads(line) for line in found[0].read_text().splitlines()]
        self.assertGreaterEqual(sum('"task"' in json.dumps(e) for e in events), 2)

    def test_where_storage_is_forbidden_it_is_said_once_and_the_lesson_goes_on_to_the_file_that_is_handed_in(self):
        browser = self.browser(script=FORBIDDEN)
        self.open_lesson(browser)
        self.goes_on_and_hands_in(browser, "keeps nothing for this page")

    def test_where_storage_is_full_it_is_said_once_and_the_lesson_goes_on_to_the_file_that_is_handed_in(self):
        with Served() as url:
            browser = self.browser(script=FULL)
            browser.open(url)
            browser.evaluate("globalThis.full = true")
            browser.click("welcome/lesson/first-touch")
            browser.wait_for("task/0", "current")
            self.goes_on_and_hands_in(browser, "no room left")

    def test_of_a_browser_that_is_killed_in_the_middle_at_most_the_last_second_is_lost(self):
        profile = tempfile.mkdtemp(prefix="moltact-profile-")
        self.addCleanup(shutil.rmtree, profile, True)
        browser = self.browser(profile=os.path.join(profile, "one"))
        self.leave_at_second_step(browser)
        time.sleep(1.0)
        browser.kill()
        again = self.browser(profile=os.path.join(profile, "one"))
        self.goes_on_at_second_step(again)
        again.click("lesson/back")
        again.wait_for("task/0", "done")

    def test_of_a_tab_that_is_closed_nothing_is_lost(self):
        profile = tempfile.mkdtemp(prefix="moltact-profile-")
        self.addCleanup(shutil.rmtree, profile, True)
        browser = self.browser(profile=os.path.join(profile, "one"))
        self.leave_at_second_step(browser)
        browser.call("Page.navigate", url="about:blank")  # the tab leaves the page
        time.sleep(2.0)  # the browser ends in order, but a busy machine needs a moment to write
        browser.close()
        again = self.browser(profile=os.path.join(profile, "one"))
        self.goes_on_at_second_step(again)
