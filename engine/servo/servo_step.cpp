#include "engine/servo/servo_step.h"

#include <algorithm>
#include <cmath>

namespace moltact {
ServoSample ServoStep::tick(const ServoSettings& settings, Tracker* tracker, const DevicePose& pose) noexcept {
  ServoSample out;
  out.tick = tick_++;
  out.time_s = double(out.tick) * kTick_s;
  out.hand = pose.position;
  out.buttons = pose.buttons;
  out.hip = settings.workspace.toMolecule(pose.position);
  out.has_tracker = tracker != nullptr;
  out.placements = settings.placements;

  const bool placed = settings.placements != placements_ || pose.placements != hand_placements_;
  const bool changed = tracker != last_tracker_ || placed;
  // A new tracker comes as its maker left it: one that was led to the hand keeps the contact over a change of method.
  out.placed = placed;
  if (tracker && placed) tracker->reset();
  last_tracker_ = tracker;
  placements_ = settings.placements;
  hand_placements_ = pose.placements;
  if (changed || !tracker || !settings.force_on) ramp_ = 0.0;
  if (!tracker) return out;

  // The surface swells or shrinks by a little each tick, so that it carries the finger instead of striking it.
  if (std::isfinite(settings.probe_A)) {
    const double wanted = std::clamp(settings.probe_A, 0.0, kLargestProbe_A);
    const double now = tracker->probe_A(), most = kProbeSlew_A_per_s * kTick_s;
    if (wanted != now) tracker->setProbe(changed ? wanted : now + std::clamp(wanted - now, -most, most));
  }
  out.probe_A = tracker->probe_A();
  out.contact = tracker->step(out.hip);
  out.footprint = tracker->footprint();
  if (out.contact.fault != Fault::None) ramp_ = 0.0;
  if (!out.contact.touching() || !settings.force_on) {
    if (settings.force_on && out.contact.fault == Fault::None) ramp_ = std::min(1.0, ramp_ + kTick_s / kSoftStart_s);
    return out;
  }

  ramp_ = std::min(1.0, ramp_ + kTick_s / kSoftStart_s);
  const double stiffness = std::isfinite(settings.stiffness_N_per_mm) ? std::clamp(settings.stiffness_N_per_mm, 0.0, 5.0) : 0.0;
  Vec3 force = settings.workspace.spring(out.hip, springEnd(out.contact, out.hip), stiffness).N;
  const double size = glm::length(force);
  const double most = std::isfinite(settings.max_force_N) ? std::max(0.0, settings.max_force_N) : 0.0;
  if (!finite(force) || !std::isfinite(size)) force = Vec3(0.0);
  else if (size > most) force *= most / size;
  out.force.N = force * ramp_;
  return out;
}

}  // namespace moltact
