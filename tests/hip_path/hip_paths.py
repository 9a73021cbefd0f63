"""A hand over ubiquitin: the contacts of another system's build held against the desktop's."""
import os
import pathlib
import random
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DESKTOP = pathlib.Path(os.environ.get("MOLTACT_DESKTOP", ROOT / "build" / "release" / "moltact"))
METHODS = ("exact", "paper")
MOST_A = 1e-9


def hand(lot):
    """In from outside, then wandering just under the surface; angstrom."""
    path = [(30.4 + 30 * (1 - k / 1000), 29.0, 15.9) for k in range(700)]
    place = list(path[-1])
    for _ in range(3000):
        place = [c + lot.gauss(0, 0.03) - 0.002 * (c - m) for c, m in zip(place, (30.4, 29.0, 15.9))]
        path.append(tuple(place))
    return path


def hold_against_the_desktop(test, program):
    """`program`: the command of moltact_hip_path there."""
    seed = random.randrange(1 << 30)
    print(f"seed {seed}")
    path = hand(random.Random(seed))
    with tempfile.TemporaryDirectory() as folder:
        hips, table, contacts = (pathlib.Path(folder) / n for n in ("hip.txt", "hip.csv", "contacts.csv"))
        hips.write_text("".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in path))
        table.write_text("x,y,z\n" + "".join(f"{x!r},{y!r},{z!r}\n" for x, y, z in path))
        molecule = ROOT / "molecules" / "1ubq.pdb"
        for method in METHODS:
            subprocess.run([DESKTOP, "replay", molecule, "--path", table, "--out", contacts, "--method", method], check=True,
                           capture_output=True)
            desktop = [row.split(",") for row in contacts.read_text().splitlines()[1:]]
            out = subprocess.run([*program, molecule, hips, method], check=True, capture_output=True, text=True).stdout
            there = [row.split() for row in out.splitlines()]
            test.assertEqual(len(there), len(desktop))
            touching, most = 0, 0.0
            for ours, theirs in zip(there, desktop):
                test.assertEqual(ours[0], theirs[4])
                test.assertEqual(ours[7:10], theirs[12:15])
                touching += ours[0] == "1"
                most = max(most, *(abs(float(a) - float(b)) for a, b in zip(ours[1:7], theirs[5:11])))
            test.assertGreater(touching, 500)
            test.assertLessEqual(most, MOST_A)
            print(f"{method}: {touching} ticks in contact, farthest apart {most:.2g} A")
