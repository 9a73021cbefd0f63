// The parts of the picture of a molecule under touch, with their names in lessons, on the command line and on the
// screen. Plain data; any thread except the haptic one.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// The parts of a picture that are switched individually. A new part needs an enumerator here, a row of the table in
/// view_part.cpp and code in engine/render: `MoleculeLayer` for parts fixed to the molecule, haptic_shapes.cpp for data
/// structures of a method, glyphs.cpp for other parts that move with the hand.
enum class ViewPart : std::uint8_t { Atoms, Spheres, Circles, Points, Cones, Hip, Scp, Force, Probe, Target, Facets };

struct ViewPartInfo {
  ViewPart part;
  std::string_view name;  ///< as in `show: circles` of a lesson and `--show circles`
  const char* label;      ///< in menus: "Creases", the term of the lessons; untranslated (N_)
  const char* sentence;   ///< description for a tool tip and `--help`; untranslated (N_)
  bool haptic;            ///< belongs to the group `haptic`
  bool expert = false;    ///< shows how a method works; offered in expert mode only

  /// The translated label.
  const char* shownLabel() const;
};

/// All parts, in menu order.
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

/// The parts that are shown by default: atoms, probe, force, target.
ViewPartSet defaultViewParts();

/// Parses names separated by commas ("atoms,circles"); groups are `haptic`, `all` and `none`. For an unknown name the
/// Problem lists the known ones.
Expected<ViewPartSet> parseViewParts(std::string_view names);

}  // namespace moltact
