#include "engine/servo/servo_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {

ServoSample ServoStep::tick(const ServoSettings& settings, Tracker* tracker, const DevicePose& pose,
                            const TickTime& time) noexcept {
  ServoSample out;
  out.tick = tick_++;
  out.time_s = double(out.tick) * kTick_s;
  const bool lost = safety_.beginTick(pose, time);
  // A hand that is placed anew, or leapt, is where it is.
  if (lost || settings.discontinuities != discontinuities_ || pose.discontinuities != hand_discontinuities_)
    clutch_.restart();
  out.hand = clutch_.place(pose, settings.clutch, workspace_mm_, push_, kTick_s);
  out.buttons = pose.buttons;
  out.hip = settings.workspace.toMolecule(out.hand);
  out.has_tracker = tracker != nullptr;
  out.discontinuities = settings.discontinuities;

  // A new tracker comes as its maker left it: one that was led to the hand keeps the contact over a change of method.
  out.placed = std::exchange(other_device_, false) || lost || settings.discontinuities != discontinuities_ ||
               pose.discontinuities != hand_discontinuities_;
  const bool changed = tracker != last_tracker_ || out.placed;
  if (tracker && out.placed) tracker->reset();
  last_tracker_ = tracker;
  discontinuities_ = settings.discontinuities;
  hand_discontinuities_ = pose.discontinuities;
  // At another scale the same way in gives another force.
  const bool rescaled = std::exchange(A_per_mm_, settings.workspace.A_per_mm) != settings.workspace.A_per_mm;
  if (changed || rescaled) safety_.restart();
  safety_.stop(settings.panic);

  WantedForce wanted{.on = false};
  push_ = Vec3(0.0);
  if (tracker) {
    // The surface swells or shrinks by a little each tick, so that it carries the finger instead of striking it.
    if (std::isfinite(settings.probe_A)) {
      const double goal = std::clamp(settings.probe_A, 0.0, kLargestProbe_A);
      const double now = tracker->probe_A(), most = kProbeSlew_A_per_s * kTick_s;
      if (goal != now) tracker->setProbe(changed ? goal : now + std::clamp(goal - now, -most, most));
    }
    out.probe_A = tracker->probe_A();
    out.contact = tracker->step(out.hip);
    out.memory_usage = tracker->memoryUsage();
    wanted = feel(settings, out);
  }
  out.force = safety_.output(wanted);
  out.limits = safety_.acted();
  out.stiffness_bound_N_per_mm = safety_.stiffnessBound_N_per_mm();
  return out;
}

WantedForce ServoStep::feel(const ServoSettings& settings, const ServoSample& sample) noexcept {
  const Contact& contact = sample.contact;
  WantedForce wanted{.most_N = settings.max_force_N,
                     .on = settings.force_on && !clutch_.held() && contact.fault == Fault::None};
  if (!contact.touching()) return wanted;
  wanted.stiffness_N_per_mm = safety_.stiffness(settings.stiffness_N_per_mm);
  wanted.force_N = settings.workspace.spring(sample.hip, springEnd(contact, sample.hip), wanted.stiffness_N_per_mm).N;
  if (const double size = glm::length(wanted.force_N); size > 0.0 && std::isfinite(size)) push_ = wanted.force_N / size;
  wanted.stretch_mm = glm::distance(contact.scp.A, sample.hip.A) / settings.workspace.A_per_mm;
  return wanted;
}

}  // namespace moltact
