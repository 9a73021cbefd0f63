"""Writes an OpenMM system without a cut-off as input of LAMMPS, for comparison of their energies.

    python3 lammps_of_openmm.py SYSTEM.xml POSITIONS FOLDER

POSITIONS has a line with x, y and z in angstrom for each atom.
Only the standard library; LAMMPS: units real, pair lj/cut/coul/cut, bond and angle harmonic, dihedral charmm.
"""
import math
import sys
import xml.etree.ElementTree as tree

KCAL = 4.184
system, positions, folder = sys.argv[1:]
root = tree.parse(system).getroot()
at = [tuple(float(x) for x in line.split()) for line in open(positions)]
force = {f.get("type"): f for f in root.find("Forces")}
masses = [float(p.get("mass")) for p in root.find("Particles")]
atoms = [(float(p.get("q")), 10 * float(p.get("sig")), float(p.get("eps")) / KCAL)
         for p in force["NonbondedForce"].find("Particles")]
assert force["NonbondedForce"].get("method") == "0" and len(at) == len(atoms) == len(masses)


def pairs(element):
    return [(int(x.get("p1")), int(x.get("p2")), x) for x in element]


# A rigid bond has no energy, but its atoms are bonded.
bonds = [(i, j, 10 * float(x.get("d")), 0.5 * float(x.get("k")) / KCAL / 100)
         for i, j, x in pairs(force["HarmonicBondForce"].find("Bonds"))]
bonded = {frozenset(b[:2]) for b in bonds}
bonds += [(i, j, 10 * float(x.get("d")), 0.0) for i, j, x in pairs(root.find("Constraints"))
          if frozenset((i, j)) not in bonded]
angles = [(int(x.get("p1")), int(x.get("p2")), int(x.get("p3")), math.degrees(float(x.get("a"))),
           0.5 * float(x.get("k")) / KCAL) for x in force["HarmonicAngleForce"].find("Angles")]
turns = [(*(int(x.get("p%d" % k)) for k in (1, 2, 3, 4)), float(x.get("k")) / KCAL, int(x.get("periodicity")),
          round(math.degrees(float(x.get("phase"))))) for x in force["PeriodicTorsionForce"].find("Torsions")]
# The pairs with a term of their own: none up to the third atom, weaker between the first and the fourth.
for i, j, x in pairs(force["NonbondedForce"].find("Exceptions")):
    a, b = atoms[i], atoms[j]
    q, eps = float(x.get("q")), float(x.get("eps")) / KCAL
    assert q == eps == 0.0 or (abs(q - a[0] * b[0] / 1.2) < 1e-4 and abs(eps - 0.5 * math.sqrt(a[2] * b[2])) < 1e-6)

with open(folder + "/system.data", "w") as out:
    counts = [("atoms", at), ("bonds", bonds), ("angles", angles), ("dihedrals", turns)]
    out.write("system\n\n" + "".join("%d %s\n" % (len(x), n) for n, x in counts))
    out.write("%d atom types\n%d bond types\n%d angle types\n%d dihedral types\n" %
              (len(at), len(bonds), len(angles), len(turns)))
    out.write("".join("-200 200 %slo %shi\n" % (x, x) for x in "xyz"))
    out.write("\nMasses\n\n" + "".join("%d %.8g\n" % (k + 1, m) for k, m in enumerate(masses)))
    out.write("\nAtoms\n\n" + "".join("%d 1 %d %.10g %.10g %.10g %.10g\n" % (k + 1, k + 1, atoms[k][0], *at[k])
                                      for k in range(len(at))))
    for title, list_of, ends in (("Bonds", bonds, 2), ("Angles", angles, 3), ("Dihedrals", turns, 4)):
        out.write("\n%s\n\n" % title)
        for k, x in enumerate(list_of):
            out.write("%d %d %s\n" % (k + 1, k + 1, " ".join(str(i + 1) for i in x[:ends])))
with open(folder + "/in.system", "w") as out:
    out.write("units real\natom_style full\nboundary f f f\npair_style lj/cut/coul/cut 100.0\n"
              "bond_style harmonic\nangle_style harmonic\ndihedral_style charmm\n"
              "special_bonds lj 0 0 0.5 coul 0 0 0.8333333333333333\npair_modify mix arithmetic\n"
              "read_data system.data\n")
    out.write("".join("pair_coeff %d %d %.10g %.10g\n" % (k + 1, k + 1, a[2], a[1]) for k, a in enumerate(atoms)))
    out.write("".join("bond_coeff %d %.10g %.10g\n" % (k + 1, b[3], b[2]) for k, b in enumerate(bonds)))
    out.write("".join("angle_coeff %d %.10g %.10g\n" % (k + 1, a[4], a[3]) for k, a in enumerate(angles)))
    out.write("".join("dihedral_coeff %d %.10g %d %d 0.0\n" % (k + 1, *t[4:]) for k, t in enumerate(turns)))
    out.write("thermo_style custom step pe\nthermo_modify format float %.8f\nrun 0\n"
              "variable energy equal pe\nprint \"energy ${energy}\"\n")
