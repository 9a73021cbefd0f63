// The forces between atoms that a scene can select, and the media between their charges: the words of the properties
// "forces" and "dielectric" (touch_setup.h). Plain data, every thread.
#pragma once

#include <span>
#include <string_view>

#include "engine/haptics/field/pair_model.h"

namespace moltact {

struct ForceChoice {
  std::string_view name;      ///< "electrostatic"
  std::string_view title;     ///< on the screen, untranslated (N_)
  std::string_view sentence;  ///< description, untranslated (N_)
  bool van_der_waals = false, electrostatic = false;

  bool any() const { return van_der_waals || electrostatic; }
};

/// All choices; the first has no forces.
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
