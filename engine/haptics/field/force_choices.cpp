#include "engine/haptics/field/force_choices.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array<EnergyPartInfo, kEnergyParts> kParts{{
    {EnergyPart::VanDerWaals, "van-der-waals", N_("Van der Waals"),
     N_("attraction and repulsion of neutral atoms (Lennard-Jones)"),
     [](PairAtom& atom) noexcept { atom.depth_kcal_mol = 0.0f; }},
    {EnergyPart::Electrostatic, "electrostatic", N_("Charges"), N_("attraction and repulsion of charges (Coulomb)"),
     [](PairAtom& atom) noexcept { atom.charge_e = 0.0f; }},
}};

constexpr auto kForces = [] {
  std::array<ForceChoice, 2 + kEnergyParts> out{};
  out[0] = {"none", N_("None"), N_("contact alone"), {}};
  out[1] = {"all", N_("All"), N_("van der Waals forces and forces between charges"), {}};
  out[1].acts.values.fill(true);
  for (std::size_t k = 0; k < kEnergyParts; ++k) {
    out[2 + k] = {kParts[k].name, kParts[k].title, kParts[k].sentence, {}};
    out[2 + k].acts[kParts[k].part] = true;
  }
  return out;
}();

constexpr std::array kMedia{
    DielectricChoice{"water", N_("Water"),
                     N_("charges are screened as in water, more with distance (Mehler & Solmajer)"),
                     Dielectric::MehlerSolmajer},
    DielectricChoice{"distance", N_("Four times the distance"),
                     N_("a dielectric constant of four times the distance in ångström"), Dielectric::Distance, 4.0},
    DielectricChoice{"vacuum", N_("Vacuum"), N_("charges are not screened"), Dielectric::Constant, 1.0},
};

template <class Table>
const auto& named(const Table& table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.name == name; });
  return found == table.end() ? table.front() : *found;
}

}  // namespace

std::span<const EnergyPartInfo, kEnergyParts> energyParts() { return kParts; }

std::span<const ForceChoice> forceChoices() { return kForces; }
const ForceChoice& forceChoice(std::string_view name) { return named(kForces, name); }

std::span<const DielectricChoice> dielectricChoices() { return kMedia; }
const DielectricChoice& dielectricChoice(std::string_view name) { return named(kMedia, name); }

}  // namespace moltact
