import os
from typing import Sequence, Union

import numpy as np
import numpy.typing as npt

__version__: str
__all__ = ["Chemistry", "Felt", "HeldBody", "Molecule", "MoleculeError", "Tracker", "interactions", "load", "methods"]

class MoleculeError(ValueError):
    """A molecule that cannot be read: where, why, and what helps."""

class Chemistry:
    """Element, type and charge of a scene's atoms, for forces beyond contact; immutable."""

    def __init__(
        self,
        atomic_numbers: npt.ArrayLike,
        *,
        types: Union[Sequence[str], None] = None,
        charges_e: Union[npt.ArrayLike, None] = None,
    ) -> None: ...
    def __len__(self) -> int: ...
    @property
    def atomic_numbers(self) -> npt.NDArray[np.uint8]: ...
    @property
    def types(self) -> list[str]: ...
    @property
    def charges_e(self) -> Union[npt.NDArray[np.float32], None]: ...

class Molecule:
    """The atoms of a file. Made by load(); immutable."""

    def __len__(self) -> int: ...
    def chemistry(self, charges: str = "none") -> Chemistry: ...
    def describe(self, atom: int) -> str: ...
    @property
    def id(self) -> str: ...
    @property
    def title(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def spheres(self) -> npt.NDArray[np.float64]: ...
    @property
    def positions(self) -> npt.NDArray[np.float64]: ...
    @property
    def radii(self) -> npt.NDArray[np.float64]: ...
    @property
    def atomic_numbers(self) -> npt.NDArray[np.uint8]: ...
    @property
    def elements(self) -> list[str]: ...
    @property
    def names(self) -> list[str]: ...
    @property
    def residues(self) -> list[str]: ...
    @property
    def residue_numbers(self) -> npt.NDArray[np.int32]: ...

class Felt:
    """What a hand feels at n poses; one row for each. Made by feel()."""

    def __len__(self) -> int: ...
    @property
    def positions(self) -> npt.NDArray[np.float64]: ...
    @property
    def orientations(self) -> npt.NDArray[np.float64]: ...
    @property
    def forces(self) -> npt.NDArray[np.float64]: ...
    @property
    def torques(self) -> npt.NDArray[np.float64]: ...
    @property
    def energies(self) -> npt.NDArray[np.float64]: ...
    @property
    def van_der_waals(self) -> npt.NDArray[np.float64]: ...
    @property
    def electrostatic(self) -> npt.NDArray[np.float64]: ...
    @property
    def touching(self) -> npt.NDArray[np.bool_]: ...
    @property
    def contacts(self) -> npt.NDArray[np.int32]: ...
    @property
    def at_rest(self) -> npt.NDArray[np.bool_]: ...
    @property
    def started_inside(self) -> npt.NDArray[np.bool_]: ...

class _Feeler:
    """What Tracker and HeldBody have in common."""

    def feel(self, poses: npt.ArrayLike) -> Felt: ...
    def reset(self) -> None: ...
    @property
    def method(self) -> str: ...
    @property
    def interaction(self) -> str: ...
    @property
    def stiffness_N_per_A(self) -> float: ...

class Tracker(_Feeler):
    """A spherical probe at the hand."""

    def __init__(
        self,
        scene: Union[Molecule, npt.ArrayLike],
        method: str = "exact",
        probe_A: float = 1.4,
        *,
        interaction: str = "",
        stiffness_N_per_A: float = 1.0,
        untouchable: Union[Sequence[int], npt.NDArray[np.integer]] = (),
        chemistry: Union[Chemistry, None] = None,
        forces: str = "none",
        dielectric: str = "water",
        probe_charge_e: float = 0.0,
        coupling_N_per_mm: float = 0.0,
    ) -> None: ...
    @property
    def probe_A(self) -> float: ...

class HeldBody(_Feeler):
    """A rigid body in the hand."""

    def __init__(
        self,
        scene: Union[Molecule, npt.ArrayLike],
        atoms: Union[Sequence[int], npt.NDArray[np.integer], None] = None,
        *,
        spheres: Union[npt.ArrayLike, None] = None,
        method: str = "exact",
        interaction: str = "",
        stiffness_N_per_A: float = 1.0,
        rotational_stiffness_N_A: float = 0.0,
        chemistry: Union[Chemistry, None] = None,
        forces: str = "none",
        dielectric: str = "water",
        coupling_N_per_mm: float = 0.0,
    ) -> None: ...
    @property
    def middle(self) -> npt.NDArray[np.float64]: ...
    @property
    def spheres(self) -> npt.NDArray[np.float64]: ...

def load(
    file: Union[str, os.PathLike[str]],
    *,
    model: int = 1,
    waters: bool = False,
    assembly: str = "",
    beside: str = "",
    radii: str = "bondi",
) -> Molecule: ...
def radius_tables() -> list[str]: ...
def methods() -> list[str]: ...
def interactions(body: bool = True) -> list[str]: ...
