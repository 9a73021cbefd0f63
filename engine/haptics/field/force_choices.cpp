#include "engine/haptics/field/force_choices.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kForces{
    ForceChoice{"none", N_("None"), N_("contact alone")},
    ForceChoice{"all", N_("All"), N_("van der Waals forces and forces between charges"), true, true},
    ForceChoice{"van-der-waals", N_("Van der Waals"), N_("attraction and repulsion of neutral atoms (Lennard-Jones)"),
                true, false},
    ForceChoice{"electrostatic", N_("Charges"), N_("attraction and repulsion of charges (Coulomb)"), false, true},
};

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

std::span<const ForceChoice> forceChoices() { return kForces; }
const ForceChoice& forceChoice(std::string_view name) { return named(kForces, name); }

std::span<const DielectricChoice> dielectricChoices() { return kMedia; }
const DielectricChoice& dielectricChoice(std::string_view name) { return named(kMedia, name); }

}  // namespace moltact
