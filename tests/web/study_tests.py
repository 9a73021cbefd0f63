"""The pages of a study: `moltact study` makes them, and Chromium shows that each group gets its condition."""
import pathlib
import subprocess
import tempfile

from page import DESKTOP, PAGE, PICTURES, PageTest

LESSON = """---
title: Two atoms
goals: Touch
molecules: argon-pair
author: The Moltact authors
licence: CC-BY-4.0
---
## Touch
```scene
molecule: argon-pair
label: "here" for atom 0
```
```touch
reach: all
say: Touch an atom.
```
### Question: How many atoms are there?
- [ ] One → Look again.
- [x] Two → Yes.
"""

TEST = """---
title: A test
test: yes
required: yes
goals: Know
molecules: argon
author: The Moltact authors
licence: CC-BY-4.0
---
## Question 1
```scene
molecule: argon
hide: all
untouchable: all
```
### Question: What is this?
- [x] An atom
- [ ] A drop → → drawing taken for the molecule
"""

PLAN = """---
title: A study
study: web-study
%s
groups:
- hands -> touch: two-atoms
- eyes -> look: two-atoms
- dark -> blind: two-atoms
---
"""


class Studies(PageTest):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        (self.folder / "two-atoms.md").write_text(LESSON)
        (self.folder / "quiz.md").write_text(TEST)

    def make(self, keys):
        (self.folder / "plan.md").write_text(PLAN % keys)
        subprocess.run([DESKTOP, "study", "plan.md", "--page", PAGE], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def begun(self, page, code="ab12"):
        browser = self.browser()
        browser.go((self.folder / page).as_uri())
        browser.until("globalThis.moltact && moltact.page.frames > 3", 120)
        browser.wait_for("name/field")
        browser.click("name/field")
        browser.type(code)
        browser.click("name/begin")
        return browser

    def colours(self, browser, name):
        """How many colours a line across the middle of the view has. The ground changes from top to bottom only."""
        self.picture(browser, name)
        x, y = browser.place("view")
        crop = f"200x1+{int(x) - 100}+{int(y)}"
        command = ["convert", PICTURES / f"{name}.png", "-crop", crop, "-format", "%k", "info:"]
        return int(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)

    def pressed(self, browser):
        """What the status bar says of the contact while the mouse presses on the middle of the view."""
        at = browser.place("view")
        browser.mouse("mouseMoved", *at)
        browser.frames(10)
        browser.mouse("mousePressed", *at, button="left", buttons=1)
        browser.frames(60)
        said = browser.text("status/contact")
        browser.mouse("mouseReleased", *at, button="left")
        browser.frames(5)
        return said

    def test_each_group_of_a_study_gets_the_lesson_under_its_condition(self):
        self.make("ask: code")
        hands = self.begun("web-study-hands.html")
        hands.wait_for("task/0", "current")
        hands.wait_for("view/label/0", "here")
        self.assertGreater(self.colours(hands, "study-hands"), 10)
        at_rest = hands.text("status/contact")
        self.assertNotEqual(self.pressed(hands), at_rest)
        hands.wait_for("task/0", "done")
        self.no_errors(hands)

        eyes = self.begun("web-study-eyes.html")
        eyes.wait_for("question/0")
        eyes.wait_for("view/label/0", "here")
        self.assertGreater(self.colours(eyes, "study-eyes"), 10)
        self.assertEqual([n for n in eyes.widgets() if n.startswith("task/")], [])
        self.assertEqual(self.pressed(eyes), at_rest)
        self.no_errors(eyes)

        dark = self.begun("web-study-dark.html")
        dark.wait_for("task/0", "current")
        self.assertLess(self.colours(dark, "study-dark"), 8)  # the ground is dithered
        self.assertIsNone(dark.text("view/label/0"))
        self.pressed(dark)
        dark.wait_for("task/0", "done")
        dark.click("question/0/1")
        dark.frames(30)
        # The end of the step does not bring the picture back.
        self.assertLess(self.colours(dark, "study-dark-done"), 8)
        self.no_errors(dark)

    def test_a_page_that_draws_asks_for_the_code_and_opens_the_test_of_its_group_which_tells_no_verdict(self):
        self.make("pre: quiz\nassign: draw\nstudents: 6\nseed: 3\nblock: 3")
        rows = [line.split(",") for line in (self.folder / "web-study-codes.csv").read_text().splitlines()[1:]]
        code = next(row[1] for row in rows if row[2] == "eyes")
        browser = self.browser()
        browser.go((self.folder / "web-study.html").as_uri())
        browser.until("document.getElementById('code-form').open")
        type_code = "(() => { const f = document.querySelector('#code-form input'); f.value = %r;" \
                    " document.querySelector('#code-form button').click(); return true; })()"
        browser.evaluate(type_code % "XXXXX")
        self.assertIn("XXXXX", browser.evaluate("document.querySelector('#code-form p').textContent"))
        browser.evaluate(type_code % code.lower())
        browser.until("globalThis.moltact && moltact.page.frames > 3", 120)
        browser.wait_for("question/0")
        self.assertIsNone(browser.text("name/field"))
        browser.click("question/0/1")
        browser.frames(10)
        self.picture(browser, "study-test")
        self.assertEqual([n for n in browser.widgets() if n.endswith("/verdict")], [])
        # The program keeps the code as the student's.
        files = "moltact.FS.readdir('/home/web_user/.local/share/moltact/attempts').filter((n) => n.endsWith('.jsonl'))"
        browser.until(f"{files}.length == 1")
        first = browser.evaluate("moltact.FS.readFile('/home/web_user/.local/share/moltact/attempts/' + "
                                 f"{files}[0], {{encoding: 'utf8'}}).split('\\n')[0]")
        self.assertIn(f'"student":"{code}"', first)
        self.assertIn('"group":"eyes"', first)
        self.no_errors(browser)
