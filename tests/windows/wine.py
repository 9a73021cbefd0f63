"""Wine for the tests of the build for Windows: a folder and a virtual display of its own for each run. OpenGL comes from Mesa in
software."""
import atexit
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hip_path"))
from hip_paths import ROOT  # noqa: E402

BUILT = ROOT / "build" / "windows"
PROGRAM = BUILT / "moltact" / "moltact.exe"
PICTURES = BUILT / "pictures"  # what was seen, for a person to look at
WINE = shutil.which("wine64") or "/usr/lib/wine/wine64"  # where Debian has it
FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="moltact-wine-"))
DRIVE = FOLDER / "wine" / "drive_c"
DISPLAY = None  # the X server's process

# ALSA without a sound card: what is played goes to this file.
PLAYED = FOLDER / "played.raw"
ALSA = f"""pcm.sink {{ type null }}
pcm.!default {{
  type plug
  slave {{ pcm {{ type file file "{PLAYED}" format raw slave.pcm sink }} format S16_LE channels 2 rate 48000 }}
}}
"""


def server(*arguments):
    program = pathlib.Path(WINE).with_name("wineserver64")
    subprocess.run([program if program.exists() else "wineserver", *arguments], stderr=subprocess.DEVNULL)


def begin():
    """Starts the display, and Wine as Windows 10, once."""
    global DISPLAY
    if DISPLAY:
        return
    reading, writing = os.pipe()
    DISPLAY = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1400x900x24", "-nolisten", "tcp"],
                               pass_fds=[writing], stderr=subprocess.DEVNULL)
    atexit.register(end)
    os.close(writing)
    number = os.read(reading, 16).decode().strip()
    # Without the second, Wine would enter the menu of this computer's desktop.
    os.environ.update(WINEPREFIX=str(FOLDER / "wine"), WINEDEBUG="-all", WINEDLLOVERRIDES="winemenubuilder.exe=d",
                      DISPLAY=f":{number}", MOLTACT_LANGUAGE="en")
    PICTURES.mkdir(exist_ok=True)
    subprocess.run([WINE, "winecfg", "/v", "win10"], check=True, timeout=300, stderr=subprocess.DEVNULL)


def end():
    server("-k")
    DISPLAY.terminate()
    DISPLAY.wait()
    shutil.rmtree(FOLDER, ignore_errors=True)


def there(path):
    """A path of this system as a program under Wine names it."""
    return "Z:" + str(path).replace("/", "\\")


def colours(picture, *changed):
    """The bytes red, green, blue of each pixel."""
    return subprocess.run(["convert", picture, *changed, "-depth", "8", "rgb:-"], check=True, capture_output=True).stdout


def apart(one, other, *changed):
    """How far two pictures are apart in the mean (of 255), and the share of their bytes that differ by more than 16."""
    a, b = colours(one, *changed), colours(other, *changed)
    if len(a) != len(b):
        raise AssertionError(f"{one} and {other} differ in size")
    differences = [abs(x - y) for x, y in zip(a, b)]
    return sum(differences) / len(a), sum(d > 16 for d in differences) / len(a)


def shown(picture, *changed):
    """The share of pixels that have another colour than most."""
    bytes_of = colours(picture, *changed)
    pixels = [bytes_of[k:k + 3] for k in range(0, len(bytes_of), 3)]
    return 1 - pixels.count(max(set(pixels), key=pixels.count)) / len(pixels)


def window_of_moltact(until, alive=lambda: True):
    """The number of the program's window, once it is there."""
    while alive() and time.monotonic() < until:
        window = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Moltact$"], capture_output=True,
                                text=True).stdout.split("\n")[0]
        if window:
            return window
        time.sleep(0.5)
    raise AssertionError("no window came")


def show_molecule(window, seen, until):
    """Waits until the window shows a molecule; returns the share of its view that is not background."""
    share = 0.0
    while share < 0.3 and time.monotonic() < until:
        time.sleep(2)
        subprocess.run(["import", "-window", window, seen], check=True)
        # A part of the window that shows the molecule.
        share = shown(seen, "-crop", "400x400+700+150", "+repage")
    return share
