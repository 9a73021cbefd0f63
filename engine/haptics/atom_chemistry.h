// What forces beyond contact need to know of each atom: element, type and partial charge. Plain data; made on the
// window's thread, then read by any thread. Unit: elementary charge.
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
  /// Residue and atom, "ASP OD1", by which tables of force fields are keyed; the element's symbol for an atom outside a
  /// residue. Distinct, in order of first use, at most 65,535; later types share the last entry, which is empty.
  std::vector<std::string> type_names;
};

/// Where the charges of a scene come from.
struct ChargeSource {
  std::string_view name;      ///< in a scene: "file"
  std::string_view sentence;  ///< N_; what the charges are
};

/// All sources, the default first. engine/structure/atom_charges.h assigns the charges of each.
std::span<const ChargeSource> chargeSources();

inline constexpr std::string_view kNoCharges = "none", kFileCharges = "file", kFormalCharges = "formal";

}  // namespace moltact
