// The parts of the energy between two atoms. What a new part needs: CONTRIBUTING.md, "A part of the energy between
// atoms". Plain data, every thread. Units: kcal/mol.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace moltact {

enum class EnergyPart : std::uint8_t { VanDerWaals, Electrostatic };
inline constexpr std::size_t kEnergyParts = 2;

/// One value for each part.
template <class Value>
struct PerEnergyPart {
  std::array<Value, kEnergyParts> values{};

  constexpr Value& operator[](EnergyPart part) { return values[std::size_t(part)]; }
  constexpr const Value& operator[](EnergyPart part) const { return values[std::size_t(part)]; }
  friend bool operator==(const PerEnergyPart&, const PerEnergyPart&) = default;
};

/// Energies by part (unit: kcal/mol).
struct EnergyByPart : PerEnergyPart<double> {
  constexpr double total_kcal_mol() const {
    double out = 0.0;
    for (const double value : values) out += value;
    return out;
  }
  constexpr EnergyByPart& operator+=(const EnergyByPart& other) {
    for (std::size_t k = 0; k < kEnergyParts; ++k) values[k] += other.values[k];
    return *this;
  }
};

}  // namespace moltact
