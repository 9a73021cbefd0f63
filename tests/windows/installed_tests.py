"""The installer under Wine: installed over an older one, removed, refused."""
import shutil
import subprocess
import time
import unittest

import wine
from hip_paths import ROOT
from wine import BUILT, DRIVE, WINE

VERSION = next(line.split()[2] for line in (ROOT / "CMakeLists.txt").read_text().splitlines() if line.startswith("project(moltact"))
NAME = f"moltact-{VERSION}-windows-x64"
SETUP = BUILT / f"{NAME}-setup.exe"
# The command line of the installer takes a folder as it is, without quotation marks.
FOLDER, ITS_WORDS = "C:\\Schüler Übung\\Moltact", ["/D=C:\\Schüler", "Übung\\Moltact"]
AT = DRIVE / "Schüler Übung" / "Moltact"
ENTRY = r"HKCU\Software\Microsoft\Windows\CurrentVersion\Uninstall\Moltact"
CLASSES = r"HKCU\Software\Classes"
DONE, REFUSED, OPEN = 0, 2, 3  # statuses of the installer


def listing(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        wine.begin()
        cls.user = next(path for path in (DRIVE / "users").iterdir() if path.name != "Public")
        cls.links = cls.user / "AppData/Roaming/Microsoft/Windows/Start Menu/Programs"
        cls.work = [cls.user / "AppData/Local/moltact/attempts/a.jsonl", cls.user / "AppData/Roaming/moltact/settings.json"]
        cls.built = listing(BUILT / "moltact")
        # An older version, with a file that the new one lacks.
        old = wine.FOLDER / "old"
        shutil.copytree(BUILT / "moltact" / "licences", old / "moltact" / "licences")
        (old / "moltact" / "lessons" / "gone").mkdir(parents=True)
        (old / "moltact" / "lessons" / "gone" / "old.md").write_text("old\n")
        (old / "moltact" / "moltact.exe").write_text("old\n")
        subprocess.run(["cmake", "-D", f"FOLDER={old / 'moltact'}", "-D", f"LISTS={old}", "-P",
                        ROOT / "package/windows/installed_files.cmake"], check=True)
        made = BUILT / "package"
        subprocess.run(["makensis", "-V1", "-WX", "-NOCD", "-DVERSION=0.0.9", "-DVERSION4=0.0.9.0", "-DOUT=old.exe", f"-DLISTS={old}",
                        f"-DLICENCE={made / 'licence.txt'}", f"-DICON={BUILT / 'app/windows/moltact.ico'}",
                        f"-DSIDE={made / 'side.bmp'}", ROOT / "package/windows/moltact.nsi"], check=True, cwd=old)
        cls.old = old / "old.exe"

    def setUp(self):
        shutil.rmtree(AT.parent, ignore_errors=True)
        for file in self.work:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text("{}\n")

    def tearDown(self):
        if (AT / "uninstall.exe").exists():
            self.uninstall()

    def run_wine(self, *arguments, status=0):
        done = subprocess.run([WINE, *arguments], capture_output=True, timeout=300)
        self.assertEqual(done.returncode, status, (done.stdout + done.stderr).decode(errors="replace"))
        return (done.stdout + done.stderr).decode(errors="replace")

    def install(self, setup=SETUP, status=DONE, words=ITS_WORDS):
        self.run_wine(setup, "/S", *words, status=status)

    def uninstall(self, *more):
        """It ends at once: a copy of it does the work, because a program cannot remove itself."""
        self.run_wine(f"{FOLDER}\\uninstall.exe", "/S", *more)
        until = time.monotonic() + 120
        while time.monotonic() < until and (self.registered() or (AT / "uninstall.exe").exists()):
            time.sleep(0.5)
        wine.server("-w") if not self.registered() else None

    def value(self, key, name=None):
        """A value of the registry; empty if it is missing."""
        done = subprocess.run([WINE, "reg", "query", key, *(["/v", name] if name else ["/ve"])], capture_output=True)
        return done.stdout.decode(errors="replace").split("REG_SZ", 1)[-1].strip() if done.returncode == 0 else ""

    def registered(self):
        return self.value(ENTRY, "DisplayVersion")

    def test_over_an_older_version_no_old_file_remains_but_those_of_the_person_do(self):
        self.install(self.old)
        self.assertEqual(self.registered(), "0.0.9")
        own = AT / "lessons" / "own.md"
        own.write_text("own\n")
        self.install()
        self.assertEqual(listing(AT), self.built | {"uninstall.exe", "lessons/own.md"})
        self.assertEqual(self.registered(), VERSION)
        # Into another folder: the one before is removed there.
        self.install(words=["/D=C:\\Elsewhere"])
        self.assertEqual(listing(AT), {"lessons/own.md"})
        self.assertEqual(self.value(ENTRY, "InstallLocation"), "C:\\Elsewhere")
        self.install()
        self.assertFalse((DRIVE / "Elsewhere").exists())
        self.uninstall()
        self.assertEqual(listing(AT), {"lessons/own.md"})

    def test_the_work_goes_only_where_that_is_asked_for(self):
        self.install(self.old)
        self.uninstall("/DELETEWORK")
        for file in self.work:
            self.assertFalse(file.parent.exists())

    def test_folders_that_cannot_be_written_or_hold_the_work_are_refused(self):
        work = "C:\\users\\" + self.user.name + "\\AppData\\Local\\Moltact"
        self.install(status=REFUSED, words=["/D=" + work])
        self.install(status=REFUSED, words=["/D=Z:\\proc\\moltact"])
        self.assertEqual(self.registered(), "")
        self.assertEqual(self.work[0].read_text(), "{}\n")

    def test_the_licences_of_what_is_linked_in_are_there(self):
        text = (BUILT / "moltact" / "licences" / "libraries.txt").read_text()
        for library in ("imgui", "freetype", "zlib", "md4c", "libzip", "glfw", "hidapi", "epoxy", "httplib", "qrencode", "glm", "eigen",
                        "gemmi", "fmt", "stb", "tinygltf", "mingw-w64", "fonts-inter"):
            self.assertIn(library, text.lower())
        self.assertIn("MIT License", (BUILT / "moltact" / "licences" / "moltact.txt").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
