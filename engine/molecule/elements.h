// The table of chemical elements: symbol, name, colour. Plain data, any thread. radius_tables.h has their radii.
//
// Colours: the convention of Jmol and of CPK models (carbon grey, oxygen red, nitrogen blue, sulfur yellow). Iron,
// selenium and calcium are darker than in Jmol, to distinguish them from phosphorus and chlorine.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace moltact {

inline constexpr int kElementCount = 118;

struct Element {
  std::string_view symbol;             ///< "Fe"; "?" for the unknown element
  std::string_view name;               ///< "iron"
  std::array<std::uint8_t, 3> colour;  ///< sRGB, 8 bit
};

/// The element with this atomic number; 0 or a number beyond the table returns the unknown element (pink).
const Element& element(int atomic_number);

}  // namespace moltact
