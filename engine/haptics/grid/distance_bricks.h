// The signed distance to the spheres' surfaces, interpolated smoothly on a grid. The grid is divided into bricks of 4 x
// 4 x 4 cells, which are computed when first needed. A pool of fixed size keeps kBricks of them and replaces the
// oldest.
//
// The field is f(x) = min over spheres of |x - centre| - radius, without inflation. A probe of radius p touches the
// level f = p, so a change of probe needs no new bricks. Outside all spheres f is the distance. Inside it is only a
// bound, which is sufficient because the SCP stays outside.
//
// Interpolation: quadratic B-splines over coefficients c = f - (1/8) (second differences of f along each axis), which
// reproduce quadratics exactly. Where f is smooth the error is of third order in the spacing. The gradient is
// continuous, and creases are rounded over about one spacing.
//
// Haptic thread; no allocation after construction except in prepare(). Units: angstrom; positions are relative to the
// given origin.
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
  static constexpr int kLabels = 24;              ///< spheres stored per brick to identify the nearest

  /// `cap_A`: the largest level that is queried; points farther from the surface may get this value instead of their
  /// distance.
  DistanceBricks(std::shared_ptr<const SphereGrid> scene, const Vec3& origin, double spacing_A, double cap_A);

  /// Computes all bricks at or near the surface of this level and enlarges the pool to twice as many, so that no brick
  /// is computed during touch. Call before touching; allocates.
  void prepare(double level_A);

  struct Sample {
    double value;  ///< the field
    Vec3 gradient;
    glm::dmat3 hessian;  ///< second derivatives, continuous only within a cell
  };

  /// Evaluates the field. Computes a missing brick if `fills_left` allows it; otherwise returns false and leaves `out`
  /// unchanged.
  bool sample(const Vec3& place, Sample& out, int& fills_left) noexcept;

  /// The sphere whose surface is nearest to the point, among those stored in its brick; -1 if the brick is missing.
  std::int32_t nearestSphere(const Vec3& place) const noexcept;

  /// Changes the cap. A larger cap discards all bricks.
  void setCap(double cap_A) noexcept;
  double spacing_A() const noexcept { return spacing_; }

  std::uint64_t bricksMade() const noexcept { return made_; }             ///< since construction
  std::size_t spheresRemembered() const noexcept { return remembered_; }  ///< distinct spheres in all stored bricks
  std::size_t bytes() const noexcept;
  /// The memory that a grid over the scene's whole bounding box would need at this spacing (unit: byte).
  std::size_t wholeMoleculeBytes() const noexcept;

 private:
  static constexpr int kSide = kCells + 2;     // coefficients along an edge
  static constexpr int kSamples = kCells + 4;  // distances along an edge, from which the coefficients are computed
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
  std::unique_ptr<std::uint16_t[]> in_bricks_;  // for each sphere, the number of bricks that store it
  std::size_t remembered_ = 0;
  // Scratch memory for the brick being computed.
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
