#include "engine/haptics/field/force_choices.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr EnergyPartInfo kParts[] = {
    {EnergyPart::VanDerWaals, "van-der-waals", N_("Van der Waals"),
     N_("attraction and repulsion of neutral atoms (Lennard-Jones)"), false, true,
     [](PairAtom& atom) noexcept { atom.depth_kcal_mol = 0.0f; }},
    {EnergyPart::Electrostatic, "electrostatic", N_("Charges"), N_("attraction and repulsion of charges (Coulomb)"),
     true, true, [](PairAtom& atom) noexcept { atom.charge_e = 0.0f; }},
};
static_assert(std::size(kParts) == kEnergyParts, "one row for each EnergyPart");
static_assert(
    [] {
      for (std::size_t k = 0; k < kEnergyParts; ++k)
        if (std::size_t(kParts[k].part) != k) return false;
      return true;
    }(),
    "in the order of EnergyPart");

constexpr auto kForces = [] {
  std::array<ForceChoice, 2 + kEnergyParts> out{};
  out[0] = {"none", N_("None"), N_("contact alone"), {}};
  out[1] = {"all", N_("All"), N_("van der Waals forces and forces between charges"), {}};
  for (std::size_t k = 0; k < kEnergyParts; ++k) {
    out[2 + k] = {kParts[k].name, kParts[k].title, kParts[k].sentence, {}};
    out[1].acts.values[k] = kParts[k].in_all;
    out[2 + k].acts.values[k] = true;
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

bool ForceChoice::feelsCharges() const {
  for (const EnergyPartInfo& part : kParts)
    if (part.of_charges && acts[part.part]) return true;
  return false;
}

std::span<const EnergyPartInfo, kEnergyParts> energyParts() { return kParts; }

std::span<const ForceChoice> forceChoices() { return kForces; }
const ForceChoice& forceChoice(std::string_view name) { return named(kForces, name); }

std::span<const DielectricChoice> dielectricChoices() { return kMedia; }
const DielectricChoice& dielectricChoice(std::string_view name) { return named(kMedia, name); }

}  // namespace moltact
