// Which atoms a sphere can touch, coming from outside: straight, or by any crooked way. The oracle for every "so many of
// these atoms can be touched" of a lesson; it shares nothing with trackers and surface places. Units: angstrom.
//
// Straight: the sphere's centre moves along a line from far away and meets no other atom before it rests on this one. The
// rests tried are `kRests` even directions on the atom's grown sphere, with the test against every other sphere in closed form;
// from each free rest the line outward is tried first, then kLines even directions of the half space above it from every
// tenth rest. A line that is found is exact; a window of less than about 1 part in kRests may be missed.
//
// Crooked: the free space of the centre is filled from outside on a grid of kCell_A, between neighbours that share a face.
// Two of them are joined by a way that enters an atom by less than kClip_A. A way that is wider than the sphere by
// kMissed_A, half a cell's diagonal, is never missed. An atom counts where a free rest on it is joined to a filled cell beside it by a
// line that no atom meets.
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

  /// Whether the sphere comes straight to this atom.
  bool straight(std::uint32_t atom) const;
  /// Whether it comes there at all.
  bool crooked(std::uint32_t atom) const;
  /// The share of the free rests on this atom to which the sphere comes by some way, by thousandths of a sphere: how much of it
  /// there is to touch (unit: 1).
  double share(std::uint32_t atom) const;

  /// Those of these atoms to which the sphere comes.
  std::vector<std::uint32_t> straight(std::span<const std::uint32_t> atoms) const;
  std::vector<std::uint32_t> crooked(std::span<const std::uint32_t> atoms) const;

 private:
  std::vector<Vec3> freeRests(std::uint32_t atom, const std::vector<std::uint32_t>& nearest) const;
  /// The others, nearest first.
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
  mutable std::vector<char> cells_;  // made when first asked for
};

}  // namespace moltact::test
