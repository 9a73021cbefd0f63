"""Feel molecules: Moltact's haptic methods over numpy arrays.

    import moltact, numpy
    molecule = moltact.load("1ubq")
    probe = moltact.Tracker(molecule)
    felt = probe.feel(numpy.linspace([60, 29, 16], [30, 29, 16], 1000))
    print(felt.forces[felt.touching])

Positions are in angstroms, in the coordinates of the molecule's file; forces in newtons, with a spring of 1 N per
angstrom. __init__.pyi has the types.
"""

from ._moltact import (
    Chemistry,
    Felt,
    HeldBody,
    Molecule,
    MoleculeError,
    Tracker,
    __version__,
    interactions,
    load,
    methods,
    radius_tables,
)

__all__ = [
    "Chemistry",
    "Felt",
    "HeldBody",
    "Molecule",
    "MoleculeError",
    "Tracker",
    "interactions",
    "load",
    "methods",
    "radius_tables",
]

MoleculeError.__doc__ = "A molecule that cannot be read: where, why, and what helps."
for _public in (Chemistry, Felt, HeldBody, Molecule, MoleculeError, Tracker):
    _public.__module__ = __name__
del _public
