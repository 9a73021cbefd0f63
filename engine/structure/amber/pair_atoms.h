// The parameters of a molecule's atoms for Lennard-Jones and Coulomb energies (engine/haptics/field/pair_sum.h): of
// proteins and nucleic acids from AMBER's templates, of ligands by element and hybridisation with Gasteiger's charges. Hydrogens of the file are used. Where the
// file has none, those on carbon are merged with it and those on nitrogen, oxygen and sulphur are placed by the geometry
// of their bonds. Window's thread; any thread except the haptic one. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/haptics/field/pair_model.h"
#include "engine/molecule/molecule.h"

namespace moltact {

struct PairAtoms {
  std::vector<PairAtom> atoms;         ///< those of the molecule in its order, then placed hydrogens
  std::vector<std::uint32_t> carrier;  ///< of each, the molecule's atom: itself, or the one that carries the hydrogen
  double net_charge_e = 0.0;
  std::size_t placed_hydrogens = 0;
  /// What was assumed or could not be assigned, untranslated parts for `info`: "HIS 69 A: HID". One entry per residue.
  struct Note {
    enum class Kind : std::uint8_t {
      Histidine,  ///< `template_name` was chosen, by the nearest acceptor
      Ion,        ///< its formal charge: alkali metals 1, alkaline earths, zinc and cadmium 2, halides -1
      Terminus,   ///< a charged end of a chain
      Ligand,  ///< GAFF's parameters and Gasteiger's charges, with the net charge `charge_e`; states as in valences.h
      NoTemplate,   ///< all atoms, or of a ligand those of an unknown element: parameters by element, charge 0
      OtherAtoms,   ///< atoms that the template does not have: by element, charge 0
      MissingAtoms  ///< the template has atoms that the file lacks; their charge is missing
    };
    Kind kind;
    std::uint32_t residue = kNoResidue;
    std::string template_name;
    int charge_e = 0;
  };
  std::vector<Note> notes;
};

/// A molecule's own partial charges (PQR, MOL2, PDBQT) replace all others. Residues at both ends of a chain are charged: an end
/// without OXT is not.
PairAtoms pairAtoms(const Molecule& molecule);

}  // namespace moltact
