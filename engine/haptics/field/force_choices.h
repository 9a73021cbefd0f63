// The forces between atoms that a scene can select, and the media between their charges: the words of the properties
// "forces" and "dielectric" (touch_setup.h). Plain data, every thread.
#pragma once

#include <span>
#include <string_view>

#include "engine/haptics/field/energy_part.h"
#include "engine/haptics/field/pair_model.h"

namespace moltact {

/// A part of the energy between atoms.
struct EnergyPartInfo {
  EnergyPart part;
  std::string_view name;      ///< "electrostatic"
  std::string_view title;     ///< on the screen, untranslated (N_)
  std::string_view sentence;  ///< description, untranslated (N_)
  bool of_charges;            ///< depends on the atoms' charges
  bool in_all;                ///< acts where a scene selects "all"
  /// Removes the part's parameters from an atom, which then has no such energy.
  void (*remove)(PairAtom&) noexcept;
};

/// Every part, in the order of EnergyPart.
std::span<const EnergyPartInfo, kEnergyParts> energyParts();

/// The parts that a scene selects: none, all (those with EnergyPartInfo::in_all), or one alone, which has the part's name.
struct ForceChoice {
  std::string_view name, title, sentence;  ///< as in EnergyPartInfo
  PerEnergyPart<bool> acts;

  bool feelsCharges() const;
  bool any() const {
    for (const bool one : acts.values)
      if (one) return true;
    return false;
  }
};

/// All choices: none, all, then each part alone.
std::span<const ForceChoice> forceChoices();
/// The choice of that name; the first for an unknown name.
const ForceChoice& forceChoice(std::string_view name);

struct DielectricChoice {
  std::string_view name;      ///< "water"
  std::string_view title;     ///< on the screen, untranslated (N_)
  std::string_view sentence;  ///< description, untranslated (N_)
  Dielectric kind = Dielectric::MehlerSolmajer;
  double dielectric = 1.0;  ///< PairModel::dielectric
};

/// All media, the default first.
std::span<const DielectricChoice> dielectricChoices();
/// The medium of that name; the default for an unknown name.
const DielectricChoice& dielectricChoice(std::string_view name);

}  // namespace moltact
