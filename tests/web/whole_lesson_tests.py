"""A whole lesson, with its touch tasks, a choice, a number and its end: by keys alone, by the mouse alone but for the number's
digits, by fingers alone but for those."""
import pathlib
import tempfile
import time

from page import PAGE, PageTest

LESSON = """---
title: Hands
minutes: 3
goals: Do it all by one hand
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


class Hand:
    """What one way of using the page has to be able to do."""

    def __init__(self, browser):
        self.browser = browser

    def done(self, task):
        return "done" in (self.browser.text(task) or "")

    def shown_choice(self, words):
        """Where a choice stands: they have an order of their own for each student."""
        shown = sorted((w[1], n, w[4]) for n, w in self.browser.widgets().items() if n in ("question/0/0", "question/0/1"))
        return next((place, name) for place, (_, name, text) in enumerate(shown) if text == words)

    def write(self, text):
        self.into_field()
        self.browser.frames(5)
        self.browser.type(text)

    def over(self, steps=40):
        """Places over the pair of atoms and back, left to right, as shares of the view's width."""
        there = [0.42 + 0.16 * k / steps for k in range(steps + 1)]
        return there + there[::-1]


class Keys(Hand):
    def touch(self):
        self.browser.hold("Space", True, " ")

    def harder(self):
        for _ in range(3):
            self.browser.key("NumpadAdd", "+")

    def let_go(self):
        self.browser.hold("Space", False, " ")
        self.browser.frames(5)

    def choose(self, words):
        self.browser.type(str(1 + self.shown_choice(words)[0]))

    def write(self, text):
        # For half a second after something was completed no key answers the next thing; a question that is not yet in view is
        # scrolled into it first.
        for _ in range(10):
            self.browser.type("a")
            self.browser.frames(5)
            self.browser.type(text)
            self.browser.frames(5)
            if self.browser.text("question/1/field") == text:
                return
            time.sleep(0.3)

    def confirm(self):
        self.browser.key("Enter")

    def next(self):
        alt = 1
        self.browser.hold("AltLeft", True, "Alt", alt)
        self.browser.key("ArrowRight", modifiers=alt)
        self.browser.hold("AltLeft", False, "Alt")

    def slide(self, task):
        # The probe moves over the pair and back while it pushes.
        for way in ("ArrowLeft", "ArrowRight", "ArrowLeft"):
            self.touch()
            self.browser.frames(20)
            self.browser.hold(way, True)
            for _ in range(40):
                self.browser.frames(5)
                if self.done(task):
                    break
            self.browser.hold(way, False)
            self.let_go()
            if self.done(task):
                return


class Mouse(Hand):
    def touch(self, x=0.5):
        self.at = self.browser.place("view", x)
        self.browser.mouse("mouseMoved", *self.at)
        self.browser.frames(10)
        self.browser.mouse("mousePressed", *self.at, button="left", buttons=1)
        self.browser.frames(10)

    def harder(self):
        for _ in range(3):
            self.browser.call("Input.dispatchMouseEvent", type="mouseWheel", x=self.at[0], y=self.at[1], deltaX=0, deltaY=-100,
                              buttons=1)
            self.browser.frames(2)

    def let_go(self):
        self.browser.mouse("mouseReleased", *self.at, button="left")
        self.browser.frames(5)

    def choose(self, words):
        self.browser.click(self.shown_choice(words)[1])

    def into_field(self):
        self.browser.click("question/1/field")

    def confirm(self):
        self.browser.click("question/1/check")

    def next(self):
        self.browser.click("lesson/next")

    def slide(self, task):
        self.touch(self.over()[0])
        for x in self.over():
            self.at = self.browser.place("view", x)
            self.browser.mouse("mouseMoved", *self.at, button="left", buttons=1)
            self.browser.frames(2)
        self.let_go()


class Fingers(Hand):
    def send(self, kind, **places):
        self.browser.call("Input.dispatchTouchEvent", type=kind,
                          touchPoints=[{"x": at[0], "y": at[1], "id": int(n[1:])} for n, at in places.items()])

    def touch(self, x=0.5):
        self.at = self.browser.place("view", x)
        self.send("touchStart", f1=self.at)
        self.browser.frames(10)

    def harder(self):
        self.send("touchStart", f1=self.at, f2=self.browser.place("view/harder"))
        self.browser.wait_for("task/1", "done")
        self.send("touchEnd", f1=self.at)

    def let_go(self):
        self.send("touchEnd")
        self.browser.frames(5)

    def choose(self, words):
        self.browser.tap(self.shown_choice(words)[1])

    def into_field(self):
        self.browser.tap("question/1/field")

    def confirm(self):
        self.browser.tap("question/1/check")

    def next(self):
        self.browser.tap("lesson/next")

    def slide(self, task):
        self.touch(self.over()[0])
        for x in self.over():
            self.at = self.browser.place("view", x)
            self.send("touchMove", f1=self.at)
            self.browser.frames(2)
        self.let_go()


class WholeLesson(PageTest):
    def gone_through(self, browser, hand):
        browser.open(PAGE.as_uri())
        with tempfile.TemporaryDirectory() as folder:
            lesson = pathlib.Path(folder) / "hands.md"
            lesson.write_text(LESSON)
            node = browser.call("DOM.querySelector", nodeId=browser.call("DOM.getDocument")["root"]["nodeId"],
                                selector="#chooser")["nodeId"]
            browser.call("DOM.setFileInputFiles", nodeId=node, files=[str(lesson)])
            browser.wait_for("task/0", "current")
        browser.frames(10)
        # From here on nothing but this hand.
        hand.touch()
        browser.wait_for("task/0", "done")
        hand.harder()
        browser.wait_for("task/1", "done")
        hand.let_go()
        hand.choose("One")
        browser.wait_for("question/0/feedback", "Look again.")
        hand.choose("Two")
        browser.wait_for("question/0/feedback", "Yes.")
        hand.write("3.76")
        hand.confirm()
        browser.wait_for("question/1/feedback", "Right")
        hand.next()
        browser.wait_for("lesson/step", "Slide")
        browser.frames(20)
        hand.slide("task/0")
        browser.wait_for("task/0", "done", patience_s=5)
        hand.next()
        browser.wait_for("lesson/step", "The end")
        browser.until("document.getElementById('news').textContent.includes('step 3 of 3')")
        self.no_errors(browser)

    def test_by_keys_alone_a_whole_lesson_is_gone_through_a_wrong_answer_among_it(self):
        browser = self.browser()
        self.gone_through(browser, Keys(browser))

    def test_by_the_mouse_a_whole_lesson_is_gone_through_a_wrong_answer_among_it(self):
        browser = self.browser()
        self.gone_through(browser, Mouse(browser))

    def test_by_fingers_a_whole_lesson_is_gone_through_a_wrong_answer_among_it(self):
        browser = self.browser(touch=True)
        self.gone_through(browser, Fingers(browser))
