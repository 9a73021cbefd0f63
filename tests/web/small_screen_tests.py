"""Telephones and tablets: what fingers reach at 390 x 844 and at 1280 x 800."""
from page import PAGE, PageTest


class SmallScreens(PageTest):
    def open_by_finger(self, browser):
        browser.open(PAGE.as_uri())
        browser.tap("welcome/lesson/first-touch")
        browser.wait_for("task/0", "current")
        browser.frames(10)

    def rectangle(self, browser, name):
        return [v / browser.scale for v in browser.widgets()[name][:4]]

    def fingers(self, browser, kind, **places):
        """Fingers that stay the same from event to event: finger number to place."""
        browser.call("Input.dispatchTouchEvent", type=kind,
                     touchPoints=[{"x": at[0], "y": at[1], "id": int(n[1:])} for n, at in places.items()])

    def push_with_0_8_N(self, browser):
        """One finger pushes, another one holds the pad."""
        at = browser.place("view")
        self.fingers(browser, "touchStart", f1=at)
        browser.wait_for("task/0", "done")
        pad = browser.place("view/harder")
        self.fingers(browser, "touchStart", f1=at, f2=pad)
        browser.wait_for("task/1", "done")
        self.fingers(browser, "touchEnd", f1=at)
        self.fingers(browser, "touchEnd")
        browser.frames(5)

    def test_on_a_telephone_the_text_stands_below_the_view_over_the_whole_width_and_both_tasks_are_done_by_fingers(self):
        browser = self.browser(touch=True, width=390, height=844, scale=2)
        self.open_by_finger(browser)
        view, text = self.rectangle(browser, "view"), self.rectangle(browser, "lesson/step")
        self.assertEqual((view[0], view[2]), (0, 390))
        self.assertGreater(view[3] - view[1], 300)
        self.assertGreater(text[1], view[3])
        self.assertIn("finger", browser.text("view/hint"))
        self.picture(browser, "telephone")
        self.push_with_0_8_N(browser)
        browser.tap("lesson/next")
        browser.wait_for("lesson/step", "Two atoms")
        self.picture(browser, "telephone-next")
        self.no_errors(browser)

    def test_the_edge_between_view_and_text_is_dragged_by_a_finger(self):
        browser = self.browser(touch=True, width=390, height=844)
        self.open_by_finger(browser)
        before = self.rectangle(browser, "view")[3]
        x, y = browser.place("splitter/below")
        self.fingers(browser, "touchStart", f1=(x, y))
        browser.frames(2)
        for k in range(1, 11):
            self.fingers(browser, "touchMove", f1=(x + 8 * k, y - 10 * k))
            browser.frames(1)
        self.fingers(browser, "touchEnd")
        browser.frames(5)
        self.assertAlmostEqual(self.rectangle(browser, "view")[3], before - 100, delta=8)

    def test_turned_on_its_side_a_telephone_has_the_text_beside_the_view(self):
        browser = self.browser(touch=True, width=844, height=390, scale=2)
        self.open_by_finger(browser)
        view, text = self.rectangle(browser, "view"), self.rectangle(browser, "lesson/step")
        self.assertGreater(view[0], text[0])
        self.assertEqual(view[2], 844)
        self.picture(browser, "telephone-side")

    def test_on_a_tablet_both_tasks_are_done_by_fingers_and_a_long_press_tells_what_lies_there(self):
        browser = self.browser(touch=True, width=1280, height=800)
        self.open_by_finger(browser)
        self.push_with_0_8_N(browser)
        self.picture(browser, "tablet")
        x, y = browser.place("tool/touch")
        self.fingers(browser, "touchStart", f1=(x, y))
        browser.frames(60)
        self.picture(browser, "tablet-long-press")
        self.assertTrue(any("Ctrl+T" in w[4] for w in browser.widgets().values()) or
                        browser.evaluate("document.getElementById('page').textContent.includes('Touch panel')"))
        self.fingers(browser, "touchEnd")
        self.no_errors(browser)
