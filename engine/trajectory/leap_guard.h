// Atoms that leap: a covalent molecule that leaves the periodic cell on one side comes back on the other, as a water or
// an ion does. Its atoms take no way between the two places. The guard replaces such a step in the motions that the
// servo loop follows. The atoms shrink to nothing where they are, are not felt while they are away (SphereMotion), and
// grow again at the new place once the hand is not there. One thread at a time, not the haptic one. Unit: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

/// The covalent molecules whose centres are more than `limit_A` apart in two frames, by the molecule of each atom. A
/// limit of 0 (a file without cell): none.
std::vector<bool> leapsBetween(std::span<const Vec3> from, std::span<const Vec3> to,
                               std::span<const std::uint32_t> part_of, std::size_t parts, double limit_A);

class LeapGuard {
 public:
  LeapGuard() = default;
  /// `part_of`: the covalent molecule of each atom, of `parts`.
  LeapGuard(std::span<const std::uint32_t> part_of, std::size_t parts);

  /// Surfaces grow by this in a piece of the motion (10 A/s in pieces of 33 ms).
  static constexpr double kGrowth_A = 0.33;
  /// Room around the hand in which no atom appears, beyond the touch of its surface. The hand cannot cross it within a
  /// piece of the motion and the frame before, if it moves by less than 100 A/s.
  static constexpr double kClear_A = 6.0;

  /// All atoms are at these places, at once.
  void place(std::span<const Sphere> at);
  /// The spheres of the next piece of the motion: replaces those of `to` that leap by more than `limit_A` (0: none) or
  /// are on the way back. `occupied(sphere)` tells whether the hand is where this sphere would appear. Returns false if
  /// the number of spheres differs; then nothing is changed.
  bool step(std::vector<Sphere>& to, double limit_A, const std::function<bool(const Sphere&)>& occupied);
  /// Whether atoms are away or on the way back, so that further steps are needed.
  bool unsettled() const { return unsettled_ > 0; }

 private:
  enum class State : std::uint8_t { Here, Shrunk, Away, Growing };

  std::vector<std::uint32_t> part_of_;
  std::vector<State> states_;    // of each covalent molecule
  std::vector<double> grown_A_;  // while it grows
  std::vector<Vec3> places_A_;   // of each atom after the last step
  std::size_t unsettled_ = 0;
};

}  // namespace moltact
