#include "engine/haptics/paper/atom_models.h"

#include <algorithm>

#include "engine/haptics/paper/intersection_point.h"

namespace moltact::paper {

AtomModels::AtomModels(const SphereGrid& scene) {
  const std::size_t others = std::min(scene.size() - std::min<std::size_t>(scene.size(), 1), kMaxCones);
  cones_each_ = others;
  points_each_ = std::min(others * (others - std::min<std::size_t>(others, 1)), kMaxPoints);  // two points per pair
  slots_.resize(std::min(scene.size(), kModels));
  cones_.resize(slots_.size() * cones_each_);
  points_.resize(slots_.size() * points_each_);
}

AtomModel AtomModels::model(const SphereGrid& scene, std::int32_t atom, double probe_A) noexcept {
  std::size_t slot = 0;
  for (std::size_t k = 0; k < slots_.size(); ++k) {
    if (slots_[k].atom == atom) {
      slot = k;
      break;
    }
    if (slots_[k].used < slots_[slot].used) slot = k;
  }
  if (slots_[slot].atom != atom) prepare(scene, slot, atom, probe_A);
  slots_[slot].used = ++clock_;
  return {atom,
          {cones_.data() + slot * cones_each_, slots_[slot].cones},
          {points_.data() + slot * points_each_, slots_[slot].points}};
}

void AtomModels::prepare(const SphereGrid& scene, std::size_t slot, std::int32_t atom, double probe_A) noexcept {
  const Sphere& own = scene[std::size_t(atom)];
  const double R = own.radius_A + probe_A;
  Cone* const cones = cones_.data() + slot * cones_each_;
  std::size_t count = 0;

  // Deeper cuts first; among equals the lower index, so that the order does not depend on the grid.
  const auto before = [](const Cone& a, const Cone& b) {
    return a.circle.height != b.circle.height ? a.circle.height < b.circle.height : a.neighbour < b.neighbour;
  };
  // A heap with the shallowest cut on top keeps the deepest kMaxCones of any number of neighbours.
  scene.visitNear(own.centre_A, R + probe_A, [&](std::uint32_t index, const Sphere& sphere) {
    if (std::int32_t(index) == atom) return;
    const auto circle = intersectionCircle(own.centre_A, R, sphere.centre_A, sphere.radius_A + probe_A);
    if (!circle) return;
    const Cone cone{*circle, own.centre_A, atom, std::int32_t(index)};
    if (count == cones_each_) {
      if (!before(cone, cones[0])) return;
      std::pop_heap(cones, cones + count, before);
      --count;
    }
    cones[count++] = cone;
    std::push_heap(cones, cones + count, before);
  });
  std::sort_heap(cones, cones + count, before);

  ModelPoint* const points = points_.data() + slot * points_each_;
  std::size_t point_count = 0;
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t i = 0; i < j && point_count + 2 <= points_each_; ++i) {
      const Sphere& second = scene[std::size_t(cones[i].neighbour)];
      const Sphere& third = scene[std::size_t(cones[j].neighbour)];
      const auto both = intersectionPoints(cones[i].circle, third.centre_A, third.radius_A + probe_A);
      if (!both) continue;
      // A point requires three circles. Two spheres that only touch have none, whatever rounding gives for their single
      // common point.
      if (!intersectionCircle(second.centre_A, second.radius_A + probe_A, third.centre_A, third.radius_A + probe_A))
        continue;
      points[point_count++] = {both->P0, cones[i].neighbour, cones[j].neighbour};
      points[point_count++] = {both->P1, cones[i].neighbour, cones[j].neighbour};
    }
  slots_[slot] = {atom, 0, count, point_count};
}

void AtomModels::clear() noexcept {
  for (Slot& s : slots_) s = {};
}

std::size_t AtomModels::held() const noexcept {
  return std::size_t(std::count_if(slots_.begin(), slots_.end(), [](const Slot& s) { return s.atom >= 0; }));
}

std::size_t AtomModels::bytes() const noexcept {
  return slots_.capacity() * sizeof(Slot) + cones_.capacity() * sizeof(Cone) + points_.capacity() * sizeof(ModelPoint);
}

}  // namespace moltact::paper
