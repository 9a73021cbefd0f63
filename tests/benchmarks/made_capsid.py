#!/usr/bin/env python3
"""Writes a made-up virus capsid as mmCIF: three chains of LEU in a lump, and operators that copy it over a sphere.

    tests/benchmarks/made_capsid.py >capsid.cif     # 9696 atoms; 16 289 280 with --assembly 1
    tests/benchmarks/made_capsid.py --residues 40 --copies 60 >small.cif

The lump is as dense as a protein. Nothing is random: the same numbers give the same file.
"""
import argparse
import math

# A leucine round its C alpha (unit: angstrom).
LEUCINE = [("N", -1.20, 0.70, 0.30), ("CA", 0.00, 0.00, 0.00), ("C", 1.20, 0.80, -0.40), ("O", 1.30, 2.00, -0.30),
           ("CB", 0.10, -0.90, 1.20), ("CG", 0.30, -2.30, 0.80), ("CD1", 1.60, -2.60, 0.10), ("CD2", -0.80, -2.90, -0.10)]
GRID_A = 5.2  # between C alphas: 140 cubic angstroms a residue


def lump(residues):
    """The C alphas nearest to the middle of a grid, in three sectors."""
    reach = 2 + round((residues / 2) ** (1 / 3) * 1.2)
    grid = [(x, y, z) for x in range(-reach, reach + 1) for y in range(-reach, reach + 1) for z in range(-reach, reach + 1)]
    grid.sort(key=lambda p: (p[0] ** 2 + p[1] ** 2 + p[2] ** 2, p))
    chosen = sorted(grid[:residues], key=lambda p: math.atan2(p[1] + 0.3, p[0] + 0.1))
    third = residues // 3
    return [chosen[:third], chosen[third:2 * third], chosen[2 * third:]]


def turned(place, by):
    """About z, then about x, by so many radians."""
    x, y, z = place
    x, y = x * math.cos(by) - y * math.sin(by), x * math.sin(by) + y * math.cos(by)
    return x, y * math.cos(by) - z * math.sin(by), y * math.sin(by) + z * math.cos(by)


def operator(k, copies, radius):
    """Turns the z axis to the k-th of so many places spread evenly over a sphere, and goes there."""
    z = 1 - (2 * k + 1) / copies
    ring, turn = math.sqrt(1 - z * z), k * math.pi * (3 - math.sqrt(5))
    out = (ring * math.cos(turn), ring * math.sin(turn), z)
    east = (-math.sin(turn), math.cos(turn), 0.0)
    north = (out[1] * east[2] - out[2] * east[1], out[2] * east[0] - out[0] * east[2], out[0] * east[1] - out[1] * east[0])
    return [(east[i], north[i], out[i]) for i in range(3)], [radius * c for c in out]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--residues", type=int, default=1212, help="of the three chains together, 8 atoms each")
    parser.add_argument("--copies", type=int, default=1680)
    args = parser.parse_args()
    print("data_CAPSID\nloop_")
    for key in ("group_PDB", "type_symbol", "label_atom_id", "label_comp_id", "label_asym_id", "auth_seq_id", "Cartn_x",
                "Cartn_y", "Cartn_z", "occupancy"):
        print("_atom_site." + key)
    for chain, places in zip("ABC", lump(args.residues)):
        for number, place in enumerate(places, 1):
            for name, *atom in LEUCINE:
                at = [GRID_A * p + a for p, a in zip(place, turned(atom, 0.9 * number))]
                print(f"ATOM {name[0]} {name} LEU {chain} {number} {at[0]:.3f} {at[1]:.3f} {at[2]:.3f} 1.0")
    print("loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression")
    print(f"_pdbx_struct_assembly_gen.asym_id_list\n1 '(1-{args.copies})' A,B,C\nloop_\n_pdbx_struct_oper_list.id")
    for i in (1, 2, 3):
        for j in (1, 2, 3):
            print(f"_pdbx_struct_oper_list.matrix[{i}][{j}]")
    for i in (1, 2, 3):
        print(f"_pdbx_struct_oper_list.vector[{i}]")
    lump_A = GRID_A * (3 * args.residues / (4 * math.pi)) ** (1 / 3)
    radius = lump_A * math.sqrt(args.copies / 4) * 1.08  # a disc of the lump's size for each copy
    for k in range(args.copies):
        turn, shift = operator(k, args.copies, radius)
        print(k + 1, *(f"{v:.9f}" for row in turn for v in row), *(f"{v:.3f}" for v in shift))


main()
