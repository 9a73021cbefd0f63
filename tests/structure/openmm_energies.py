# Energies between two sets of atoms by OpenMM's Reference platform, in kcal/mol. Standard input: one atom a line, its set
# (0 or 1), x, y, z (A), half of its distance of lowest energy (A), depth (kcal/mol), charge (e). Output: without a
# cut-off Coulomb in vacuum by NonbondedForce, as E(both) - E(0) - E(1), and Lennard-Jones by CustomNonbondedForce (its
# energies within a set are too large to be subtracted); then, switched off from 8 to 10 A, Coulomb with the dielectrics 1,
# 4 r and Mehler and Solmajer's, and Lennard-Jones.
import sys

try:
    import openmm
except ImportError:
    from simtk import openmm

KCAL = 4.184
rows = [[float(word) for word in line.split()] for line in sys.stdin]


def energy(force, chosen):
    system = openmm.System()
    for _ in chosen:
        system.addParticle(1.0)
    system.addForce(force)
    context = openmm.Context(system, openmm.VerletIntegrator(0.001), openmm.Platform.getPlatformByName("Reference"))
    context.setPositions([openmm.Vec3(0.1 * r[1], 0.1 * r[2], 0.1 * r[3]) for r in chosen])
    return context.getState(getEnergy=True).getPotentialEnergy()._value / KCAL


def coulomb():
    out = []
    for chosen in (rows, [r for r in rows if r[0] == 0], [r for r in rows if r[0] == 1]):
        force = openmm.NonbondedForce()
        force.setNonbondedMethod(openmm.NonbondedForce.NoCutoff)
        for r in chosen:
            force.addParticle(r[6], 0.1, 0.0)
        out.append(energy(force, chosen))
    return out[0] - out[1] - out[2]


def between(expression, cut):
    force = openmm.CustomNonbondedForce(expression)
    for name in ("h", "d", "q"):
        force.addPerParticleParameter(name)
    force.setNonbondedMethod(force.CutoffNonPeriodic if cut else force.NoCutoff)
    force.setCutoffDistance(1.0)
    for r in rows:
        force.addParticle([r[4], r[5], r[6]])
    force.addInteractionGroup([i for i, r in enumerate(rows) if r[0] == 0], [i for i, r in enumerate(rows) if r[0] == 1])
    return energy(force, rows)


def switched(pair):
    return between("u*u*(3-2*u)*(%s)*4.184; u=min(1,max(0,(100-a*a)/36)); R=h1+h2; D=sqrt(d1*d2); a=10*r" % pair, True)


lennard_jones = between("4*sqrt(d1*d2)*4.184*((s/r)^12-(s/r)^6); s=0.1*(h1+h2)/2^(1/6)", False)
print(coulomb(), lennard_jones, switched("332.0637*q1*q2/a"), switched("332.0637*q1*q2/(4*a*a)"),
      switched("332.0637*q1*q2/(a*(86.9525/(1+7.7839*exp(-0.003627*86.9525*a))-8.5525))"),
      switched("D*((R/a)^12-2*(R/a)^6)"))
