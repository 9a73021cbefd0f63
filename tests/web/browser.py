"""A headless Chromium with the page in it, driven as a student would: real mouse, key and touch events, through the
DevTools protocol on a pipe. Python's standard library alone."""
import base64
import fcntl
import json
import os
import pathlib
import select
import shutil
import subprocess
import tempfile
import time


class Browser:
    """One browser process with one profile: what the page keeps lasts as long as `profile`."""

    def __init__(self, profile=None, downloads=None, width=1280, height=800, touch=False, scale=1, script="", arguments=()):
        """`script` runs in every page before its own; `arguments` are the browser's."""
        self.own = tempfile.mkdtemp(prefix="moltact-web-")
        self.profile = profile or os.path.join(self.own, "profile")
        self.downloads = downloads or os.path.join(self.own, "downloads")
        os.makedirs(self.downloads, exist_ok=True)
        to_browser, self.to = os.pipe()
        self.out, from_browser = os.pipe()
        program = next(p for p in ("/usr/lib/chromium/chromium", "/usr/bin/chromium") if os.path.exists(p))

        def fds():
            # By way of high numbers: 3 and 4 may be taken by the pipes themselves.
            high = fcntl.fcntl(to_browser, fcntl.F_DUPFD, 100), fcntl.fcntl(from_browser, fcntl.F_DUPFD, 100)
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)

        self.process = subprocess.Popen(
            [program, "--headless=new", "--remote-debugging-pipe", "--no-first-run", "--disable-background-networking",
             "--disable-component-update", "--disable-sync", "--no-default-browser-check", "--mute-audio",
             # As Chromium runs without a graphics card: WebGL and compositing in software.
             "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", *arguments,
             f"--user-data-dir={self.profile}", f"--window-size={width},{height}"]
            + (["--no-sandbox"] if os.getuid() == 0 else []) + ["about:blank"],
            close_fds=False, preexec_fn=fds, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.waiting, self.number, self.events, self.closed = b"", 0, [], False
        self.width, self.height, self.scale = width, height, scale
        target = next(t for t in self.call("Target.getTargets")["targetInfos"] if t["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log", "Performance"):
            self.call(f"{domain}.enable")
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale, mobile=touch)
        if touch:
            self.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=5)
        if script:
            self.call("Page.addScriptToEvaluateOnNewDocument", source=script)
        self.call("Browser.setDownloadBehavior", browser_wide=True, behavior="allow", downloadPath=self.downloads)

    # ---- the protocol

    def read(self, until_s):
        while b"\0" not in self.waiting:
            if not select.select([self.out], [], [], max(0.0, until_s - time.monotonic()))[0]:
                return None
            some = os.read(self.out, 1 << 20)
            if not some:
                raise RuntimeError("the browser has ended")
            self.waiting += some
        message, _, self.waiting = self.waiting.partition(b"\0")
        return json.loads(message)

    def send(self, method, browser_wide=False, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if not browser_wide and getattr(self, "session", None):
            message["sessionId"] = self.session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        return self.number

    def call(self, method, browser_wide=False, patience_s=90, **parameters):
        number = self.send(method, browser_wide, **parameters)
        until = time.monotonic() + patience_s
        while True:
            reply = self.read(until)
            if reply is None:
                raise TimeoutError(f"{method}: no answer in {patience_s} s")
            if reply.get("id") == number:
                if "error" in reply:
                    raise RuntimeError(f"{method}: {reply['error']}")
                return reply.get("result", {})
            self.events.append(reply)

    def evaluate(self, text, patience_s=90):
        result = self.call("Runtime.evaluate", expression=text, returnByValue=True, awaitPromise=True, patience_s=patience_s)
        if "exceptionDetails" in result:
            raise RuntimeError(json.dumps(result["exceptionDetails"])[:600])
        return result["result"].get("value")

    def kill(self):
        """As a computer that is switched off."""
        self.process.kill()
        self.process.wait()

    def close(self):
        if self.closed:
            return
        self.closed = True
        try:
            if self.process.poll() is None:
                self.call("Browser.close", browser_wide=True, patience_s=10)
                self.process.wait(10)
        except Exception:  # it is ended in any state
            self.kill()
        finally:
            os.close(self.to)
            os.close(self.out)
            shutil.rmtree(self.own, ignore_errors=True)

    # ---- the page

    def go(self, url):
        self.call("Page.navigate", url=str(url))

    def open(self, url, patience_s=120):
        """Opens the page; the seconds until its welcome page stands, all lessons read."""
        begun = time.monotonic()
        self.go(url)
        self.until("globalThis.moltact && moltact.page.frames > 1 && (() => { const all = Object.entries(JSON.parse("
                   "moltact.ccall('moltact_widgets','string',[],[]))).filter(([n]) => n.startsWith('welcome/lesson/'));"
                   " return all.length > 5 && all.every(([, w]) => w[4].includes('min')); })()", patience_s)
        return time.monotonic() - begun

    def until(self, condition, patience_s=60):
        end = time.monotonic() + patience_s
        while True:
            try:
                if self.evaluate(f"Boolean({condition})"):
                    return
            except RuntimeError:
                pass  # the page is being changed for another
            if time.monotonic() > end:
                raise TimeoutError(f"not in {patience_s} s: {condition}; console: {self.console()[-3:]}")
            time.sleep(0.05)

    def frames(self, n=3):
        now = self.evaluate("moltact.page.frames")
        self.until(f"moltact.page.frames >= {now + n}")

    def widgets(self):
        return json.loads(self.evaluate("moltact.ccall('moltact_widgets','string',[],[])"))

    def said(self):
        """The messages over the view."""
        return [w[4] for n, w in self.widgets().items() if n.startswith("message/") and n.count("/") == 1]

    def text(self, name):
        found = self.widgets().get(name)
        return found[4] if found else None

    def wait_for(self, name, text="", patience_s=120, seen=False):
        end = time.monotonic() + patience_s
        while True:
            found = self.widgets().get(name)
            if found and text in found[4] and (found[5] or not seen):
                return found
            if time.monotonic() > end:
                raise TimeoutError(f"no {name!r} with {text!r}; there are {[n for n, w in self.widgets().items() if w[5]]}")
            time.sleep(0.1)

    def place(self, name, x=0.5, y=0.5):
        """Of a widget, in the page's own pixels."""
        for _ in range(40):
            low_x, low_y, high_x, high_y, _, visible = self.wait_for(name)
            # Of a card at the edge only a part is seen; the status bar covers the rest.
            covered = name.startswith("welcome/") and low_y + y * (high_y - low_y) > (self.height - 40) * self.scale
            if visible and not covered:
                break
            # Scrolled out of sight: brought into it by the wheel.
            way = 120 if low_y > self.height / 2 * self.scale else -120
            over = ((low_x + high_x) / 2 / self.scale, self.height / 2)
            self.mouse("mouseMoved", *over)
            self.frames(1)
            self.mouse("mouseWheel", *over, deltaX=0, deltaY=way)
            self.frames(3)
        return ((low_x + x * (high_x - low_x)) / self.scale, (low_y + y * (high_y - low_y)) / self.scale)

    def screenshot(self, file):
        data = self.call("Page.captureScreenshot", format="png")["data"]
        pathlib.Path(file).write_bytes(base64.b64decode(data))

    def console(self):
        out = []
        for event in self.events:
            if event.get("method") == "Runtime.consoleAPICalled":
                out.append(" ".join(str(a.get("value", a.get("description", ""))) for a in event["params"]["args"]))
            elif event.get("method") == "Runtime.exceptionThrown":
                out.append(json.dumps(event["params"])[:800])
            elif event.get("method") == "Log.entryAdded":
                out.append(event["params"]["entry"]["text"])
        return out

    def requests(self):
        """Every address that the page asked for, but for what came with it."""
        return [e["params"]["request"]["url"] for e in self.events if e.get("method") == "Network.requestWillBeSent"]

    # ---- the hand

    def mouse(self, kind, x, y, button="none", buttons=0, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, buttons=buttons,
                  clickCount=1 if kind != "mouseMoved" else 0, **more)

    def click(self, name, x=0.5, y=0.5):
        at = self.place(name, x, y)
        self.mouse("mouseMoved", *at)
        self.frames(2)
        self.mouse("mousePressed", *at, button="left", buttons=1)
        self.frames(2)
        self.mouse("mouseReleased", *at, button="left")
        self.frames(3)

    def touch(self, kind, *places):
        self.call("Input.dispatchTouchEvent", type=kind,
                  touchPoints=[{"x": x, "y": y, "id": k} for k, (x, y) in enumerate(places)])

    def pen(self, kind, x, y, pressure, buttons=1):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left" if buttons else "none", buttons=buttons,
                  clickCount=1 if kind != "mouseMoved" else 0, pointerType="pen", force=pressure)

    def tap(self, name):
        at = self.place(name)
        # Without waiting in between, however slow the machine is: a finger that rests tells instead.
        self.send("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": at[0], "y": at[1], "id": 0}])
        self.touch("touchEnd")
        self.frames(4)

    def type(self, text):
        for c in text:
            code = {" ": "Space", ".": "Period", ",": "Comma"}.get(c, "Digit" + c if c.isdigit() else "Key" + c.upper())
            self.call("Input.dispatchKeyEvent", type="keyDown", text=c, key=c, code=code)
            self.call("Input.dispatchKeyEvent", type="keyUp", key=c, code=code)
        self.frames(3)

    def key(self, code, key=None, modifiers=0):
        for down in (True, False):
            self.hold(code, down, key, modifiers)
        self.frames(3)

    def hold(self, code, down, key=None, modifiers=0, **more):
        self.call("Input.dispatchKeyEvent", type="rawKeyDown" if down else "keyUp", key=key or code, code=code,
                  modifiers=modifiers, **more)
