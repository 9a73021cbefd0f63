// The parts of a picture of a molecule that is touched: their names in lessons and on the command line, and on the
// screen. Plain data; any thread but the haptic one.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// The parts of a picture that are switched one by one. A new part is a word here, a row of the table in view_part.cpp
/// and a drawing in engine/render: `MoleculeLayer` for what stays with the molecule, haptic_shapes.cpp for what a method
/// works with, glyphs.cpp for what else moves with the hand.
enum class ViewPart : std::uint8_t { Atoms, Spheres, Circles, Points, Cones, Hip, Scp, Force, Probe, Target, Facets };

struct ViewPartInfo {
  ViewPart part;
  std::string_view name;  ///< as in `show: circles` of a lesson and `--show circles`
  const char* label;      ///< "Creases", of menus and switches, in English: the lessons' word
  const char* sentence;   ///< what it is, for a tool tip and for `--help`, in English
  bool haptic;            ///< belongs to the group `haptic`
  bool expert = false;    ///< how a method works rather than what is felt: offered to experts only

  /// The label in the language in use.
  const char* shownLabel() const;
};

/// All parts in the order in which they are offered.
std::span<const ViewPartInfo> viewParts();

class ViewPartSet {
 public:
  constexpr ViewPartSet() = default;
  constexpr ViewPartSet(std::initializer_list<ViewPart> parts) {
    for (const ViewPart p : parts) set(p);
  }
  constexpr bool has(ViewPart p) const { return bits_ >> unsigned(p) & 1u; }
  constexpr void set(ViewPart p, bool on = true) {
    bits_ = on ? bits_ | 1u << unsigned(p) : bits_ & ~(1u << unsigned(p));
  }
  friend constexpr bool operator==(const ViewPartSet&, const ViewPartSet&) = default;

 private:
  std::uint32_t bits_ = 0;
};

/// The parts that a picture shows unless others are asked for: atoms, probe, force, target.
ViewPartSet defaultViewParts();

/// Reads names separated by commas ("atoms,circles"); the groups are `haptic`, `all` and `none`. For an unknown name
/// the problem lists the known ones.
Expected<ViewPartSet> parseViewParts(std::string_view names);

}  // namespace moltact
