// The cones and intersection points of an atom, which the paper prepares for every atom of the molecule (sections 4.4
// and 4.5). Here they are computed when an atom is first touched, in a fixed pool that replaces the least recently
// touched atom. Used by one thread; no allocation after construction. Units: angstrom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/haptics/paper/cone.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact::paper {

/// A point at which an atom's sphere meets two others.
struct ModelPoint {
  Vec3 P{0.0};
  std::int32_t second = -1, third = -1;  ///< the other two atoms
};

struct AtomModel {
  std::int32_t atom = -1;
  std::span<const Cone> cones;         ///< ordered by depth of the cut, deepest first
  std::span<const ModelPoint> points;  ///< in the order of their cones, including buried ones
};

/// Limits of one model. With the water probe, atoms as dense as the heavy atoms of a protein (0.057 per cubic angstrom,
/// placed at random) have about 50 cones and 950 points each. Atoms twice as dense have 94 and 3200. Beyond a limit the
/// shallowest cones and the points of the later pairs of cones are omitted; the tracker then does not stop at those
/// circles and points.
inline constexpr std::size_t kMaxCones = 128;
inline constexpr std::size_t kMaxPoints = 4096;

/// Number of atoms held at once. It exceeds the number that usually meets in a pit, so that a HIP at rest there causes
/// no new preparation.
inline constexpr std::size_t kModels = 16;

class AtomModels {
 public:
  explicit AtomModels(const SphereGrid& scene);

  /// The model of an atom with spheres inflated by probe_A; computed now if it is not held.
  AtomModel model(const SphereGrid& scene, std::int32_t atom, double probe_A) noexcept;

  /// Discards all models, after a change of the probe.
  void clear() noexcept;

  std::size_t held() const noexcept;
  std::size_t bytes() const noexcept;

 private:
  struct Slot {
    std::int32_t atom = -1;
    std::uint64_t used = 0;
    std::size_t cones = 0, points = 0;
  };
  void prepare(const SphereGrid& scene, std::size_t slot, std::int32_t atom, double probe_A) noexcept;

  std::size_t cones_each_, points_each_;
  std::vector<Slot> slots_;
  std::vector<Cone> cones_;
  std::vector<ModelPoint> points_;
  std::uint64_t clock_ = 0;
};

}  // namespace moltact::paper
