"""Drives a simulation of the page as engine/dynamics/begin_simulation_web.cpp does. The rows of numbers are those of
engine/dynamics/simulation_message.cpp. Alone it measures: python3 tests/web/simulation_driver.py FILE.pdb ..., with the system
of each in FILE.xml beside it, prints the steps per second that each makes in the page."""
import json
import pathlib
import sys

from browser import Browser
from page import PAGE

DRIVE = """
async function drive(pdb, system, hold_kcal_mol_A2) {
  const at = pdb.split("\\n").filter((l) => /^(ATOM|HETATM)/.test(l))
      .flatMap((l) => [30, 38, 46].map((k) => Number(l.slice(k, k + 8))));
  const all = moltact.simulations;
  const number = all.open(system, Float64Array.from([300, 2, hold_kcal_mol_A2, 1, 0, ...at]));
  const next = async () => {
    for (const until = performance.now() + 60000; performance.now() < until;) {
      const kind = all.news(number);
      if (kind) return {kind, text: all.text(number), numbers: Array.from(all.numbers(number))};
      await new Promise((done) => setTimeout(done, 1));
    }
    throw new Error("no answer in 60 s");
  };
  const ask = async (elapsed_s, running, ps_per_s, pushes = []) => {
    all.ask(number, Float64Array.from([elapsed_s, running, ps_per_s, 300, 0, 0, 0, ...pushes]));
    const n = (await next()).numbers;
    return {ps: n[1], potential: n[2], kelvin: n[4], starts: n[6], blow_ups: n[7], at: n.slice(9)};
  };
  return {first: await next(), ask, end: () => all.close(number)};
}
"""


def drive(browser, molecule, body):
    """What the body of an async function says that has `s`, a simulation of the molecule in this file, held by its centre."""
    molecule = pathlib.Path(molecule)
    texts = [molecule.read_text(), molecule.with_suffix(".xml").read_text()]
    return json.loads(browser.evaluate(
        f"(async () => {{ {DRIVE} const s = await drive({json.dumps(texts[0])}, {json.dumps(texts[1])}, 5);"
        f"const out = await (async () => {{ {body} }})(); s.end(); return JSON.stringify(out); }})()", patience_s=300))


if __name__ == "__main__":
    browser = Browser()
    try:
        browser.open(PAGE.as_uri())
        for file in sys.argv[1:]:
            atoms, step_ps, made_ps, took_s = drive(browser, file, """
                await s.ask(0.1, 1, 1);
                const begun = performance.now(), from = (await s.ask(0.1, 1, 10)).ps;
                let f = null;
                while (performance.now() - begun < 5000) f = await s.ask(0.1, 1, 1000);
                return [f.at.length / 3, s.first.numbers[0], f.ps - from, (performance.now() - begun) / 1000];""")
            print(f"{pathlib.Path(file).stem}: {atoms:.0f} atoms, {made_ps / step_ps / took_s:.0f} steps of {1000 * step_ps:g} fs "
                  "per second", flush=True)
    finally:
        browser.close()
