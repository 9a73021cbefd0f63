// The atoms that a ball can touch from outside, on a straight line or on any path: the searches behind the facts of a
// lesson. They are more thorough than a task's (passable.h) and share no code with it. Not for the haptic thread. Unit:
// angstrom.
//
// Straight: the ball's centre moves along a line from far away and touches no other atom before it rests on this one.
// The search tries kRests evenly distributed rests on the atom's grown sphere, each checked against every other sphere
// in closed form. From each free rest it tries the line outward, and from every tenth rest also kLines even directions
// of the half space above. A line that is found is exact; a window of less than about 1 part in kRests may be missed.
//
// Any path: the free space of the centre is filled from outside on a grid of kCell_A, between cells that share a face.
// The path between two cells enters an atom by less than kClip_A. A path that is wider than the ball by kMissed_A,
// half a cell's diagonal, is never missed. An atom counts if a line without contact joins a free rest on it to a filled
// cell beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/core/units.h"

namespace moltact {

class WaysIn {
 public:
  static constexpr int kRests = 20'000, kLines = 400;
  static constexpr double kCell_A = 0.15, kClip_A = 0.002, kMissed_A = 0.13;

  /// The search on any path needs one byte per cell of the box round the molecule; in a larger box it finds nothing.
  static constexpr std::size_t kMaxCells = 400'000'000;

  WaysIn(std::span<const Sphere> spheres, double sphere_A);

  /// Whether the box is small enough for crooked() and share().
  bool searchable() const;

  /// Whether the sphere reaches this atom on a straight line.
  bool straight(std::uint32_t atom) const;
  /// Whether the sphere reaches it on any path.
  bool crooked(std::uint32_t atom) const;
  /// The part of this atom's grown sphere on which the ball can rest and that it reaches on any path, 0 to 1.
  double share(std::uint32_t atom) const;

  /// Those of these atoms that the sphere reaches on a straight line.
  std::vector<std::uint32_t> straight(std::span<const std::uint32_t> atoms) const;
  std::vector<std::uint32_t> crooked(std::span<const std::uint32_t> atoms) const;

 private:
  std::vector<Vec3> freeRests(std::uint32_t atom, const std::vector<std::uint32_t>& nearest) const;
  /// The other atoms, nearest first.
  std::vector<std::uint32_t> nearestTo(std::uint32_t atom) const;
  bool reached(const Vec3& rest, std::uint32_t atom, const std::vector<std::uint32_t>& nearest) const;
  void fill() const;
  Vec3 at(int x, int y, int z) const { return low_A_ + Vec3(x, y, z) * kCell_A; }
  std::size_t index(int x, int y, int z) const {
    return (std::size_t(x) * std::size_t(count_[1]) + std::size_t(y)) * std::size_t(count_[2]) + std::size_t(z);
  }

  std::vector<Sphere> grown_;
  Vec3 low_A_{0.0};
  int count_[3] = {0, 0, 0};
  enum Cell : char { Free, Shut, Filled };
  mutable std::vector<char> cells_;  // computed on the first request
};

}  // namespace moltact
