"""A live class: `moltact class` on a free port of the loopback, three students in browsers of their own, the teacher's page and the projector's.
One student loses the server, which is killed and started again, and catches up. Two are asked for their scene."""
import concurrent.futures
import json
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time

from page import DESKTOP, PAGE, PageTest

LESSON = """---
title: Hands & <atoms>
minutes: 1
goals:
  - Touch an atom
molecules: argon-pair
author: The Moltact authors
licence: CC-BY-4.0
ask: name
---
## Touch
```scene
molecule: argon-pair
```
### Prediction: How does an atom feel?
- [ ] Hard from the first touch → It gives way.
- [x] Soft first, then harder → Yes.
```touch
reach: all
say: Touch an atom.
```
### Question: How many atoms are there?
- [ ] One → Look again. → counts what hides as one
- [x] Two → Yes.
## Slide
```touch
press: anywhere
until: 0.8 N
say: Push with 0.8 N.
```
## The end
Done.
"""


# How many colours the projector's picture of a scene has.
COLOURS = """(() => {
  const image = document.querySelector('#scene'), canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight);
  const context = canvas.getContext('2d');
  context.drawImage(image, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
})()"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Class(PageTest):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-class-"))
        self.addCleanup(shutil.rmtree, self.folder, True)
        (self.folder / "hands.md").write_text(LESSON)
        self.port = free_port()
        self.start()
        self.addCleanup(lambda: (self.server.kill(), self.server.wait()))

    def start(self):
        log = self.folder / "log"
        with open(log, "w") as out:
            self.server = subprocess.Popen([DESKTOP, "class", "hands.md", "--folder", self.folder / "class", "--port", str(self.port), "--page", PAGE],
                                           cwd=self.folder, stdout=out, stderr=subprocess.STDOUT)
        end = time.monotonic() + 60
        while "Ctrl+C" not in log.read_text():
            self.assertIsNone(self.server.poll(), log.read_text())
            self.assertLess(time.monotonic(), end, log.read_text())
            time.sleep(0.05)
        self.student, self.teacher = re.findall(r"http://\S+", log.read_text())

    def join(self, name):
        browser = self.browser()
        browser.go(self.student)
        browser.until("document.querySelector('#class-name')")
        if name:
            browser.evaluate(f"document.querySelector('#class-name').value = {json.dumps(name)}")
        if name == "<b>Ada</b>":
            self.picture(browser, "class-join")
        browser.evaluate("[...document.querySelectorAll('#class-join button')][%d].click()" % (0 if name else 1))
        browser.until("globalThis.moltactSender", 120)
        browser.wait_for("task/0", "current")
        return browser

    def rows(self, teacher):
        return teacher.evaluate("[...document.querySelectorAll('#students tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent))")

    def wait_row(self, teacher, test, patience_s=30):
        end = time.monotonic() + patience_s
        while not any(test(row) for row in self.rows(teacher)):
            self.assertLess(time.monotonic(), end, self.rows(teacher))
            time.sleep(0.1)

    def answer(self, browser, words):
        browser.click(next(n for n, w in browser.widgets().items() if n.startswith("question/") and w[4] == words))

    def ask_for_scene(self, teacher, browser, name):
        teacher.until("document.querySelector('[data-do=\"ask scene\"]')", 30)
        teacher.evaluate("[...document.querySelectorAll('#students tbody tr')].find((row) => row.cells[0].textContent === "
                         + json.dumps(name) + ").querySelector('button').click()")
        browser.until("document.querySelectorAll('#class-scene .answers button').length === 3", 30)

    def press_answer(self, browser, number):
        """1: yes, with the name; 2: yes, without it; 3: no."""
        browser.evaluate(f"document.querySelector('#class-scene .answers button:nth-child({number})').click()")

    def test_three_students_join_one_loses_the_server_and_catches_up_and_the_teacher_sees_holds_and_ends(self):
        with concurrent.futures.ThreadPoolExecutor(5) as pool:
            others = [pool.submit(self.browser) for _ in range(2)]
            ada, bo, animal = pool.map(self.join, ("<b>Ada</b>", "Bo", ""))
            teacher, board = (other.result() for other in others)
        teacher.go(self.teacher)
        teacher.until("document.querySelectorAll('#students tbody tr').length === 3")
        names = [row[0] for row in self.rows(teacher)]
        self.assertIn("<b>Ada</b>", names)
        self.assertIn("Bo", names)
        self.assertTrue(all(names), names)

        # Three predictions, of which the projector shows one plot without names when the teacher says so.
        board.go(self.student + "board")
        board.until("document.querySelector('.big')?.textContent === " + json.dumps(self.student))
        for browser, words in ((ada, "Soft first, then harder"), (bo, "Hard from the first touch"), (animal, "Soft first, then harder")):
            self.answer(browser, words)
        teacher.until("document.querySelector('#show-question-hands-0-0')", 30)
        self.assertNotIn("How does an atom feel", board.evaluate("document.body.textContent"))
        teacher.evaluate("document.querySelector('#show-question-hands-0-0').click()")
        board.until("document.querySelectorAll('.bars li').length === 2", 30)
        self.assertEqual(board.evaluate("[...document.querySelectorAll('.bars b')].map((b) => b.textContent).join()"), "1,2")
        for name in names:
            self.assertNotIn(name, board.evaluate("document.body.textContent"))
        self.picture(board, "class-board")
        teacher.until("document.querySelector('#hide-question-hands-0-0')", 30)
        teacher.evaluate("document.querySelector('#hide-question-hands-0-0').click()")
        board.until("!document.querySelector('.bars')", 30)

        # Step, task and a misconception as they happen.
        for browser in (ada, bo):
            self.press(browser, until=("task/0", "done"))
        self.answer(ada, "One")
        teacher.until("document.querySelector('#answers').textContent.includes('counts what hides as one')", 30)
        self.wait_row(teacher, lambda row: row[0] == "<b>Ada</b>" and row[1].startswith("1. Touch"))

        # Ada is asked for her scene and agrees, without the name: it stays hidden while a question of the step is open.
        self.ask_for_scene(teacher, ada, "<b>Ada</b>")
        self.picture(ada, "class-asked")
        self.press_answer(ada, 2)
        ada.until("document.querySelector('#class-scene.showing')")
        board.until("document.querySelector('#why')?.textContent.includes('until everyone at this step has answered')", 30)
        self.assertTrue(board.evaluate("document.querySelector('#scene').hidden"))
        self.assertNotIn("Ada", board.evaluate("document.body.textContent"))
        teacher.until("document.querySelector('#end-scene')")
        teacher.evaluate("document.querySelector('#end-scene').click()")
        ada.until("!document.querySelector('#class-scene')", 30)
        board.until("!document.querySelector('#scene')", 30)

        # The class is held at the first step: the button says so; when it is opened, the student goes on.
        teacher.evaluate("document.querySelector('#hold-hands-0').click()")
        self.answer(ada, "Two")
        ada.wait_for("lesson/next", "Your class waits here")
        self.picture(teacher, "class-teacher")
        teacher.evaluate("document.querySelector('#open-hands').click()")
        ada.wait_for("lesson/next", "Next")

        # The server dies. Bo goes on: the page says it in a line, and everything arrives when the server is back.
        self.server.kill()
        self.server.wait()
        self.answer(bo, "Two")
        bo.until("!document.querySelector('#class-said').hidden && document.querySelector('#class-said').textContent.includes('does not answer')", 30)
        bo.wait_for("lesson/next", "Next")  # although the page may not have heard that the way is open
        bo.click("lesson/next")
        bo.wait_for("lesson/step", "Slide")
        self.picture(bo, "class-lost")
        teacher.until("!document.querySelector('#lost').hidden")
        self.start()
        bo.until("document.querySelector('#class-said').textContent.includes('answers again')", 30)
        self.wait_row(teacher, lambda row: row[0] == "Bo" and row[1].startswith("2. Slide"))

        # Bo, at a step without questions, agrees with the name: the projector shows the scene, until Bo stops it.
        self.ask_for_scene(teacher, bo, "Bo")
        self.press_answer(bo, 1)
        board.until("document.querySelector('#scene')?.naturalWidth > 100", 60)
        self.assertEqual(board.evaluate("document.querySelector('h1').textContent"), "The scene of Bo")
        self.assertGreater(board.evaluate(COLOURS), 100)
        self.assertEqual(teacher.evaluate("document.querySelector('#scene-row').textContent.includes('the scene of Bo, with the name')"), True)
        self.picture(board, "class-scene")
        self.picture(bo, "class-showing")
        bo.evaluate("document.querySelector('#class-scene button').click()")
        board.until("!document.querySelector('#scene')", 30)
        self.assertNotIn("Bo", board.evaluate("document.body.textContent"))

        # A page that is loaded again goes on as the same student, in the same attempt.
        bo.go(self.student)
        bo.until("document.querySelector('#class-join button')?.textContent === 'Go on as Bo'")
        bo.evaluate("document.querySelector('#class-join button').click()")
        bo.until("globalThis.moltactSender", 120)
        bo.wait_for("lesson/step", "Slide")

        # The end, and the report from the attempts.
        teacher.evaluate("globalThis.confirm = () => true; globalThis.open = () => null; document.querySelector('[data-do=end]').click()")
        for browser in (ada, animal, bo):
            browser.until("document.querySelector('#class-said').textContent.includes('All of your work has arrived')", 30)
        board.go(self.teacher + "report")
        board.until("document.querySelector('main')")
        text = board.evaluate("document.querySelector('main').textContent")
        for name in ("<b>Ada</b>", "Bo", "counts what hides as one"):
            self.assertIn(name, text)
        self.server.send_signal(signal.SIGINT)
        self.server.wait(30)
        attempts = [[json.loads(line) for line in file.read_text().splitlines()] for file in (self.folder / "class" / "attempts").glob("*.jsonl")]
        self.assertEqual(len(attempts), 3)
        lines, = [attempt for attempt in attempts if attempt[0]["student"] == "Bo"]
        times = [line["t"] for line in lines[1:] if line["kind"] in ("step", "answer", "done")]
        self.assertEqual(times, sorted(times))
        # Once until the page was loaded again: what came twice counts once.
        first = lines[:next(k for k, line in enumerate(lines) if line["kind"] == "resumed")]
        self.assertEqual([line["step"] for line in first if line["kind"] == "step"], ["touch", "slide"])
        for browser in (ada, animal):
            bad = [line for line in browser.console() if "rror" in line and "ERR_CONNECTION" not in line and "Failed to" not in line]
            self.assertEqual(bad, [])
