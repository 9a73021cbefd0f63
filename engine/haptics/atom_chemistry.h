// Element, type and partial charge of each atom, for interactions that set `needs_chemistry`. The layer `forces` has
// parameters of its own (PairField). Plain data, built on the window's thread, then read by any thread. Unit: elementary
// charge.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

/// One entry for each sphere of the scene, in the order of the spheres.
struct AtomChemistry {
  std::vector<std::uint8_t> atomic_numbers;  ///< 0: unknown
  std::vector<std::uint16_t> types;          ///< index into type_names
  std::vector<float> charges_e;              ///< empty: the scene has no charges
  /// Keys of force-field tables: residue and atom, as "ASP OD1", or the element's symbol for an atom outside a residue.
  /// Distinct, in order of first use, at most 65,535 entries; beyond that, every further type is the last entry, an empty
  /// name.
  std::vector<std::string> type_names;
};

/// A source of the charges of a scene.
struct ChargeSource {
  std::string_view name;      ///< the word in a lesson's scene: "file"
  std::string_view sentence;  ///< description of the charges, untranslated (N_)
};

/// All sources, the default first. engine/structure/atom_charges.h computes the charges of each.
std::span<const ChargeSource> chargeSources();

inline constexpr std::string_view kNoCharges = "none", kFileCharges = "file", kFormalCharges = "formal";

}  // namespace moltact
