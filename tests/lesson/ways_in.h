// The atoms that a sphere can touch from outside, on a straight line or on any path. The oracle for statements of
// lessons such as "so many of these atoms can be touched"; shares no code with trackers and surface places. Unit:
// angstrom.
//
// Straight: the sphere's centre moves along a line from far away and touches no other atom before it rests on this one.
// The test tries `kRests` evenly distributed rests on the atom's grown sphere, each checked against every other sphere
// in closed form. From each free rest it tries the line outward, and from every tenth rest also kLines even directions
// of the half space above. A line that is found is exact; a window of less than about 1 part in kRests may be missed.
//
// Crooked: the free space of the centre is filled from outside on a grid of kCell_A, between cells that share a face.
// The path between two cells enters an atom by less than kClip_A. A path that is wider than the sphere by kMissed_A,
// half a cell's diagonal, is never missed. An atom counts if a line without contact joins a free rest on it to a filled
// cell beside it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/core/units.h"

namespace moltact::test {

class WaysIn {
 public:
  static constexpr int kRests = 20'000, kLines = 400;
  static constexpr double kCell_A = 0.15, kClip_A = 0.002, kMissed_A = 0.13;

  WaysIn(std::span<const Sphere> spheres, double sphere_A);

  /// Whether the sphere reaches this atom on a straight line.
  bool straight(std::uint32_t atom) const;
  /// Whether the sphere reaches it on any path.
  bool crooked(std::uint32_t atom) const;
  /// The share of the free rests on this atom that the sphere reaches on any path, in thousandths of a sphere: how much
  /// of it can be touched (unit: 1).
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

}  // namespace moltact::test
