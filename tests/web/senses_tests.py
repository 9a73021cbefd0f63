"""What hands and ears meet in the page: pens, fingers, vibration, sound, keys, and text to be copied."""
import re
import tempfile
import pathlib

from page import PAGE, PageTest

# The peak of what goes to the loudspeaker, and the state of what plays it.
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

KEYBOARD_LESSON = """---
title: By keys
minutes: 3
goals: Do it all by keys
molecules: argon-pair
author: The Moltact authors
licence: CC-BY-4.0
---
## Touch
```scene
molecule: argon-pair
```
```touch
reach: all
say: Touch an atom.
```
```touch
press: anywhere
until: 0.8 N
say: Push with 0.8 N.
```
### Question: How many atoms are there?
- [ ] One → Look again.
- [x] Two → Yes.
### Question: How far are the centres apart?
```answer
number: 3.76 Å
tolerance: 0.1 Å
```
## Slide
```touch
cross: atom 0
to: atom 1
direction: either
say: Slide from one atom to the other.
```
## The end
Done.
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
        # Opened again the sound is on at once, but nobody has clicked yet.
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

    def next_by_keys(self, browser):
        kAlt = 1
        browser.hold("AltLeft", True, "Alt", kAlt)
        browser.key("ArrowRight", modifiers=kAlt)
        browser.hold("AltLeft", False, "Alt")
        browser.frames(3)

    def test_by_keys_alone_a_whole_lesson_is_gone_through(self):
        browser = self.browser()
        browser.open(PAGE.as_uri())
        with tempfile.TemporaryDirectory() as folder:
            lesson = pathlib.Path(folder) / "by-keys.md"
            lesson.write_text(KEYBOARD_LESSON)
            node = browser.call("DOM.querySelector", nodeId=browser.call("DOM.getDocument")["root"]["nodeId"],
                                selector="#chooser")["nodeId"]
            browser.call("DOM.setFileInputFiles", nodeId=node, files=[str(lesson)])
            browser.wait_for("task/0", "current")
        # From here on nothing but keys.
        browser.hold("Space", True, " ")
        browser.wait_for("task/0", "done")
        for _ in range(3):
            browser.key("NumpadAdd", "+")
        browser.wait_for("task/1", "done")
        browser.hold("Space", False, " ")
        browser.frames(5)
        # The choices stand in an order of their own for each student; the key is the place.
        shown = sorted((w[1], w[4]) for n, w in browser.widgets().items() if n in ("question/0/0", "question/0/1"))
        browser.type(str(1 + [text for _, text in shown].index("Two")))
        browser.wait_for("question/0/feedback", "Yes.")
        browser.type("a")
        browser.frames(5)
        browser.type("3.76")
        browser.key("Enter")
        browser.frames(5)
        self.next_by_keys(browser)
        browser.wait_for("lesson/step", "Slide")
        browser.frames(20)
        # The probe goes over the pair and back while it pushes.
        for way in ("ArrowLeft", "ArrowRight", "ArrowLeft"):
            browser.hold("Space", True, " ")
            browser.frames(20)
            browser.hold(way, True)
            for _ in range(40):
                browser.frames(5)
                if "done" in (browser.text("task/0") or ""):
                    break
            browser.hold(way, False)
            browser.hold("Space", False, " ")
            if "done" in (browser.text("task/0") or ""):
                break
        browser.wait_for("task/0", "done", patience_s=5)
        self.next_by_keys(browser)
        browser.wait_for("lesson/step", "The end")
        browser.until("document.getElementById('news').textContent.includes('step 3 of 3')")
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
