#include "engine/molecule/radius_tables.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

using Rows = std::initializer_list<std::pair<int, double>>;

constexpr std::array<double, kElementCount + 1> merged(std::initializer_list<Rows> tables) {
  std::array<double, kElementCount + 1> out{};
  for (const Rows& rows : tables)
    for (const auto& [atomic_number, radius_A] : rows) out[std::size_t(atomic_number)] = radius_A;
  return out;
}

// A. Bondi, J. Phys. Chem. 68, 441 (1964); hydrogen 1.20.
constexpr Rows kBondi{{1, 1.20},  {2, 1.40},  {3, 1.82},  {6, 1.70},  {7, 1.55},  {8, 1.52},  {9, 1.47},  {10, 1.54},
                      {11, 2.27}, {12, 1.73}, {14, 2.10}, {15, 1.80}, {16, 1.80}, {17, 1.75}, {18, 1.88}, {19, 2.75},
                      {28, 1.63}, {29, 1.40}, {30, 1.39}, {31, 1.87}, {33, 1.85}, {34, 1.90}, {35, 1.85}, {36, 2.02},
                      {46, 1.63}, {47, 1.72}, {48, 1.58}, {49, 1.93}, {50, 2.17}, {52, 2.06}, {53, 1.98}, {54, 2.16},
                      {78, 1.75}, {79, 1.66}, {80, 1.55}, {81, 1.96}, {82, 2.02}, {92, 1.86}};
// S. Alvarez, Dalton Trans. 42, 8617 (2013): the elements that Bondi does not list, and those that both list.
constexpr Rows kAlvarezAlone{{4, 1.98},  {5, 1.91},  {13, 2.25}, {20, 2.62}, {21, 2.58}, {22, 2.46}, {23, 2.42},
                             {24, 2.45}, {25, 2.45}, {26, 2.44}, {27, 2.40}, {32, 2.29}, {37, 3.21}, {38, 2.84},
                             {39, 2.75}, {40, 2.52}, {41, 2.56}, {42, 2.45}, {43, 2.44}, {44, 2.46}, {45, 2.44},
                             {51, 2.47}, {55, 3.48}, {56, 3.03}, {57, 2.98}, {58, 2.88}, {59, 2.92}, {60, 2.95},
                             {62, 2.90}, {63, 2.87}, {64, 2.83}, {65, 2.79}, {66, 2.87}, {67, 2.81}, {68, 2.83},
                             {69, 2.79}, {70, 2.80}, {71, 2.74}, {72, 2.63}, {73, 2.53}, {74, 2.57}, {75, 2.49},
                             {76, 2.48}, {77, 2.41}, {83, 2.54}, {89, 2.80}, {90, 2.93}, {91, 2.88}, {93, 2.82},
                             {94, 2.81}, {95, 2.83}, {96, 3.05}, {97, 3.40}, {98, 3.05}, {99, 2.70}};
constexpr Rows kAlvarezBoth{{1, 1.20},  {2, 1.43},  {3, 2.12},  {6, 1.77},  {7, 1.66},  {8, 1.50},  {9, 1.46},
                            {10, 1.58}, {11, 2.50}, {12, 2.51}, {14, 2.19}, {15, 1.90}, {16, 1.89}, {17, 1.82},
                            {18, 1.83}, {19, 2.73}, {28, 2.40}, {29, 2.38}, {30, 2.39}, {31, 2.32}, {33, 1.88},
                            {34, 1.82}, {35, 1.86}, {36, 2.25}, {46, 2.15}, {47, 2.53}, {48, 2.49}, {49, 2.43},
                            {50, 2.42}, {52, 1.99}, {53, 2.04}, {54, 2.06}, {78, 2.29}, {79, 2.32}, {80, 2.45},
                            {81, 2.47}, {82, 2.60}, {92, 2.71}};

const std::array kRadiusTables{
    RadiusTable{.word = {"bondi", N_("Bondi"),
                         N_("the radii of Bondi (1964), and those of Alvarez for elements that he does not list")},
                .radius_A = merged({kAlvarezAlone, kBondi}),
                .body_overlap_A = 0.5,
                .ligand_overlap_A = 0.46},
    RadiusTable{.word = {"alvarez", N_("Alvarez"), N_("the radii of Alvarez (2013), from distances in crystals")},
                .radius_A = merged({kAlvarezAlone, kAlvarezBoth}),
                .body_overlap_A = 0.5,
                .ligand_overlap_A = 0.42},
};

}  // namespace

bool RadiusTable::knows(int atomic_number) const {
  return atomic_number > 0 && atomic_number <= kElementCount && radius_A[std::size_t(atomic_number)] > 0.0;
}

double RadiusTable::radius(int atomic_number) const {
  return knows(atomic_number) ? radius_A[std::size_t(atomic_number)] : kDefaultRadius_A;
}

std::span<const RadiusTable> radiusTables() { return kRadiusTables; }

const RadiusTable& radiusTable(std::string_view name) {
  const auto at = std::find_if(kRadiusTables.begin(), kRadiusTables.end(),
                               [&](const RadiusTable& t) { return t.word.name == name; });
  return at == kRadiusTables.end() ? kRadiusTables.front() : *at;
}

}  // namespace moltact
