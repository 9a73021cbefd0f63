#include "engine/bench/closed_loop.h"

#include <cmath>
#include <limits>

namespace moltact::bench {

ForceN springForce(const LoopSettings& settings, PointA hip, const Contact& contact, double max_N) {
  if (!contact.touching()) return {};
  ForceN force = settings.workspace.spring(hip, springEnd(contact, hip), settings.stiffness_N_per_mm);
  const double size = glm::length(force.N);
  if (!std::isfinite(size)) return {};
  if (size > max_N) force.N *= max_N / size;
  return force;
}

ClosedLoop::ClosedLoop(const LoopSettings& settings, PointA start)
    : settings_(settings),
      device_(settings.device, settings.hand, settings.workspace.toDevice(start)),
      place_mm_(device_.position().mm) {
  observer_.release();
}

LoopTick ClosedLoop::tick(Tracker& tracker, PointA target, TickKind kind) {
  LoopTick out;
  out.hip = settings_.workspace.toMolecule(device_.sensed());
  const ForceN before = command_;
  if (kind == TickKind::Lost) {
    out.stepped = false;
  } else {
    PointA given = out.hip;
    if (kind == TickKind::NotANumber) given.A.x = std::numeric_limits<double>::quiet_NaN();
    if (kind == TickKind::Doubled) tracker.step(given);
    last_ = tracker.step(given);
    command_ = springForce(settings_, out.hip, last_, settings_.device.max_force_N);
  }
  out.contact = last_;
  out.force = command_;
  device_.tick(kind == TickKind::Late ? before : command_, settings_.workspace.toDevice(target));

  const double k = 1e3 * settings_.stiffness_N_per_mm;
  const Vec3 here = device_.position().mm;
  const Vec3 moved_m = 1e-3 * (here - place_mm_);
  observer_.add(device_.held().N, moved_m, !last_.touching() && device_.held().N == Vec3(0));

  // The held force is that of a place as far off as the device has moved since it was read, and of the
  // rounding.
  recent_m_.push_back(glm::length(moved_m));
  if (recent_m_.size() > static_cast<std::size_t>(settings_.device.delay_ticks) + 1) recent_m_.erase(recent_m_.begin());
  double off_m = 0.87e-3 * settings_.device.resolution_mm;
  for (const double m : recent_m_) off_m += m;
  if (out.contact.touching() || glm::length(device_.held().N) > 0) sampling_ += k * off_m * glm::length(moved_m);
  place_mm_ = here;
  return out;
}

}  // namespace moltact::bench
