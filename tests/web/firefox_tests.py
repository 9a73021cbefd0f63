"""The first things that a student does, in Firefox; skipped where firefox-esr and xvfb are not installed."""
import unittest

from firefox import PROGRAM, Firefox
from page import PAGE, PageTest


@unittest.skipUnless(PROGRAM, "firefox-esr and xvfb are not installed")
class InFirefox(PageTest):
    def firefox(self):
        browser = Firefox()
        self.addCleanup(browser.close)
        return browser

    def test_the_page_opens_from_a_file_with_all_lessons(self):
        browser = self.firefox()
        took_s = browser.open(PAGE.as_uri())
        for lesson in ("first-touch", "bond-or-contact", "dna-grooves-blind"):
            browser.wait_for(f"welcome/lesson/{lesson}")
        self.picture(browser, "firefox-welcome")
        print(f"Firefox: welcome page after {took_s:.1f} s")

    def test_by_mouse_the_first_two_tasks_are_done_by_touching_and_pushing_with_0_8_N(self):
        browser = self.firefox()
        self.open_lesson(browser)
        self.press(browser, until=("task/0", "done"))
        self.press(browser, notches=3, until=("task/1", "done"))
        self.picture(browser, "firefox-touched")

    def test_a_reload_in_the_middle_goes_on_where_it_was(self):
        browser = self.firefox()
        self.leave_at_second_step(browser)
        browser.evaluate("new Promise((done) => setTimeout(done, 1000))")
        self.goes_on_at_second_step(browser)
