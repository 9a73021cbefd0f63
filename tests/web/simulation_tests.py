"""A simulation in the page: OpenMM's platform Reference in a worker, against the native one and against closed forms."""
import math
import os
import re
import subprocess

from files_tests import FilesTest
from page import DESKTOP, PAGE, ROOT
from simulation_driver import drive

LESSON = """---
title: Alive
minutes: 5
goals: Touch it
molecules: {molecule}
author: A. Teacher
licence: CC-BY-4.0
---
## The first step
```scene
molecule: {molecule}
simulation: {system}
panels: motion
```
```touch
reach: residue 2
say: Touch it.
```
"""

DIPEPTIDE = ROOT / "molecules" / "alanine-dipeptide.pdb"


class SimulationTest(FilesTest):
    def page(self):
        browser = self.browser()
        browser.open(PAGE.as_uri())
        return browser

    def lesson(self, browser, molecule="alanine-dipeptide", system="alanine-dipeptide.xml", **files):
        folder = self.folder()
        (folder / "alive.md").write_text(LESSON.format(molecule=molecule, system=system))
        paths = [folder / "alive.md"]
        for name, text in files.items():
            paths.append(folder / name.replace("_", "."))
            paths[-1].write_text(text)
        self.drop(browser, *paths)
        browser.wait_for("lesson/step", "The first step")

    def workers(self, browser):
        return browser.evaluate("moltact.simulations.all.size")


class Module(SimulationTest):
    def test_its_energy_at_the_first_positions_is_that_of_the_native_platform_Reference_within_1e_6(self):
        native = subprocess.run([DESKTOP, "simulate", "run", "alanine-dipeptide", "--platform", "Reference", "--ps", "0.1"],
                                capture_output=True, text=True, env={**os.environ, "MOLTACT_HOME": str(ROOT)})
        self.assertEqual(native.returncode, 0, native.stderr)
        wanted = float(re.search(r"at the start (\S+) kcal/mol", native.stdout)[1])
        got = drive(self.page(), DIPEPTIDE, "const f = await s.ask(0, 0, 1); return [s.first, f.potential, f.ps];")
        self.assertEqual(got[0]["kind"], 1, got[0]["text"])
        name, platform = got[0]["text"].split("\n")
        self.assertRegex(name, r"^OpenMM \d")
        self.assertEqual(platform, "Reference")
        step_ps, steps_per_s, *masses = got[0]["numbers"]
        self.assertEqual(step_ps, 0.004)
        self.assertEqual(len(masses), 22)
        self.assertEqual(got[2], 0.0)
        self.assertLess(abs(got[1] - wanted), 1e-6 * abs(wanted), f"page {got[1]}, native {wanted}")
        print(f"alanine dipeptide, 22 atoms: {steps_per_s:.0f} steps per second in the page; potential energy at the start "
              f"{got[1]:.9g} kcal/mol, native {wanted:.9g}")

    def test_in_400_ps_its_mean_temperature_is_that_of_the_bath_within_four_sampling_errors_of_3_K(self):
        # The temperature of 51 degrees of freedom varies by 300 K sqrt(2 / 51); samples 1 ps apart are independent.
        mean = drive(self.page(), DIPEPTIDE, """let sum = 0, samples = 0;
            for (let next_ps = 50; samples < 400;) {
              const f = await s.ask(0.1, 1, 10);
              if (f.ps >= next_ps) { sum += f.kelvin; ++samples; next_ps = f.ps + 1; }
            }
            return sum / samples;""")
        print(f"mean temperature {mean:.1f} K")
        self.assertLess(abs(mean - 300.0), 4 * 300.0 * math.sqrt(2 / 51 / 400))

    def test_a_push_moves_its_atom_to_the_plane_of_the_spring_and_the_other_way_when_it_points_the_other_way(self):
        # The plane advances by 0.2 A a picosecond: a step of 4 A would heat the molecule until the run counts as unstable.
        moved = drive(self.page(), DIPEPTIDE, """const first = await s.ask(0, 0, 1); const out = [];
            for (const sign of [1, -1]) {
              const begun_ps = (await s.ask(0, 1, 10)).ps;
              let sum = 0, samples = 0, ps = begun_ps;
              while (ps < begun_ps + 40) {
                const x = first.at[24] + Math.min(2, 0.2 * (ps - begun_ps)) * sign;
                const f = await s.ask(0.1, 1, 10, [8, x, first.at[25], first.at[26], sign, 0, 0, 100]);
                if (f.blow_ups) throw new Error(`the run blew up at ${ps} ps, sign ${sign}`);
                ps = f.ps;
                if (ps > begun_ps + 20) { sum += f.at[24]; ++samples; }
              }
              out.push(sum / samples - first.at[24]);
            }
            return out;""")
        print(f"pushed by 2 A: moved by {moved[0]:.2f} and {moved[1]:.2f} A")
        self.assertGreater(moved[0], 1.5)
        self.assertLess(moved[1], -1.5)

    def test_a_run_that_blows_up_stands_at_its_beginning_and_goes_on_when_it_is_started_again(self):
        got = drive(self.page(), DIPEPTIDE, """const first = await s.ask(0, 0, 1);
            const grip = [8, 500, 0, 0, 0, 0, 0, 1e6];
            let f = first;
            for (let k = 0; k < 20 && !f.blow_ups; ++k) f = await s.ask(0.1, 1, 10, grip);
            return [f.blow_ups, Math.max(...f.at.map((x, k) => Math.abs(x - first.at[k]))), f.starts];""")
        self.assertEqual(got[0], 1)
        self.assertLess(got[1], 1e-3)
        self.assertEqual(got[2], 1)


class InALesson(SimulationTest):
    def test_a_lessons_molecule_moves_and_the_worker_ends_with_the_lesson(self):
        browser = self.page()
        self.assertEqual(self.workers(browser), 0)
        self.assertTrue(browser.evaluate("document.getElementById('simulation-bytes') !== null"), "unpacked too early")
        self.lesson(browser)
        browser.wait_for("simulation/time", "Simulated", seen=True)
        began = float(re.search(r"[\d.]+", browser.text("simulation/time"))[0])
        browser.frames(60)
        self.assertGreater(float(re.search(r"[\d.]+", browser.text("simulation/time"))[0]), began)
        self.picture(browser, "simulation")
        moved = browser.evaluate("""(() => { const f = [...moltact.simulations.all.values()][0].newest.numbers;
            const p = new TextDecoder().decode(moltact.FS.readFile('/moltact/molecules/alanine-dipeptide.pdb')).split('\\n')
                .filter((l) => /^(ATOM|HETATM)/.test(l)).map((l) => Number(l.slice(30, 38)));
            return Math.max(...p.map((x, k) => Math.abs(f[9 + 3 * k] - x))); })()""")
        self.assertGreater(moved, 0.1)
        self.assertLess(moved, 6.0)
        self.assertEqual(self.workers(browser), 1)
        browser.click("simulation/play")
        browser.frames(10)
        still = browser.text("simulation/time")
        browser.frames(20)
        self.assertEqual(browser.text("simulation/time"), still)
        browser.key("Escape")
        browser.click("lesson/close") if browser.text("lesson/close") is not None else browser.open(PAGE.as_uri())
        browser.until("moltact.simulations.all.size === 0")
        self.no_errors(browser)

    def test_a_worker_that_dies_ends_the_simulation_with_its_reason_and_it_can_be_switched_on_again(self):
        browser = self.page()
        self.lesson(browser)
        browser.wait_for("simulation/time", "Simulated")
        browser.evaluate("[...moltact.simulations.all.values()][0].worker.dispatchEvent("
                         "new ErrorEvent('error', {message: 'out of memory', cancelable: true}))")
        browser.wait_for("message/0", "the simulation has ended: out of memory")
        self.assertEqual(self.workers(browser), 0)
        browser.click("simulation")
        browser.frames(5)
        browser.click("simulation")
        browser.wait_for("simulation/time", "Simulated")
        self.assertEqual(self.workers(browser), 1)

    def test_a_worker_that_answers_no_more_counts_as_lost_after_10_s(self):
        browser = self.page()
        self.lesson(browser)
        browser.wait_for("simulation/time", "Simulated")
        browser.evaluate("[...moltact.simulations.all.values()][0].worker.terminate()")
        browser.wait_for("message/0", "it has not answered for 10 s")
        self.assertEqual(self.workers(browser), 0)

    def test_a_system_that_is_none_and_one_of_another_molecule_are_refused_with_the_reason(self):
        other = (ROOT / "molecules" / "alanine-dipeptide.xml").read_text()
        for molecule, text, reason in (("alanine-dipeptide", "<no system>", "OpenMM cannot simulate this system"),
                                       ("benzene", other, "22 particles, not 12"),
                                       ("1ubq", other, "a page in a browser simulates at most")):
            with self.subTest(molecule=molecule):
                browser = self.page()
                self.lesson(browser, molecule, "own.xml", own_xml=text)
                browser.wait_for("message/0", reason)
                self.assertEqual(self.workers(browser), 0)
                self.no_errors(browser)
                browser.close()
