"""The two grooves of DNA by touch, and how large a visitor may be that reaches their floors.

Run it whole (feel_a_groove.py [--save FILE.png]), or cell by cell in an editor that knows "# %%".
"""

# %% Load a molecule. A name of Moltact's library or a file; its axis is z.
import sys

import moltact
import numpy as np

dna = moltact.load("b-dna")
print(f"{dna.title}: {len(dna)} atoms, {np.ptp(dna.positions[:, 2]):.0f} A long")

# %% Press the probe against the middle of the helix from all around, and keep where it is stopped.
angles = np.radians(np.arange(0.0, 360.0, 1.0))
radii_A = np.linspace(22.0, 2.0, 201)
rays = np.stack([np.cos(angles), np.sin(angles), np.zeros_like(angles)], axis=1)
hand = (rays[:, None, :] * radii_A[None, :, None]).reshape(-1, 3)


def profile(probe_A):
    """Distance from the axis, in A, at which the probe is first stopped at each angle."""
    felt = moltact.Tracker(dna, probe_A=probe_A).feel(hand)
    touching = felt.touching.reshape(len(angles), -1)
    return radii_A[touching.argmax(axis=1)]


def depths(probe_A):
    """How far the probe sinks below the ridges in the minor and in the major groove, in A."""
    stopped_A = profile(probe_A)
    # At this height one groove opens toward +x and the other toward -x; the minor one is the shallower.
    sides = [stopped_A[np.cos(angles) > 0.5], stopped_A[np.cos(angles) < -0.5]]
    return sorted(stopped_A.max() - side.min() for side in sides)


# %% How deep do probes of several sizes come?
probes_A = np.arange(1.0, 6.1, 0.5)
minor_A, major_A = np.array([depths(probe) for probe in probes_A]).T

# %% Draw it.
save = sys.argv[sys.argv.index("--save") + 1] if "--save" in sys.argv else "feel_a_groove.png"
if save:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure = plt.figure(figsize=(10, 4.5))
    around = figure.add_subplot(1, 2, 1, projection="polar")
    for probe in (1.4, 3.0):
        around.plot(angles, profile(probe), label=f"probe of {probe} A")
    around.set_title("Where the probe is stopped (A from the axis)")
    around.legend(loc="upper left", bbox_to_anchor=(-0.3, 0.0))
    beside = figure.add_subplot(1, 2, 2)
    beside.plot(probes_A, major_A, "o-", label="major groove")
    beside.plot(probes_A, minor_A, "s-", label="minor groove")
    beside.set_xlabel("radius of the probe (A)")
    beside.set_ylabel("depth below the ridges (A)")
    beside.legend()
    figure.tight_layout()
    figure.savefig(save, dpi=120)
    print(f"drawn in {save}")

# %% A probe of 3 A comes so deep:
minor, major = depths(3.0)
print(f"minor groove: {minor:.1f} A")
print(f"major groove: {major:.1f} A")
