"""A hand over ubiquitin and a key in its lock: what another system's build feels held against the desktop's."""
import math
import os
import pathlib
import random
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
DESKTOP = pathlib.Path(os.environ.get("MOLTACT_DESKTOP", ROOT / "build" / "release" / "moltact"))
METHODS = ("exact", "paper")
MOST_A = 1e-9
# A body's rest is found to 1e-9 A; the libraries' sines and roots differ in the last bit, which a shallow rest enlarges.
MOST_OF_BODY_A = 1e-6
KEY_ATOMS = ("255", "262")
KEY_MIDDLE = (0.0, -1.125, -0.225)


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
    hold_body_against_the_desktop(test, program, random.Random(seed))


def key_hand(lot):
    """Into the lock, 5 to 12 degrees askew, and back out, three times; angstrom and a quaternion."""
    path = []
    for _ in range(3):
        axis = [lot.gauss(0, 1) for _ in range(3)]
        length = math.hypot(*axis)
        half = math.radians(lot.uniform(5, 12)) / 2
        turn = (math.cos(half), *(math.sin(half) * a / length for a in axis))
        aside = (lot.uniform(-0.5, 0.5), lot.uniform(-0.5, 0.5))
        depths = [12 - 13 * k / 1000 for k in range(1000)]
        for z in depths + depths[::-1]:
            path.append((KEY_MIDDLE[0] + aside[0], KEY_MIDDLE[1] + aside[1], KEY_MIDDLE[2] + z, *turn))
    return path


def hold_body_against_the_desktop(test, program, lot):
    path = key_hand(lot)
    with tempfile.TemporaryDirectory() as folder:
        hips, table, poses = (pathlib.Path(folder) / n for n in ("hip.txt", "hip.csv", "poses.csv"))
        hips.write_text("".join(" ".join(map(repr, p)) + "\n" for p in path))
        table.write_text("x,y,z,qw,qx,qy,qz\n" + "".join(",".join(map(repr, p)) + "\n" for p in path))
        molecule = ROOT / "molecules" / "key-and-lock.pdb"
        subprocess.run([DESKTOP, "replay", molecule, "--in-hand", "chain B", "--path", table, "--out", poses], check=True,
                       capture_output=True)
        rows = [row.split(",") for row in poses.read_text().splitlines()]
        columns = [rows[0].index(name) for name in ("body_x", "body_y", "body_z", "body_qw", "body_qx", "body_qy", "body_qz")]
        out = subprocess.run([*program, molecule, hips, "exact-body", *KEY_ATOMS], check=True, capture_output=True,
                             text=True).stdout
        there = [row.split() for row in out.splitlines()]
        test.assertEqual(len(there), len(rows) - 1)
        most = 0.0
        for ours, theirs in zip(there, rows[1:]):
            most = max(most, *(abs(float(a) - float(theirs[c])) for a, c in zip(ours[1:8], columns)))
        touching = sum(row[0] == "1" for row in there)
        print(f"exact-body: {touching} ticks in contact, farthest apart {most:.2g} A")
        test.assertGreater(touching, 100)  # at least 318 for the seeds 0 to 399
        test.assertLessEqual(most, MOST_OF_BODY_A)
