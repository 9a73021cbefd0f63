"""Files, packs and addresses: what comes into the page, and that nothing leaves it unasked."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import zipfile

from page import DESKTOP, PAGE, ROOT, PageTest, Served

LESSON = """---
title: Three spheres
minutes: 5
goals: Touch them
molecules: mine.xyzr
author: A. Teacher
licence: CC-BY-4.0
---
## The first step
```scene
molecule: mine.xyzr
```
```touch
reach: all
say: Touch a sphere.
```
## The second step
### Question: How many spheres are there?
- [ ] Two → Count again.
- [x] Three → Yes.
"""  # with an open task in the second step, because a finished lesson restarts
SPHERES = "0 0 0 1.5\n3 0 0 1.5\n1.5 2.5 0 1.5\n"


class FilesTest(PageTest):
    def folder(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-files-"))
        self.addCleanup(shutil.rmtree, folder)
        return folder

    def desktop(self, *arguments, folder, status=0):
        run = subprocess.run([DESKTOP, *arguments], cwd=folder, capture_output=True, text=True,
                             env={**os.environ, "MOLTACT_HOME": str(ROOT), "MOLTACT_LANGUAGE": "en", "HOME": str(folder)})
        self.assertEqual(run.returncode, status, run.stderr)
        return run

    def lesson(self):
        folder = self.folder()
        (folder / "three.md").write_text(LESSON)
        (folder / "mine.xyzr").write_text(SPHERES)
        return folder

    def pack(self):
        folder = self.lesson()
        self.desktop("pack", "three.md", folder=folder)
        return folder / "three.moltact"

    def choose(self, browser, *files):
        node = browser.call("DOM.querySelector", nodeId=browser.call("DOM.getDocument")["root"]["nodeId"],
                            selector="#chooser")["nodeId"]
        browser.call("DOM.setFileInputFiles", nodeId=node, files=[str(f) for f in files])

    def drop(self, browser, *files):
        data = {"items": [], "files": [str(f) for f in files], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            browser.call("Input.dispatchDragEvent", type=kind, x=640, y=400, data=data)


class OwnFiles(FilesTest):
    def test_a_chosen_molecule_opens(self):
        browser = self.browser()
        browser.open(PAGE.as_uri())
        self.choose(browser, ROOT / "molecules" / "benzene.pdb")
        browser.until("JSON.parse(moltact.ccall('moltact_widgets','string',[],[]))['view/scale bar']")
        self.picture(browser, "own-molecule")
        self.no_errors(browser)

    def test_a_lesson_and_its_molecule_dropped_together_open_and_are_done(self):
        folder = self.lesson()
        browser = self.browser()
        browser.open(PAGE.as_uri())
        self.drop(browser, folder / "three.md", folder / "mine.xyzr")
        browser.wait_for("lesson/step", "The first step")
        self.press(browser, until=("task/0", "done"))
        self.no_errors(browser)


class Packs(FilesTest):
    def test_a_dropped_pack_opens_with_its_molecule_and_stands_on_the_shelf_after_a_reload_where_it_was_left(self):
        browser = self.browser()
        browser.open(PAGE.as_uri())
        self.drop(browser, self.pack())
        browser.wait_for("lesson/step", "The first step")
        self.press(browser, until=("task/0", "done"))
        browser.click("lesson/next")
        browser.wait_for("lesson/step", "The second step")
        browser.evaluate("new Promise((done) => setTimeout(done, 1000))")
        browser.open(PAGE.as_uri())
        browser.click("welcome/own/three")
        browser.wait_for("lesson/step", "The second step")
        # The pack itself is not kept beside what it was unpacked to.
        kept = browser.evaluate("""new Promise((done) => { const o = indexedDB.open('moltact'); o.onsuccess = () => {
            const r = o.result.transaction('files').objectStore('files').getAllKeys();
            r.onsuccess = () => done(r.result.join('\\n')); }; })""")
        self.assertIn("/packs/three-", kept)
        self.assertNotIn(".moltact\n", kept + "\n")
        self.no_errors(browser)

    def test_a_chosen_pack_opens(self):
        browser = self.browser()
        browser.open(PAGE.as_uri())
        self.choose(browser, self.pack())
        browser.wait_for("lesson/step", "The first step")
        self.no_errors(browser)

    def test_packs_that_are_cut_off_or_lead_out_of_their_folder_are_refused_with_the_reason(self):
        whole = self.pack()
        short = whole.parent / "short.moltact"
        short.write_bytes(whole.read_bytes()[:-30])
        outside = whole.parent / "outside.moltact"
        with zipfile.ZipFile(outside, "w") as out:
            out.writestr("pack.json", '{"format": 1, "lesson": "three.md"}')
            out.writestr("three.md", LESSON)
            out.writestr("../../escaped.txt", "x")
        browser = self.browser()
        browser.open(PAGE.as_uri())
        for file, reason in ((short, "cut off or damaged"), (outside, "leads out of the folder")):
            self.drop(browser, file)
            browser.wait_for("message/0", reason)
            browser.click("message/0/dismiss")
        self.assertFalse(browser.evaluate("moltact.FS.analyzePath('/home/escaped.txt').exists"))
        browser.wait_for("welcome/lesson/first-touch")


class LessonPage(FilesTest):
    def test_a_lesson_packed_as_a_page_opens_at_the_lesson_asks_nobody_and_goes_on_after_a_reload(self):
        folder = self.lesson()
        told = self.desktop("pack", "three.md", "--html", "--page", PAGE, folder=folder).stdout
        self.assertIn("three.html is written", told)
        page = folder / "three.html"
        self.assertGreater(page.stat().st_size, PAGE.stat().st_size)
        browser = self.browser()
        browser.go(page.as_uri())
        browser.until("globalThis.moltact && moltact.page.frames > 1")
        browser.wait_for("lesson/step", "The first step")
        self.press(browser, until=("task/0", "done"))
        browser.click("lesson/next")
        browser.wait_for("lesson/step", "The second step")
        self.picture(browser, "lesson-page")
        browser.evaluate("new Promise((done) => setTimeout(done, 1000))")
        browser.go(page.as_uri())
        browser.until("globalThis.moltact && moltact.page.frames > 1")
        browser.wait_for("lesson/step", "The second step")
        others = [url for url in browser.requests() if not url.startswith((page.as_uri(), "data:", "blob:"))]
        self.assertEqual(others, [])
        self.no_errors(browser)

    # Every sign that a pack's name may hold and that means something in HTML, in a script or in an address.
    HOSTILE = ["a & b &lt;img src=x&gt; &quot;", "'onload='hit=1' x='", "';hit=1;'", "${hit=1}`${hit=1}`", "%3Cscript%3Ehit=1",
               "=1+1", "-- --! ]] }}", "ünï 名前 𝔘"]

    def hostile_page(self, name, edition):
        folder = self.folder()
        title = "</script><img src=x onerror=hit=1><script>hit=1</script>"
        (folder / f"{name}.md").write_text(LESSON.replace("title: Three spheres", f"title: '{title}'"))
        (folder / "mine.xyzr").write_text(SPHERES)
        self.desktop("pack", f"{name}.md", "--html", "--page", edition, folder=folder)
        return folder / f"{name}.html"

    def test_names_and_titles_with_signs_of_html_stay_text_in_the_page(self):
        """In a bare page, which shows what stands in it whatever the program does."""
        edition = self.folder() / "bare.html"
        edition.write_text("<!DOCTYPE html><meta charset=utf-8><body><!--a lesson comes here--><p id=end>end</p></body>")
        browser = self.browser()
        for name in self.HOSTILE:
            with self.subTest(name=name):
                browser.go(self.hostile_page(name, edition).as_uri())
                browser.until("document.getElementById('end')")
                self.assertEqual(browser.evaluate("document.getElementById('pack-bytes').dataset.name"), name + ".moltact")
                self.assertEqual(browser.evaluate("document.querySelectorAll('script, img, [onload], [onerror]').length"), 1)
                self.assertEqual(browser.evaluate("typeof hit"), "undefined")
                self.assertEqual(browser.evaluate("atob(document.getElementById('pack-bytes').textContent).slice(0, 2)"), "PK")

    def test_names_and_titles_with_signs_of_html_open_as_lessons(self):
        for name in self.HOSTILE:
            with self.subTest(name=name):
                browser = self.browser()
                browser.go(self.hostile_page(name, PAGE).as_uri())
                browser.until("globalThis.moltact && moltact.page.frames > 1")
                browser.wait_for("lesson/step", "The first step")
                self.assertEqual(browser.evaluate("typeof hit"), "undefined")
                self.no_errors(browser)
                browser.close()

    def test_a_page_that_is_no_browser_edition_is_refused_by_name(self):
        folder = self.lesson()
        (folder / "other.html").write_text("<html></html>")
        told = self.desktop("pack", "three.md", "--html", "--page", "other.html", folder=folder, status=1).stderr
        self.assertIn("other.html: it is no page of the browser edition", told)


class Addresses(FilesTest):
    """The browser's own log holds every request, also what a page cannot see."""

    def logged(self):
        folder = self.folder()
        log = folder / "net.json"
        return self.browser(arguments=[f"--log-net-log={log}"]), log

    def asked(self, browser, server):
        browser.until("document.getElementById('ask').open")
        self.assertIn(server, browser.evaluate("document.getElementById('ask').textContent"))

    def test_an_entry_that_is_not_here_is_asked_for_only_after_a_yes(self):
        for yes in (False, True):
            browser, log = self.logged()
            browser.open(PAGE.as_uri() + "?molecule=1CRN")
            self.asked(browser, "files.rcsb.org")
            browser.frames(20)
            browser.evaluate("new Promise((done) => setTimeout(done, 500))")
            self.assertEqual([u for u in browser.requests() if "rcsb" in u], [])
            browser.evaluate(f"document.querySelectorAll('#ask button')[{0 if yes else 1}].click()")
            browser.frames(5)
            if yes:  # there may be no network here: then a message tells it
                browser.until("JSON.parse(moltact.ccall('moltact_widgets','string',[],[]))['view/scale bar'] || "
                              "Object.values(JSON.parse(moltact.ccall('moltact_widgets','string',[],[])))"
                              ".some((w) => w[4].includes('cannot be fetched'))")
            browser.close()
            self.assertEqual("rcsb.org" in log.read_text(errors="replace"), yes)

    def test_an_entry_that_came_with_the_page_opens_without_a_question(self):
        browser, log = self.logged()
        browser.go(PAGE.as_uri() + "?molecule=1UBQ")
        browser.until("globalThis.moltact && JSON.parse(moltact.ccall('moltact_widgets','string',[],[]))['view/scale bar']")
        self.assertFalse(browser.evaluate("document.getElementById('ask').open"))
        browser.close()
        self.assertNotIn("rcsb.org", log.read_text(errors="replace"))

    def test_a_pack_on_another_server_is_fetched_and_opened_only_after_a_yes(self):
        pack = self.pack()
        for yes in (False, True):
            with Served(pack.parent, "three.moltact") as url:
                browser, log = self.logged()
                browser.open(PAGE.as_uri() + "?lesson=" + url)
                self.asked(browser, url.split("/")[2])
                browser.frames(10)
                self.assertEqual([u for u in browser.requests() if u.startswith("http")], [])
                browser.evaluate(f"document.querySelectorAll('#ask button')[{0 if yes else 1}].click()")
                if yes:
                    browser.wait_for("lesson/step", "The first step")
                browser.frames(5)
                browser.close()
                self.assertEqual(url in log.read_text(errors="replace"), yes)
