"""Makes a system for OpenMM from a molecule: moltact simulate prepare runs this with a Python that has OpenMM.

prepare.py MOLECULE OUT.xml OUT.pdb SOLVENT

OUT.xml is the serialised System, OUT.pdb the molecule with the hydrogens and the atoms' order of the system. SOLVENT:
"none" (force field amber14) or "obc" (amber99sb-ildn with the implicit solvent of Onufriev, Bashford and Case, whose
GBSAOBCForce is fast enough for about 100 atoms). Hydrogens bear 4 u, taken from the atoms that hold them, and their
bonds are rigid, so that a step takes 4 fs. Prints one line of JSON: what was made, or what is wrong ("fault").
"""
import json
import sys

import numpy as np
import openmm
from openmm import app, unit

NO_CUTOFF_BELOW = 150  # atoms; above, OpenMM's CPU platform is several times faster with a cut-off
CUTOFF_NM = 1.2
HYDROGEN_U = 4.0
MINIMISER_STEPS = 500


def with_ends(topology, positions):
    """Adds the second oxygen of the last residue where a chain was cut, so that the force field knows it as an end."""
    out, places, copies = app.Topology(), [], {}
    for chain in topology.chains():
        new_chain = out.addChain(chain.id)
        residues = list(chain.residues())
        for residue in residues:
            new = out.addResidue(residue.name, new_chain, residue.id, residue.insertionCode)
            atoms = {}
            for atom in residue.atoms():
                copies[atom] = atoms[atom.name] = out.addAtom(atom.name, atom.element, new)
                places.append(positions[atom.index].value_in_unit(unit.nanometer))
            if residue is not residues[-1] or "OXT" in atoms or not {"N", "CA", "C", "O"} <= set(atoms):
                continue
            ca, c, o = (np.array(places[atoms[name].index]) for name in ("CA", "C", "O"))
            away = (c - ca) / np.linalg.norm(c - ca) + (c - o) / np.linalg.norm(c - o)
            end = out.addAtom("OXT", app.Element.getBySymbol("O"), new)
            places.append(openmm.Vec3(*(c + 0.125 * away / np.linalg.norm(away))))
            copies[end] = end
            out.addBond(atoms["C"], end)
    for bond in topology.bonds():
        out.addBond(copies[bond[0]], copies[bond[1]])
    return out, places * unit.nanometer


def main(molecule, out_xml, out_pdb, solvent):
    try:
        read = app.PDBxFile if molecule.lower().endswith((".cif", ".mmcif")) else app.PDBFile
        file = read(molecule)
    except Exception as e:
        return {"fault": f"OpenMM cannot read {molecule}: {e}"}
    if solvent == "obc":
        field = app.ForceField("amber99sbildn.xml", "amber99_obc.xml")
    else:
        field = app.ForceField("amber14-all.xml")
    try:
        model = app.Modeller(file.topology, file.positions)
        model.deleteWater()
        model = app.Modeller(*with_ends(model.topology, model.positions))
        model.addHydrogens(field, pH=7.0)
        count = model.topology.getNumAtoms()
        small = count < NO_CUTOFF_BELOW
        system = field.createSystem(
            model.topology,
            nonbondedMethod=app.NoCutoff if small else app.CutoffNonPeriodic,
            nonbondedCutoff=CUTOFF_NM * unit.nanometer,
            constraints=app.HBonds,
            hydrogenMass=HYDROGEN_U * unit.dalton,
            removeCMMotion=False,
        )
    except Exception as e:
        return {"fault": f"the force field does not fit: {e}"}
    names = [openmm.Platform.getPlatform(k).getName() for k in range(openmm.Platform.getNumPlatforms())]
    platform = "CPU" if not small and "CPU" in names else "Reference"
    context = openmm.Context(
        system, openmm.VerletIntegrator(0.001), openmm.Platform.getPlatformByName(platform)
    )
    context.setPositions(model.positions)
    openmm.LocalEnergyMinimizer.minimize(context, 1.0, MINIMISER_STEPS)
    state = context.getState(getPositions=True, getEnergy=True)
    with open(out_xml, "w") as f:
        f.write(openmm.XmlSerializer.serialize(system))
    with open(out_pdb, "w") as f:
        app.PDBFile.writeFile(model.topology, state.getPositions(), f, keepIds=True)
    energy = state.getPotentialEnergy().value_in_unit(unit.kilocalorie_per_mole)
    return {"atoms": count, "energy_kcal_mol": energy, "openmm": openmm.Platform.getOpenMMVersion()}


print(json.dumps(main(*sys.argv[1:5])))
