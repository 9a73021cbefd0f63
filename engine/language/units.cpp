#include "engine/language/units.h"

#include <atomic>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using D = Dimension;

constexpr double kAvogadro_per_mol = 6.02214076e23;  // exact by the definition of the mole
constexpr int kInLessons = kWritten | kNamed, kChosen = kShowable | kInPreferences;

// U+00C5 is the letter, U+212B the angstrom sign; keyboards and web pages produce either. The first unit of a dimension
// with factor 1 is the code's unit.
constexpr Unit kUnits[] = {
    {"Å", D::Length, 1.0, kInLessons | kChosen, 2},
    {"\xE2\x84\xAB", D::Length, 1.0, kWritten},
    {"A", D::Length, 1.0, kWritten},
    {"nm", D::Length, 10.0, kInLessons | kChosen, 3},
    {"pm", D::Length, 0.01, kWritten | kChosen, 0},
    {"N", D::Force, 1.0, kInLessons | kChosen, 2},
    {"mN", D::Force, 0.001, kInLessons | kChosen, 0},
    {"pN", D::Force, 1e-12, kProseOnly},
    {"s", D::Time, 1.0, kInLessons | kShowable, 1},
    {"ms", D::Time, 0.001, kWritten},
    {"min", D::Time, 60.0, kInLessons},
    {"h", D::Time, 3600.0, kProseOnly},
    {"µs", D::Time, 1e-6, kProseOnly},
    {"ns", D::Time, 1e-9, kProseOnly},
    {"N/m", D::Stiffness, 0.001, kInLessons | kChosen, 0},
    {"N/mm", D::Stiffness, 1.0, kInLessons | kChosen, 2},
    {"mm", D::HandLength, 1.0, kChosen, 1},
    {"µm", D::HandLength, 0.001, kProseOnly},
    {"cm", D::HandLength, 10.0, kChosen, 2},
    {"m", D::HandLength, 1000.0, kProseOnly},
    {"°", D::Angle, 1.0, kWritten | kNamed | kShowable, 1},
    {"%", D::Share, 0.01, kWritten | kNamed | kShowable, 0},
    {"Hz", D::Frequency, 1.0, kShowable, 0},
    {"kHz", D::Frequency, 1000.0, kProseOnly},
    {"J", D::Energy, 1.0, kShowable, 4},
    {"mJ", D::Energy, 1e-3, kShowable, 2},
    {"zJ", D::Energy, 1e-21, kShowable, 1},
    {"kJ/mol", D::Energy, 1e3 / kAvogadro_per_mol, kShowable, 1},
    {"kcal/mol", D::Energy, 4184.0 / kAvogadro_per_mol, kShowable, 1},
    {"Å²", D::Other, 1.0, kProseOnly},
    {"Å³", D::Other, 1.0, kProseOnly},
    {"°C", D::Other, 1.0, kProseOnly},
    {"K", D::Other, 1.0, kProseOnly},
    {"g", D::Other, 1.0, kProseOnly},
    {"kg", D::Other, 1.0, kProseOnly},
    {"Da", D::Other, 1.0, kProseOnly},
    {"kDa", D::Other, 1.0, kProseOnly},
};

// The default units for display.
constexpr std::pair<Dimension, std::string_view> kOwnUnits[] = {
    {D::Length, "Å"}, {D::Force, "N"}, {D::Time, "s"},       {D::Stiffness, "N/mm"}, {D::HandLength, "mm"},
    {D::Angle, "°"},  {D::Share, "%"}, {D::Frequency, "Hz"}, {D::Energy, "mJ"},
};

// Energies have no choice: that of the spring in the hand is shown in mJ; energies and forces between atoms keep kcal/mol
// and pN, the units of their literature.
constexpr OfferedDimension kOfferedDimensions[] = {
    {D::Length, "length", N_("Lengths in the molecule")},
    {D::HandLength, "hand-length", N_("Lengths at the hand")},
    {D::Force, "force", N_("Forces")},
    {D::Stiffness, "stiffness", N_("Stiffnesses")},
};

// One pointer per dimension, so that a thread that reads while another writes gets the old or the new unit.
struct Shown {
  std::array<std::atomic<const Unit*>, kDimensions> units;
  Shown() {
    const UnitSet own;
    for (std::size_t d = 0; d < kDimensions; ++d) units[d].store(own.of(Dimension(d)));
  }
};
Shown& shown() {
  static Shown all;
  return all;
}

}  // namespace

std::span<const Unit> units() { return kUnits; }

const Unit* unitNamed(std::string_view symbol, Dimension dimension) {
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.symbol == symbol) return &u;
  return nullptr;
}

const Unit* unitNamed(std::string_view symbol) {
  for (const Unit& u : kUnits)
    if (u.symbol == symbol) return &u;
  return nullptr;
}

std::string_view codeUnit(Dimension dimension) {
  if (dimension == Dimension::Share || dimension == Dimension::Other) return {};
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.in_code_units == 1.0) return u.symbol;
  return {};
}

std::span<const OfferedDimension> offeredDimensions() { return kOfferedDimensions; }

std::vector<std::string_view> offeredUnits(Dimension dimension) {
  std::vector<std::string_view> out;
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.use & kInPreferences) out.push_back(u.symbol);
  return out;
}

std::vector<std::string_view> namedUnits(Dimension dimension) {
  std::vector<std::string_view> out;
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.use & kNamed) out.push_back(u.symbol);
  return out;
}

UnitSet::UnitSet() {
  for (const auto& [dimension, symbol] : kOwnUnits) choose(dimension, symbol);
}

bool UnitSet::choose(Dimension dimension, std::string_view symbol) {
  const Unit* unit = unitNamed(symbol, dimension);
  if (!unit || !(unit->use & kShowable)) return false;
  units_[std::size_t(dimension)] = unit;
  return true;
}

bool UnitSet::choose(std::string_view dimension_name, std::string_view symbol) {
  for (const OfferedDimension& o : kOfferedDimensions)
    if (o.name == dimension_name) return choose(o.dimension, symbol);
  return false;
}

void setShownUnits(const UnitSet& units) noexcept {
  for (std::size_t d = 0; d < kDimensions; ++d)
    shown().units[d].store(units.of(Dimension(d)), std::memory_order_relaxed);
}

const Unit* shownUnit(Dimension dimension) noexcept {
  return shown().units[std::size_t(dimension)].load(std::memory_order_relaxed);
}

}  // namespace moltact
