// The signed distance to the spheres' surfaces on a grid, smoothly interpolated, in bricks that are made when they are
// first needed. A brick is 4 x 4 x 4 cells; a pool of fixed size keeps kBricks of them and drops the oldest.
//
// The field: f(x) = min over spheres of |x - centre| - radius, not inflated. A probe of radius p feels the level f = p,
// so another probe needs no other bricks. Outside all spheres f is the distance; inside it is only a bound, which is
// enough because the SCP stays outside. The interpolation: quadratic B-splines over coefficients c = f - (1/8) (second
// differences of f along each axis), which reproduce quadratics exactly. So the error is of third order in the spacing
// where f is smooth, its gradient is continuous, and creases are rounded over about one spacing. Haptic thread; no
// allocation after construction. Units: angstrom; places relative to the given origin.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "engine/haptics/sphere_grid.h"

namespace moltact {

class DistanceBricks {
 public:
  static constexpr int kCells = 4;                ///< along an edge of a brick
  static constexpr std::uint32_t kBricks = 1024;  ///< in the pool, unless prepare() made more
  static constexpr int kLabels = 24;              ///< spheres that a brick remembers, to name the nearest

  /// `cap_A`: the field is never asked beyond this level; farther places may return this level instead of their
  /// distance.
  DistanceBricks(std::shared_ptr<const SphereGrid> scene, const Vec3& origin, double spacing_A, double cap_A);

  /// Makes all bricks that the surface at this level passes through or comes near to, with space for twice as many: no
  /// brick is made during touch. Before touching; allocates.
  void prepare(double level_A);

  struct Sample {
    double value;  ///< the field
    Vec3 gradient;
    glm::dmat3 hessian;  ///< second derivatives, continuous within a cell only
  };

  /// Reads the field. Makes the brick if it is missing and `fills_left` allows it; else false, and nothing is read.
  bool sample(const Vec3& place, Sample& out, int& fills_left) noexcept;

  /// The sphere whose surface is nearest to the place, among those that its brick remembers; -1 where the brick is
  /// missing.
  std::int32_t nearestSphere(const Vec3& place) const noexcept;

  /// Changes the cap; forgets all bricks if it grows.
  void setCap(double cap_A) noexcept;
  double spacing_A() const noexcept { return spacing_; }

  std::uint64_t bricksMade() const noexcept { return made_; }             ///< since the start
  std::size_t spheresRemembered() const noexcept { return remembered_; }  ///< different spheres in all bricks held now
  std::size_t bytes() const noexcept;
  /// The memory of a grid over the whole box of the scene at this spacing.
  std::size_t wholeMoleculeBytes() const noexcept;

 private:
  static constexpr int kSide = kCells + 2;     // coefficients along an edge
  static constexpr int kSamples = kCells + 4;  // distances along an edge, from which they are made
  static constexpr std::uint32_t kWays = 8;
  struct Key {
    std::int32_t x, y, z;
    bool operator==(const Key&) const = default;
  };
  static constexpr Key kNowhere{INT32_MAX, INT32_MAX, INT32_MAX};
  struct Brick {
    Key key = kNowhere;
    std::uint64_t age = 0;
    std::int32_t labels = 0;
    std::array<std::int32_t, kLabels> label;
    std::array<float, kSide * kSide * kSide>
        coefficient;  // rounded by less than 1e-6 A: half the memory, half the cache
  };

  std::uint32_t set(const Key& key) const;
  void forget(Brick& brick) noexcept;
  Brick* find(const Key& key) const noexcept;
  Brick* make(const Key& key) noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  Vec3 origin_;
  double spacing_, cap_;
  std::uint32_t count_ = kBricks;  // a power of two
  std::unique_ptr<Brick[]> bricks_;
  mutable Brick* last_;
  std::uint64_t made_ = 0;
  std::unique_ptr<std::uint16_t[]> in_bricks_;  // for each sphere, in how many bricks it is remembered
  std::size_t remembered_ = 0;
  // Work space for a brick in the making.
  static constexpr std::size_t kMaxGathered = 4096;
  struct Near {
    Vec3 centre;
    double radius;
    std::int32_t index;
  };
  std::unique_ptr<Near[]> gathered_, close_;
  std::unique_ptr<double[]> distance_;
};

}  // namespace moltact
