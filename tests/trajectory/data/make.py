"""Makes waters.xtc with MDTraj: 300 atoms of 100 water molecules on a lattice, in three frames, by the formula that
trajectory_file_test.cpp computes again. Triples of near atoms are what the format packs as runs.
"""
import numpy as np
import mdtraj

xyz = np.zeros((3, 300, 3))
for f in range(3):
    for i in range(300):
        m, k = divmod(i, 3)
        xyz[f, i] = [
            0.31 * (m % 5) + 0.08 * k + 0.01 * f,
            0.31 * (m // 5 % 5) - 0.05 * k - 0.37,
            0.31 * (m // 25) + 0.02 * k + 0.1 * f,
        ]
with mdtraj.formats.XTCTrajectoryFile("waters.xtc", "w", force_overwrite=True) as out:
    out.write(xyz.astype(np.float32), time=np.arange(3, dtype=np.float32) * 5, step=np.arange(3) * 100,
              box=np.repeat(np.eye(3, dtype=np.float32)[None] * 2.5, 3, 0))
