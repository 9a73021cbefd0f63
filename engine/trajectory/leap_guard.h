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

  /// The speed at which surfaces grow.
  static constexpr double kGrowth_A_per_s = 10.0;
  /// The speed of a hand that no atom surprises, and the time from one frame of the screen to the next.
  static constexpr double kHand_A_per_s = 120.0, kFrame_s = 0.017;

  /// All atoms are at these places, at once.
  void place(std::span<const Sphere> at);
  /// Whether the hand is within `room_A` of the touch of a sphere's surface.
  using Occupied = std::function<bool(const Sphere&, double room_A)>;
  /// The spheres of the next piece of the motion, which takes `piece_s`: replaces those of `to` that leap by more than
  /// `limit_A` (0: none) or are on the way back. An atom begins to grow only if the hand cannot reach it in the rest of
  /// the piece before, which may be as long as that piece, and a frame. Returns false if the number of spheres differs;
  /// then nothing is changed.
  bool step(std::vector<Sphere>& to, double limit_A, double piece_s, const Occupied& occupied);
  /// Whether atoms are away or on the way back, so that further steps are needed.
  bool unsettled() const { return unsettled_ > 0; }

 private:
  enum class State : std::uint8_t { Here, Shrunk, Away, Growing };

  std::vector<std::uint32_t> part_of_;
  std::vector<State> states_;    // of each covalent molecule
  std::vector<double> grown_A_;  // while it grows
  std::vector<Vec3> places_A_;   // of each atom after the last step
  double before_s_ = 0.0;        // the duration of the last step
  std::size_t unsettled_ = 0;
};

}  // namespace moltact
