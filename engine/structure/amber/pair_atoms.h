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

/// Rounding in files does not reach this: 4 decimals and 10 000 atoms err by 0.003 e (rms), 3 and 2000 by 0.013 e.
inline constexpr double kFractionalCharge_e = 0.1;
/// Two atoms of one molecule do not come this near.
inline constexpr double kSamePlace_A = 0.3;

struct PairAtoms {
  std::vector<PairAtom> atoms;         ///< those of the molecule in its order, then placed hydrogens
  std::vector<std::uint32_t> carrier;  ///< of each, the molecule's atom: itself, or the one that carries the hydrogen
  double net_charge_e = 0.0;
  bool file_charges = false;  ///< the charges are those of the file; no state and no ion is then noted
  std::size_t placed_hydrogens = 0;
  /// What was assumed or could not be assigned, untranslated parts for `info`: "HIS 69 A: HID". One entry per residue.
  struct Note {
    enum class Kind : std::uint8_t {
      Histidine,  ///< `template_name`: HID, HIE or HIP; where the file does not state it, by the nearest acceptor
      SideChain,  ///< ASP, GLU and LYS, charged unless the file states ASH, GLH or LYN
      Cysteine,   ///< CYX in a disulphide or CYM on a metal, by the bonds unless the file states it
      Ion,        ///< its formal charge: alkali metals 1, alkaline earths, zinc and cadmium 2, halides -1
      Terminus,   ///< an end of a chain with the template of that end: NALA, CALA, DA5, A3
      /// An end of a chain with the template of a residue inside a chain: no OXT, a nucleotide with a 5' phosphate.
      InnerEnd,
      Ligand,  ///< GAFF's parameters and Gasteiger's charges, with the net charge `charge_e`; states as in valences.h
      NoTemplate,    ///< all atoms, or of a ligand those of an unknown element: parameters by element, charge 0
      OtherAtoms,    ///< atoms that the template does not have: by element, charge 0
      MissingAtoms,  ///< the template has atoms that the file lacks; their charge is missing
      /// The file's charges of the residue are not whole; only where the net charge is farther than
      /// kFractionalCharge_e from a whole number. `residue` may be kNoResidue.
      FractionalCharge,
      UnknownElement,  ///< atoms of an unknown element: by radius; charge 0 unless the file has charges
      SamePlace        ///< an atom within kSamePlace_A of an earlier one. `residue` may be kNoResidue
    };
    Kind kind;
    std::uint32_t residue = kNoResidue;
    std::string template_name;
    int charge_e = 0;
    bool stated = false;            ///< the file's hydrogens or residue name determine the state
    double residue_charge_e = 0.0;  ///< of FractionalCharge: the sum of the residue's charges
  };
  std::vector<Note> notes;
};

/// A molecule's own partial charges (PQR, MOL2, PDBQT) replace all others. Residues at both ends of a chain are charged: an end
/// without OXT is not.
PairAtoms pairAtoms(const Molecule& molecule);

}  // namespace moltact
