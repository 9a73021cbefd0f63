"""A Firefox on a screen of its own (Xvfb: headless it has no WebGL) with the page in it, through Marionette (its own
protocol, on a socket). Python's standard library alone. What it can do of what Browser can: open, evaluate, widgets,
mouse."""
import base64
import json
import os
import shutil
import socket
import subprocess
import tempfile
import time

from browser import Browser

PROGRAM = shutil.which("Xvfb") and (shutil.which("firefox-esr") or shutil.which("firefox"))


class Firefox(Browser):
    def __init__(self, width=1280, height=800):
        self.own = tempfile.mkdtemp(prefix="moltact-firefox-")
        self.width, self.height, self.scale, self.closed, self.events = width, height, 1, False, []
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        numbers, told = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(told), "-screen", "0", f"{width + 100}x{height + 300}x24"],
                                       pass_fds=[told], stderr=subprocess.DEVNULL)
        os.close(told)
        with os.fdopen(numbers) as said:
            display = ":" + said.readline().strip()
        preferences = {"marionette.port": port, "webgl.force-enabled": True, "webgl.disabled": False,
                       "datareporting.policy.dataSubmissionEnabled": False, "app.update.auto": False,
                       "toolkit.telemetry.server": "", "browser.shell.checkDefaultBrowser": False,
                       "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False}
        with open(os.path.join(self.own, "user.js"), "w") as out:
            out.writelines(f"user_pref({json.dumps(k)}, {json.dumps(v)});\n" for k, v in preferences.items())
        self.process = subprocess.Popen([PROGRAM, "--marionette", "--no-remote", "--profile", self.own,
                                         f"--width={width}", f"--height={height}", "about:blank"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                        env={**os.environ, "DISPLAY": display, "LIBGL_ALWAYS_SOFTWARE": "1"})
        end = time.monotonic() + 120
        while True:
            try:
                self.wire = socket.create_connection(("127.0.0.1", port), 5)
                break
            except OSError:
                if time.monotonic() > end or self.process.poll() is not None:
                    raise
                time.sleep(0.2)
        self.number, self.waiting = 0, b""
        self.wire.settimeout(120)
        self.message()  # its greeting
        self.ask("WebDriver:NewSession", {"capabilities": {"alwaysMatch": {"acceptInsecureCerts": True}}})
        self.ask("WebDriver:SetTimeouts", {"script": 300000, "pageLoad": 300000})
        self.ask("WebDriver:SetWindowRect", {"width": width, "height": height})
        inner = self.evaluate("[innerWidth, innerHeight]")
        self.ask("WebDriver:SetWindowRect", {"width": 2 * width - inner[0], "height": 2 * height - inner[1]})

    # ---- the protocol: LENGTH:[kind, number, ...]

    def message(self):
        while b":" not in self.waiting:
            self.waiting += self.some()
        size, _, self.waiting = self.waiting.partition(b":")
        while len(self.waiting) < int(size):
            self.waiting += self.some()
        text, self.waiting = self.waiting[:int(size)], self.waiting[int(size):]
        return json.loads(text)

    def some(self):
        got = self.wire.recv(1 << 16)
        if not got:
            raise RuntimeError("the browser has ended")
        return got

    def ask(self, command, parameters):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters]).encode()
        self.wire.sendall(str(len(text)).encode() + b":" + text)
        while True:
            reply = self.message()
            if reply[1] == self.number:
                if reply[2]:
                    raise RuntimeError(f"{command}: {reply[2].get('error')}: {reply[2].get('message')}")
                return reply[3]

    # ---- what Browser's other functions are made of

    def evaluate(self, text, patience_s=90):
        script = ("const done = arguments[arguments.length - 1];"
                  f"(async () => ({text}))().then((value) => done([value]), (error) => done(String(error)));")
        result = self.ask("WebDriver:ExecuteAsyncScript", {"script": script, "args": []})["value"]
        if not isinstance(result, list):
            raise RuntimeError(result)
        return result[0]

    def go(self, url):
        self.ask("WebDriver:Navigate", {"url": str(url)})

    def mouse(self, kind, x, y, button="none", buttons=0, **more):
        def act(kind, **act):
            source = {"type": "wheel", "id": "wheel"} if kind == "scroll" else {
                "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}}
            self.ask("WebDriver:PerformActions", {"actions": [{**source, "actions": [{"type": kind, **act}]}]})

        if kind == "mouseWheel":
            return act("scroll", x=int(x), y=int(y), deltaX=int(more["deltaX"]), deltaY=int(more["deltaY"]), duration=0,
                       origin="viewport")
        act("pointerMove", x=int(x), y=int(y), duration=0, origin="viewport")
        number = {"left": 0, "middle": 1, "right": 2}.get(button)
        if number is not None and kind != "mouseMoved":
            act("pointerDown" if kind == "mousePressed" else "pointerUp", button=number)

    def call(self, method, **parameters):
        if method == "Input.dispatchMouseEvent":
            kind, x, y = (parameters.pop(k) for k in ("type", "x", "y"))
            return self.mouse(kind, x, y, **parameters)
        raise NotImplementedError(method)

    def screenshot(self, file):
        data = self.ask("WebDriver:TakeScreenshot", {"full": False})["value"]
        with open(file, "wb") as out:
            out.write(base64.b64decode(data))

    def close(self):
        if self.closed:
            return
        self.closed = True
        try:
            self.ask("Marionette:Quit", {"flags": ["eForceQuit"]})
            self.process.wait(20)
        except Exception:  # it is ended in any state
            self.kill()
        finally:
            self.wire.close()
            self.screen.kill()
            self.screen.wait()
            shutil.rmtree(self.own, ignore_errors=True)
