"""What hands and ears meet in the page: pens, fingers, vibration, sound, keys, and text to be copied."""
import re

from page import PAGE, PageTest

# The peak of the audio output, and the state of the audio context.
LISTEN = """
const connect = AudioNode.prototype.connect;
globalThis.heard = {peak: 0, context: null};
AudioNode.prototype.connect = function (to, ...more) {
  if (to instanceof AudioDestinationNode) {
    const ear = this.context.createAnalyser(), block = new Float32Array(ear.fftSize);
    heard.context = this.context;
    connect.call(this, ear);
    setInterval(() => { ear.getFloatTimeDomainData(block); for (const v of block) heard.peak = Math.max(heard.peak, Math.abs(v)); }, 20);
  }
  return connect.call(this, to, ...more);
};
"""
FEEL = """
globalThis.felt = [];
Object.defineProperty(Navigator.prototype, "vibrate", {value: (ms) => { felt.push(ms); return true; }});
"""


class Senses(PageTest):
    def force_N(self, browser):
        """As the view tells it."""
        found = re.match(r"([\d.]+)", browser.text("view/force") or "")
        return float(found.group(1)) if found else 0.0

    def test_a_pen_pushes_with_2_5_N_times_its_pressure(self):
        browser = self.browser()
        self.open_lesson(browser)
        at = browser.place("view")
        browser.pen("mouseMoved", *at, 0.0, buttons=0)
        browser.frames(10)
        browser.pen("mousePressed", *at, 0.2)
        browser.wait_for("task/0", "done")
        for k, (pressure, wanted_N) in enumerate(((0.2, 0.5), (0.8, 2.0), (0.4, 1.0))):
            for _ in range(30):  # a pen tells its pressure over and over
                browser.pen("mouseMoved", at[0] + k * 0.01, at[1], pressure)
                browser.frames(2)
            # The spring swings out: what the view says is rounded to 0.1 N.
            self.assertAlmostEqual(self.force_N(browser), wanted_N, delta=0.11)
        browser.pen("mouseReleased", *at, 0.0, buttons=0)
        self.no_errors(browser)

    def test_contact_and_each_crossing_to_other_atoms_vibrate_and_sliding_on_one_atom_does_not(self):
        browser = self.browser(touch=True, script=FEEL)
        browser.open(PAGE.as_uri())
        browser.tap("welcome/lesson/first-touch")
        browser.wait_for("task/0", "current")
        browser.tap("lesson/next")
        browser.wait_for("lesson/step", "Two atoms")
        browser.frames(20)
        x, y = browser.place("view")
        browser.touch("touchStart", (x - 60, y))
        browser.wait_for("view/state", "touching")
        browser.frames(20)
        first = browser.evaluate("felt.length")
        self.assertEqual(first, 1)
        browser.touch("touchMove", (x - 56, y))  # still on the left atom
        browser.frames(10)
        self.assertEqual(browser.evaluate("felt.length"), 1)
        for k in range(1, 31):
            browser.touch("touchMove", (x - 56 + 4 * k, y))
            browser.frames(2)
        browser.frames(20)
        browser.touch("touchEnd")
        crossings = browser.evaluate("felt.length") - first
        # Onto both atoms, and on to the right one alone.
        self.assertGreaterEqual(crossings, 2)
        self.assertTrue(browser.evaluate("felt.every((ms) => ms > 0 && ms <= 50)"))

    def test_sound_waits_for_the_first_click_and_a_touch_is_then_heard(self):
        browser = self.browser(script=LISTEN, arguments=["--autoplay-policy=document-user-activation-required"])
        self.open_lesson(browser)
        browser.click("tool/sound")
        browser.evaluate("new Promise((done) => setTimeout(done, 1000))")
        # After reopening, sound is on at once, but there was no click yet.
        browser.open(PAGE.as_uri())
        browser.until("heard.context")
        self.assertEqual(browser.evaluate("heard.context.state"), "suspended")
        self.assertEqual(browser.evaluate("heard.peak"), 0)
        browser.click("welcome/lesson/first-touch")
        browser.wait_for("task/0", "current")
        self.assertEqual(browser.evaluate("heard.context.state"), "running")
        self.press(browser, notches=3, until=("task/0", "done"))
        browser.until("heard.peak > 0.001", 20)
        self.assertLessEqual(browser.evaluate("heard.peak"), 1.0)
        self.no_errors(browser)

    def test_text_is_shown_by_Ctrl_A_selected_by_the_mouse_and_copied_as_the_page_says_it(self):
        browser = self.browser()
        browser.call("Browser.grantPermissions", browser_wide=True, permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        self.open_lesson(browser)
        kCtrl = 2
        browser.hold("ControlLeft", True, "Control", kCtrl)
        browser.key("KeyA", "a", kCtrl)
        browser.hold("ControlLeft", False, "Control")
        browser.until("document.getElementById('words').classList.contains('read')")
        chosen = browser.evaluate("getSelection().toString()")
        for words in ("five researchers near Zurich", "Touch the rings.", "Next"):
            self.assertIn(words, chosen)
        self.picture(browser, "text")
        # Three clicks select a paragraph; Ctrl+C copies it.
        box = browser.evaluate("""(() => { const p = [...document.querySelectorAll('#page p')]
            .find((p) => p.textContent.includes('five researchers near Zurich'));
            p.scrollIntoView({block: "center"});
            const r = p.getBoundingClientRect();
            return [r.left + 30, r.top + 8]; })()""")
        for count in (1, 2, 3):
            for kind in ("mousePressed", "mouseReleased"):
                browser.call("Input.dispatchMouseEvent", type=kind, x=box[0], y=box[1], button="left", clickCount=count)
        paragraph = browser.evaluate("getSelection().toString().trim()")
        self.assertIn("five researchers near Zurich", paragraph)
        self.assertNotIn("Touch the rings.", paragraph)
        browser.hold("KeyC", True, "c", kCtrl, commands=["copy"])
        browser.hold("KeyC", False, "c", kCtrl)
        self.assertEqual(browser.evaluate("navigator.clipboard.readText()").strip(), paragraph)
        browser.key("Escape")
        self.assertFalse(browser.evaluate("document.getElementById('words').classList.contains('read')"))
        # The keys are the program's again.
        self.press(browser, until=("task/0", "done"))
        self.no_errors(browser)
