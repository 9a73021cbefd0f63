#!/usr/bin/env python3
"""Tries the real window with fingers, in an X server whose touch screen is made up in software (Xorg's drivers `dummy` and
`inputtest`): python3 tests/touch_screen/run.py [part of a test's name …]. Where there is no such server it says so and exits
with 77, which ctest takes as skipped. What was seen lies in build/touch_screen, for a person to look at. MOLTACT_BINARY: the
program, another than the release build's."""
import os
import pathlib
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = pathlib.Path(os.environ.get("MOLTACT_BINARY", ROOT / "build" / "release" / "moltact"))
LESSON = ROOT / "lessons" / "first-touch.md"
PICTURES = ROOT / "build" / "touch_screen"
SCREEN = (1600, 900)
DRIVERS = [pathlib.Path("/usr/lib/xorg/modules") / name for name in ("drivers/dummy_drv.so", "input/inputtest_drv.so")]

# Places in the window, which is 1280 by 800 in the screen's upper left corner, with a lesson open.
ATOMS = (671, 402)
BESIDE = (450, 620)  # in the view, where the probe meets nothing
HARDER = (952, 370)  # a pad
NEXT = (226, 738)
SHOW_TOUCH_PANEL = (1155, 18)
# Parts of it: left, top, right, bottom.
VIEW = (420, 180, 920, 560)
PADS = (920, 340, 985, 460)
TEXT = (10, 180, 320, 640)
TIP = (1000, 36, 1279, 90)
TOUCH_PANEL = (1000, 270, 1279, 460)

CONFIGURATION = """
Section "ServerFlags"
  Option "AutoAddDevices" "off"
  Option "DontVTSwitch" "on"
EndSection
Section "Device"
  Identifier "card"
  Driver "dummy"
  VideoRam 64000
EndSection
Section "Monitor"
  Identifier "monitor"
  HorizSync 5-1000
  VertRefresh 5-200
EndSection
Section "Screen"
  Identifier "screen"
  Device "card"
  Monitor "monitor"
  DefaultDepth 24
  SubSection "Display"
    Depth 24
    Modes "{0}x{1}"
    Virtual {0} {1}
  EndSubSection
EndSection
Section "InputDevice"
  Identifier "fingers"
  Driver "inputtest"
  Option "DeviceType" "Touch"
  Option "TouchCount" "10"
  Option "SocketPath" "{2}"
  Option "CorePointer" "on"
EndSection
Section "ServerLayout"
  Identifier "layout"
  Screen "screen"
  InputDevice "fingers"
EndSection
"""


def missing():
    """What is not installed; None where all is."""
    for program in ("Xorg", "import", "xdotool"):
        if not shutil.which(program):
            return program
    return next((driver for driver in DRIVERS if not driver.exists()), None)


class Server:
    """The X server with the touch screen."""

    def __init__(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-fingers-"))
        self.socket = self.folder / "fingers"
        self.log = self.folder / "log"
        configuration = self.folder / "xorg.conf"
        configuration.write_text(CONFIGURATION.format(*SCREEN, self.socket))
        reading, writing = os.pipe()
        self.process = subprocess.Popen(
            ["Xorg", "-displayfd", str(writing), "-config", configuration, "-noreset", "-novtswitch", "-sharevts",
             "-nolisten", "tcp", "-logfile", self.log],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as number:
            self.display = number.readline().strip()  # empty where it did not start

    def end(self):
        self.process.terminate()
        self.process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)


class Fingers:
    """What the driver inputtest is told through its socket (xf86-input-inputtest-protocol.h of the X server)."""
    VERSION, SYNC, TOUCH = 0, 1, 6
    BEGIN, UPDATE, END = 18, 19, 20  # as XInput 2 numbers them
    AXIS = 0xffff
    VALUATORS = 64

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.settimeout(10)
        self.socket.connect(str(path))
        self.send(self.VERSION, struct.pack("=HH", 1, 1))
        self.socket.recv(12, socket.MSG_WAITALL)

    def send(self, kind, body):
        self.socket.sendall(struct.pack("=II", 8 + len(body), kind) + body)

    def touch(self, kind, finger, x, y):
        """Until the server has seen to it."""
        at = [x / SCREEN[0] * self.AXIS, y / SCREEN[1] * self.AXIS] + [0.0] * (self.VALUATORS - 2)
        valuators = struct.pack("=I8s4x", 0, bytes([3])) + struct.pack(f"={self.VALUATORS}d", *at) + bytes(8 * self.VALUATORS)
        self.send(self.TOUCH, struct.pack("=II", finger, kind) + valuators)
        self.send(self.SYNC, b"")
        self.socket.recv(8, socket.MSG_WAITALL)

    def down(self, finger, x, y):
        self.touch(self.BEGIN, finger, x, y)

    def move(self, finger, x, y):
        self.touch(self.UPDATE, finger, x, y)

    def up(self, finger, x, y):
        self.touch(self.END, finger, x, y)


def differ(one, other):
    """The share of bytes of two pictures that differ by more than 16 of 255."""
    return sum(abs(a - b) > 16 for a, b in zip(one, other)) / len(one)


def dark(pixels):
    """How many pixels are as dark as carbon."""
    return sum(pixels[k] < 150 for k in range(0, len(pixels), 3))


class TouchScreen(unittest.TestCase):
    server = fingers = None

    def setUp(self):
        folder = pathlib.Path(tempfile.mkdtemp(prefix="moltact-window-"))
        self.addCleanup(shutil.rmtree, folder, ignore_errors=True)
        self.environment = {**os.environ, "DISPLAY": f":{self.server.display}", "MOLTACT_LANGUAGE": "en",
                            "XDG_CONFIG_HOME": str(folder / "config"), "XDG_DATA_HOME": str(folder / "data")}
        self.lines = folder / "state"
        self.program = subprocess.Popen([PROGRAM, LESSON, "--state-text", self.lines], env=self.environment)
        self.addCleanup(self.end)
        self.wait_for("step 1 of", 60)
        self.still(VIEW)

    def end(self):
        self.program.terminate()
        self.assertEqual(self.program.wait(60), 0)

    def said(self):
        return self.lines.read_text() if self.lines.exists() else ""

    def wait_for(self, words, most_s=30, times=1):
        """Until the program has said it so many times."""
        end = time.monotonic() + most_s
        while self.said().count(words) < times:
            self.assertIsNone(self.program.poll(), "the program has ended")
            self.assertLess(time.monotonic(), end, f"{words!r} was not said {times} times:\n{self.said()}")
            time.sleep(0.05)

    def seen(self, part):
        """The pixels of a part of the window: red, green, blue."""
        return self.take(part, "rgb:-")

    def keep(self, name):
        self.take((0, 0, 1280, 800), f"png:{PICTURES / name}.png")

    def take(self, part, to):
        left, top, right, bottom = part
        return subprocess.run(
            ["import", "-window", "root", "-crop", f"{right - left}x{bottom - top}+{left}+{top}", "-depth", "8", to],
            env=self.environment, check=True, capture_output=True).stdout

    def wait_until(self, what, seen, most_s=30):
        end = time.monotonic() + most_s
        while not seen():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.1)

    def still(self, part):
        """What is seen there once it stays the same for half a second."""
        now = [b""]

        def rests():
            time.sleep(0.5)
            before, now[0] = now[0], self.seen(part)
            return now[0] == before

        self.wait_until("the picture does not come to rest", rests)
        return now[0]

    def mouse(self, *acts):
        subprocess.run(["xdotool", *map(str, acts)], env=self.environment, check=True)

    def two(self, begin, end):
        """Two fingers, each from its first place to its last; the first is down a moment before."""
        for finger, at in enumerate(begin):
            self.fingers.down(finger, *at)
        for k in range(1, 11):
            for finger, (from_, to) in enumerate(zip(begin, end)):
                self.fingers.move(finger, *(a + (b - a) * k / 10 for a, b in zip(from_, to)))
            time.sleep(0.02)
        for finger, at in enumerate(end):
            self.fingers.up(finger, *at)

    def test_one_finger_pushes_another_on_the_pad_pushes_harder_and_one_that_leaves_the_window_comes_back(self):
        self.fingers.down(1, *ATOMS)
        self.wait_for("touching: carbon")
        self.wait_for("Push further in.")
        self.keep("push")
        self.fingers.down(2, *HARDER)
        self.wait_for("You are on the surface.")
        self.fingers.up(2, *HARDER)
        self.fingers.move(1, SCREEN[0] - 5, ATOMS[1])
        self.wait_for("not touching", times=2)  # as in the beginning
        touched = self.said().count("touching: carbon")
        self.fingers.move(1, *ATOMS)
        self.wait_for("touching: carbon", times=touched + 1)
        self.fingers.up(1, *ATOMS)
        self.wait_for("not touching", times=3)

    def test_two_fingers_turn_and_magnify_the_molecule_and_push_nothing(self):
        x, y = BESIDE
        self.fingers.down(0, x, y)  # the probe moves there
        self.fingers.up(0, x, y)
        before = self.still(VIEW)
        self.two([(x, y), (x + 100, y)], [(x + 90, y), (x + 190, y)])
        turned = self.still(VIEW)
        self.keep("turned")
        self.assertGreater(differ(before, turned), 0.2)
        self.two([(x + 90, y), (x + 190, y)], [(x, y), (x + 100, y)])
        self.assertLess(differ(before, self.still(VIEW)), 0.08)  # but for the probe, which is elsewhere
        self.two([(x, y), (x + 100, y)], [(x - 50, y), (x + 150, y)])
        magnified = self.still(VIEW)
        self.keep("magnified")
        self.assertGreater(dark(magnified), 2 * dark(before))
        self.assertNotIn("touching: ", self.said())

    def test_a_tap_is_one_click_a_long_press_none_it_tells_what_lies_there_and_a_finger_that_moves_scrolls(self):
        panel, above = self.seen(TOUCH_PANEL), self.seen(TIP)
        self.fingers.down(1, *SHOW_TOUCH_PANEL)
        self.wait_until("a long press tells nothing", lambda: differ(above, self.seen(TIP)) > 0.01)
        time.sleep(1)
        self.keep("long-press")
        self.fingers.up(1, *SHOW_TOUCH_PANEL)
        self.wait_until("what a long press told stays", lambda: differ(above, self.seen(TIP)) == 0)
        self.assertEqual(panel, self.still(TOUCH_PANEL))
        self.fingers.down(1, *SHOW_TOUCH_PANEL)
        self.fingers.up(1, *SHOW_TOUCH_PANEL)
        self.wait_until("a tap hides no panel", lambda: differ(panel, self.seen(TOUCH_PANEL)) > 0.01)

        text = self.still(TEXT)
        x, y = TEXT[0] + 100, TEXT[3] - 40
        self.fingers.down(1, x, y)
        for k in range(1, 21):
            self.fingers.move(1, x, y - 10 * k)
        self.fingers.up(1, x, y - 200)
        self.assertGreater(differ(text, self.still(TEXT)), 0.03)
        self.keep("scrolled")

        self.fingers.down(1, *NEXT)
        self.fingers.up(1, *NEXT)
        self.wait_for("step 2 of")
        time.sleep(1)
        self.assertNotIn("step 3 of", self.said())

    def test_a_mouse_leads_again_after_a_finger_and_its_button_pushes(self):
        pads = self.seen(PADS)
        self.fingers.down(1, *BESIDE)
        self.fingers.up(1, *BESIDE)
        self.wait_until("no pads come", lambda: differ(pads, self.seen(PADS)) > 0.02)
        self.mouse("mousemove", *ATOMS)
        self.wait_until("the pads stay", lambda: differ(pads, self.seen(PADS)) < 0.005)
        self.mouse("mousedown", 1)
        self.wait_for("touching: carbon")
        self.mouse("mouseup", 1)
        self.wait_for("not touching", times=2)


def main():
    if what := missing():
        print(f"left out: {what} is not installed (Debian: xserver-xorg-core, xserver-xorg-video-dummy, imagemagick, xdotool)")
        return 77
    server = TouchScreen.server = Server()
    try:
        if not server.display:
            print(f"left out: Xorg does not start here:\n{server.log.read_text()[-2000:] if server.log.exists() else ''}")
            return 77
        TouchScreen.fingers = Fingers(server.socket)
        PICTURES.mkdir(parents=True, exist_ok=True)
        loader = unittest.TestLoader()
        if sys.argv[1:]:
            loader.testNamePatterns = [f"*{name}*" for name in sys.argv[1:]]
        result = unittest.TextTestRunner(verbosity=2).run(loader.loadTestsFromTestCase(TouchScreen))
        return 0 if result.wasSuccessful() and result.testsRun else 1
    finally:
        if TouchScreen.fingers:
            TouchScreen.fingers.socket.close()
        server.end()


if __name__ == "__main__":
    sys.exit(main())
