#!/usr/bin/env python3
"""Measures the browser edition beside the desktop's program, on this computer without a graphics card:
python3 tests/web/speed.py [start] [lessons] [frames] [memory] [ticks]. The table stands in docs/browser.md.
The processor's time is that of all processes of the browser; other than seconds of the clock it is hardly longer where
other programs share the processor."""
import http.server
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.dirname(__file__))
from browser import Browser  # noqa: E402
from page import DESKTOP, PAGE, ROOT  # noqa: E402

TIMES = 3
FRAMES = 150
LARGE = "four-chains-as-one"  # 4 558 atoms


def told(what, values, unit):
    print(f"{what}: {statistics.median(values):.2f} {unit} (median of {len(values)}, "
          f"{min(values):.2f} to {max(values):.2f})", flush=True)


def used_s(browser):
    """The processor's time of the browser and of all that it began, so far."""
    parents, ticks = {}, {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue  # it has just ended
        pid = int(stat.parent.name)
        parents[pid], ticks[pid] = int(fields[1]), int(fields[11]) + int(fields[12])
    of_it, grown = {browser.process.pid}, True
    while grown:
        more = {pid for pid, parent in parents.items() if parent in of_it} - of_it
        of_it |= more
        grown = bool(more)
    return sum(ticks.get(pid, 0) for pid in of_it) / os.sysconf("SC_CLK_TCK")


def start():
    seconds, used = [], []
    for _ in range(TIMES):
        browser = Browser()
        try:
            before = used_s(browser)
            seconds.append(browser.open(PAGE.as_uri()))
            used.append(used_s(browser) - before)
        finally:
            browser.close()
    told("from the file to the welcome page with all its lessons", seconds, "s")
    told("  the processor's time for it", used, "s")
    told("  the desktop's", [desktop("wait 5\n")[1] for _ in range(TIMES)], "s")
    print(f"the file: {PAGE.stat().st_size / 2**20:.2f} MiB")


def opening(browser, lesson):
    """Seconds from the click on the lesson's card to the frame that shows its molecule."""
    at = browser.place(f"welcome/lesson/{lesson}")
    for kind in ("mouseMoved", "mousePressed", "mouseReleased"):
        begun = time.monotonic()
        browser.mouse(kind, *at, button="left" if kind != "mouseMoved" else "none")
        browser.frames(1)
        if kind == "mousePressed":
            pressed = begun
    browser.wait_for("view/scale bar")
    browser.frames(1)
    return time.monotonic() - pressed


def cards_drawn(browser):
    """Until no picture of a lesson's card has come for 3 s."""
    browser.until("""(() => {
        const cards = moltact.FS.readdir("/home/web_user/.cache/moltact").length, now = performance.now();
        if (cards !== globalThis.cards) [globalThis.cards, globalThis.since] = [cards, now];
        return now - globalThis.since > 3000; })()""", 300)


def lessons():
    browser = Browser()
    try:
        browser.open(PAGE.as_uri())
        before = used_s(browser)
        cards_drawn(browser)
        print(f"the pictures of the cards, once: {used_s(browser) - before:.1f} s of the processor's time", flush=True)
        for lesson in ("first-touch", "dna-grooves-blind", LARGE, "a-virus-in-the-hand"):
            seconds, used = [], []
            for _ in range(TIMES):
                before = used_s(browser)
                seconds.append(opening(browser, lesson))
                used.append(used_s(browser) - before)
                browser.click("tool/welcome")
                browser.wait_for(f"welcome/lesson/{lesson}")
                browser.until("!JSON.parse(moltact.ccall('moltact_widgets','string',[],[]))['view/scale bar']")
                browser.frames(10)  # the cards have found their places
            told(f"from the click to the picture of {lesson}", seconds, "s")
            told("  the processor's time for it", used, "s")
            welcome, opened = desktop("wait 60\n"), desktop(f"wait 60\nclick welcome/lesson/{lesson}\nwait 3\n")
            print(f"  the desktop's: {opened[1] - welcome[1]:.2f} s", flush=True)
    finally:
        browser.close()


def frames():
    """The same molecule turned by the same keys at 1280 x 800, in the page and in the desktop's window off-screen."""
    browser = Browser()
    try:
        browser.open(PAGE.as_uri())
        opening(browser, LARGE)
        browser.frames(30)
        # A key that does nothing asks for a frame all the same.
        browser.evaluate("void (globalThis.asking = setInterval(() => "
                         "dispatchEvent(new KeyboardEvent('keyup', {code: 'F13'})), 5))")
        before_s, first = used_s(browser), browser.evaluate("moltact.page.frames")
        browser.frames(FRAMES // 3)
        still = (used_s(browser) - before_s) / (browser.evaluate("moltact.page.frames") - first)
        print(f"page, where nothing moves: {1000 * still:.1f} ms of the processor's time a frame", flush=True)
        browser.evaluate("clearInterval(asking)")
        browser.hold("ControlLeft", True, "Control", 2)
        browser.hold("ArrowRight", True, None, 2)
        browser.frames(10)
        before_s, first = used_s(browser), browser.evaluate("moltact.page.frames")
        times = browser.evaluate(f"""new Promise((done) => {{
            const times = []; let before = 0, drawn = moltact.page.frames;
            const step = (now) => {{
                if (moltact.page.frames > drawn) {{ if (before) times.push(now - before); before = now; drawn = moltact.page.frames; }}
                times.length < {FRAMES} ? requestAnimationFrame(step) : done(times);
            }};
            requestAnimationFrame(step); }})""", patience_s=300)
        used = (used_s(browser) - before_s) / (browser.evaluate("moltact.page.frames") - first)
        print(f"page: {1000 / statistics.mean(times):.1f} frames a second ({statistics.median(times):.1f} ms at the median), "
              f"{1000 * used:.1f} ms of the processor's time a frame", flush=True)
    finally:
        browser.close()
    there = f"wait 60\nclick welcome/lesson/{LARGE}\nwait 60\nhold Ctrl\nhold Right\nwait 10\n"
    still, turning = desktop(there), desktop(there + f"wait {FRAMES}\n")
    took_s, used = (b - a for a, b in zip(still[:2], turning[:2]))
    print(f"desktop, off-screen: {FRAMES / took_s:.1f} frames a second, {1000 * used / FRAMES:.1f} ms of the processor's time "
          f"a frame", flush=True)


def desktop(steps):
    """The desktop's program off-screen, every frame drawn: seconds of the clock, seconds of the processor, MiB of memory at
    most of any of its runs so far."""
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder) / "steps.script"
        script.write_text(steps)

        def used_by_children():
            usage = resource.getrusage(resource.RUSAGE_CHILDREN)
            return usage.ru_utime + usage.ru_stime

        begun, before = time.monotonic(), used_by_children()
        subprocess.run([DESKTOP, "--script", script, "--size", "1280x800", "--frame-stats", "--language", "en"],
                       check=True, capture_output=True, env={**os.environ, "MOLTACT_HOME": str(ROOT), "HOME": folder})
        return (time.monotonic() - begun, used_by_children() - before,
                resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024)


def memory():
    there = f"wait 60\nclick welcome/lesson/{LARGE}\nwait 60\n"
    browser = Browser()
    try:
        browser.open(PAGE.as_uri())
        report = []
        for where in ("welcome page", LARGE):
            if where == LARGE:
                opening(browser, LARGE)
                browser.frames(60)
            wasm = browser.evaluate("moltact.HEAPU8.length")
            metrics = {m["name"]: m["value"] for m in browser.call("Performance.getMetrics")["metrics"]}
            report.append(f"{where}: {wasm / 2**20:.0f} MiB of the program, {metrics['JSHeapUsedSize'] / 2**20:.0f} MiB of JavaScript")
        print("\n".join(report), flush=True)
        print(f"desktop, {LARGE}: {desktop(there)[2]:.0f} MiB at most", flush=True)
    finally:
        browser.close()


class Isolated(http.server.BaseHTTPRequestHandler):
    def log_message(self, *_):
        pass

    def do_GET(self):
        self.send_response(200)
        self.send_header("Content-Type", "text/html")
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.end_headers()
        self.wfile.write(b"<canvas></canvas>")


# How late a worker of its own wakes for each millisecond, as a touch loop on a thread would.
WORKER = """
onmessage = () => {
  const cell = new Int32Array(new SharedArrayBuffer(4)), late = [];
  const begun = performance.now();
  for (let k = 1; k <= 5000; ++k) {
    const left = begun + k - performance.now();
    if (left > 0) Atomics.wait(cell, 0, 0, left);
    late.push(performance.now() - begun - k);
  }
  postMessage(late);
};
"""


def ticks():
    """How late a millisecond's tick begins: on a worker where the page is cross-origin isolated, and with the frames."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Isolated)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browser = Browser()
    try:
        browser.go(f"http://127.0.0.1:{server.server_port}/")
        browser.until("globalThis.crossOriginIsolated")
        late = browser.evaluate(f"""new Promise((done) => {{
            const worker = new Worker(URL.createObjectURL(new Blob([{json.dumps(WORKER)}])));
            worker.onmessage = (e) => done(e.data); worker.postMessage(0); }})""", patience_s=60)
        late.sort()
        print(f"worker: ticks late by {late[len(late) // 2]:.2f} ms at the median, {late[int(0.99 * len(late))]:.2f} ms at "
              f"99 of 100, {late[-1]:.2f} ms at most", flush=True)
        browser.open(PAGE.as_uri())
        opening(browser, "first-touch")
        at = browser.place("view")
        browser.mouse("mouseMoved", *at)
        browser.mouse("mousePressed", *at, button="left", buttons=1)
        browser.frames(5)
        gaps = browser.evaluate("""new Promise((done) => { const gaps = []; let before = 0;
            const step = (now) => { if (before) gaps.push(now - before); before = now;
                gaps.length < 100 ? requestAnimationFrame(step) : done(gaps); }; requestAnimationFrame(step); })""",
                                patience_s=300)
        # The first tick of a frame is late by the whole frame, the last by nothing.
        ages = sorted(gap - k for gap in gaps for k in range(int(gap) + 1))
        print(f"with the frames: ticks late by {ages[len(ages) // 2]:.1f} ms at the median, {ages[int(0.99 * len(ages))]:.1f} ms at "
              f"99 of 100, {ages[-1]:.1f} ms at most", flush=True)
    finally:
        browser.close()
        server.shutdown()


if __name__ == "__main__":
    known = {f.__name__: f for f in (start, lessons, frames, memory, ticks)}
    for name in sys.argv[1:] or known:
        known[name]()
