"""Writes trajectories with MDTraj into the folder of the first argument, and beside each what MDTraj reads from it:
NAME.f32 holds float32 of this machine: positions in nm or A as in the file, frame by frame.
"""
import sys

import mdtraj
import numpy as np

folder = sys.argv[1]
random = np.random.default_rng(7)
frames, atoms = 5, 500
# A random walk, of which XTC packs some steps as differences and others not.
walk = np.cumsum(random.normal(0, 0.08, (atoms, 3)), axis=0)
walk[::50] += random.uniform(-9, 9, (len(walk[::50]), 3))
xyz = (walk[None] + random.normal(0, 0.02, (frames, atoms, 3))).astype(np.float32)
far = xyz.copy()
far[:, 0] += 20000.0  # so far out that each coordinate has bits of its own
time = (np.arange(frames) * 2.5).astype(np.float32)
box = np.repeat((np.eye(3, dtype=np.float32) * 6)[None], frames, 0)
box[:, 1, 0] = 1.5


def keep(name, positions):
    np.ascontiguousarray(positions, dtype=np.float32).tofile(f"{folder}/{name}.f32")


for name, places in (("walk.xtc", xyz), ("far.xtc", far), ("few.xtc", xyz[:, :7])):
    with mdtraj.formats.XTCTrajectoryFile(f"{folder}/{name}", "w") as out:
        out.write(np.ascontiguousarray(places), time=time, step=np.arange(frames), box=box)
    with mdtraj.formats.XTCTrajectoryFile(f"{folder}/{name}") as back:
        keep(name, back.read()[0])
with mdtraj.formats.TRRTrajectoryFile(f"{folder}/walk.trr", "w") as out:
    out.write(xyz, time=time, step=np.arange(frames), box=box, lambd=np.zeros(frames, dtype=np.float32))
keep("walk.trr", xyz)
lengths = np.tile(np.float32([60, 50, 40]), (frames, 1))
angles = np.tile(np.float32([90, 80, 70]), (frames, 1))
with mdtraj.formats.DCDTrajectoryFile(f"{folder}/walk.dcd", "w") as out:
    out.write(xyz * 10, cell_lengths=lengths, cell_angles=angles)
keep("walk.dcd", xyz * 10)
with mdtraj.formats.NetCDFTrajectoryFile(f"{folder}/walk.nc", "w") as out:
    out.write(xyz * 10, time=time, cell_lengths=lengths, cell_angles=angles)
keep("walk.nc", xyz * 10)
