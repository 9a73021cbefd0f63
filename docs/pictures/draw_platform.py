#!/usr/bin/env python3
"""Draws the pictures of docs/learning-platforms.md but platform-lost.png and platform-back.png, which
tests/web/platform_tests.py leaves in build/web/pictures. Run in the source folder, with Chromium, the browser edition and the
program: docs/pictures/draw_platform.py"""
import html
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/web"), str(ROOT / "tests/hip_path")]
from browser import Browser  # noqa: E402
from page import DESKTOP, PAGE, Served  # noqa: E402

PICTURES = ROOT / "docs/pictures"
TERMINAL = """<meta charset="utf-8"><style>body { margin: 0; background: #1d2430; color: #e8ecf2; font: 15px "DejaVu Sans Mono", monospace }
pre { margin: 14px 18px; line-height: 1.45 }</style><pre>%s</pre>"""
PLAYER = """<!DOCTYPE html><meta charset="utf-8"><style>
body { margin: 0; height: 100vh; display: flex; flex-direction: column; font: 15px system-ui, sans-serif; color: #1d2430; background: #eef0f3 }
header { padding: 10px 16px; background: #fff; border-bottom: 1px solid #c9ced6; display: flex; justify-content: space-between }
iframe { flex: 1; margin: 10px; border: 1px solid #c9ced6 }</style>
<header><b>Structural biology 101</b><span>First touch</span><span>Leave the activity</span></header>
<script>%s</script><script>
  const lms = scormRuntime.make("1.2", %s, {lost: () => false});
  globalThis.API = lms.api;
  Object.defineProperty(globalThis, "moltact", {get: () => frames[0] && frames[0].moltact});
</script><iframe src="index.html"></iframe>"""


def main():
    folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-platform-"))
    for lesson in ("first-touch.md", "first-touch.de.md", "glossary.md", "glossary.de.md"):
        if (ROOT / "lessons" / lesson).exists():
            shutil.copy(ROOT / "lessons" / lesson, folder)
    packed = subprocess.run([DESKTOP, "pack", "first-touch.md", "--scorm", "--page", PAGE], cwd=folder, check=True, capture_output=True,
                            text=True).stdout
    (folder / "terminal.html").write_text(TERMINAL % html.escape("$ moltact pack first-touch.md --scorm\n" + packed))
    lines = packed.count("\n") + 1
    terminal = Browser(width=760, height=28 + 22 * lines)
    terminal.go((folder / "terminal.html").as_uri())
    terminal.until("document.readyState === 'complete'")
    terminal.screenshot(PICTURES / "platform-pack.png")
    terminal.close()

    with zipfile.ZipFile(folder / "first-touch.scorm12.zip") as archive:
        archive.extractall(folder / "scorm")
    script = (ROOT / "tests/web/scorm_runtime.js").read_text().replace("</script", "<\\/script")
    kept = {"cmi.core.student_id": "ada", "cmi.core.lesson_mode": "normal"}
    (folder / "scorm" / "player.html").write_text(PLAYER % (script, json.dumps(kept)))
    with Served(folder / "scorm", "player.html") as url:
        player = Browser(width=1280, height=800)
        player.go(url)
        player.until("globalThis.moltact && moltact.page.frames > 1", 120)
        player.wait_for("task/0", "current")
        player.frames(60)
        player.screenshot(PICTURES / "platform-player.png")
        player.close()
    shutil.rmtree(folder)


if __name__ == "__main__":
    main()
