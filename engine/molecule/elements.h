// The table of chemical elements: symbol, name, van der Waals radius with its source, colour. Plain data, any thread.
// Units: angstrom.
//
// Radii: Bondi (J. Phys. Chem. 68, 441, 1964; hydrogen 1.20) for the 38 elements that he lists; Alvarez (Dalton Trans.
// 42, 8617, 2013) for the other elements up to einsteinium. kDefaultRadius_A is used for promethium, polonium to
// radium, all elements after einsteinium and unknown elements, for which neither source gives a radius.
//
// Colours: the convention of Jmol and of CPK models (carbon grey, oxygen red, nitrogen blue, sulfur yellow). Iron,
// selenium and calcium are darker than in Jmol, to distinguish them from phosphorus and chlorine.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace moltact {

enum class RadiusSource : std::uint8_t { Bondi, Alvarez, Default };

/// Radius of elements without a published radius: Bondi's carbon (unit: angstrom).
inline constexpr double kDefaultRadius_A = 1.70;

inline constexpr int kElementCount = 118;

struct Element {
  std::string_view symbol;  ///< "Fe"; "?" for the unknown element
  std::string_view name;    ///< "iron"
  double radius_A;          ///< van der Waals radius
  RadiusSource source;
  std::array<std::uint8_t, 3> colour;  ///< sRGB, 8 bit
};

/// The element with this atomic number; 0 or a number beyond the table returns the unknown element (default radius,
/// pink).
const Element& element(int atomic_number);

}  // namespace moltact
