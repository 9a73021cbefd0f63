#include "engine/language/units.h"

namespace moltact {
namespace {

using D = Dimension;

constexpr int kBoth = kWritten | kShown;

// U+00C5 is the letter, U+212B the angstrom sign; keyboards and web pages give either.
constexpr Unit kUnits[] = {
    {"Å", D::Length, 1.0, kBoth, 2},       {"\xE2\x84\xAB", D::Length, 1.0, kWritten},
    {"A", D::Length, 1.0, kWritten},       {"nm", D::Length, 10.0, kWritten},
    {"pm", D::Length, 0.01, kWritten},     {"N", D::Force, 1.0, kBoth, 2},
    {"mN", D::Force, 0.001, kWritten},     {"pN", D::Force, 1e-12, kKept},
    {"s", D::Time, 1.0, kBoth, 1},         {"ms", D::Time, 0.001, kWritten},
    {"min", D::Time, 60.0, kWritten},      {"h", D::Time, 3600.0, kKept},
    {"µs", D::Time, 1e-6, kKept},          {"ns", D::Time, 1e-9, kKept},
    {"N/mm", D::Stiffness, 1.0, kBoth, 2}, {"N/m", D::Stiffness, 0.001, kWritten},
    {"mm", D::HandLength, 1.0, kShown, 1}, {"µm", D::HandLength, 0.001, kKept},
    {"cm", D::HandLength, 10.0, kKept},    {"m", D::HandLength, 1000.0, kKept},
    {"°", D::Angle, 1.0, kShown, 1},       {"%", D::Share, 0.01, kShown, 0},
    {"Hz", D::Frequency, 1.0, kShown, 0},  {"kHz", D::Frequency, 1000.0, kKept},
    {"Å²", D::Other, 1.0, kKept},          {"Å³", D::Other, 1.0, kKept},
    {"°C", D::Other, 1.0, kKept},          {"K", D::Other, 1.0, kKept},
    {"g", D::Other, 1.0, kKept},           {"kg", D::Other, 1.0, kKept},
    {"Da", D::Other, 1.0, kKept},          {"kDa", D::Other, 1.0, kKept},
};

}  // namespace

std::span<const Unit> units() { return kUnits; }

const Unit* shownUnit(Dimension dimension) {
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.use & kShown) return &u;
  return nullptr;
}

const Unit* unitNamed(std::string_view symbol, Dimension dimension) {
  for (const Unit& u : kUnits)
    if (u.dimension == dimension && u.symbol == symbol) return &u;
  return nullptr;
}

}  // namespace moltact
