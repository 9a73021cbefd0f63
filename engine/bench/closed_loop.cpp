#include "engine/bench/closed_loop.h"

#include <cmath>
#include <limits>

#include "engine/device/simulated_device.h"

namespace moltact::bench {

ForceN springForce(const LoopSettings& settings, const Contact& contact, double max_N) {
  ForceN force = settings.workspace.spring(contact.displacement_A, settings.stiffness_N_per_mm);
  const double size = glm::length(force.N);
  if (!std::isfinite(size)) return {};
  if (size > max_N) force.N *= max_N / size;
  return force;
}

ClosedLoop::ClosedLoop(const LoopSettings& settings, PointA start)
    : figures_(settings.device),
      device_(settings.device, settings.hand, settings.workspace.toDevice(start)),
      step_(describe(settings.device)),
      place_mm_(device_.position().mm) {
  settings_.workspace = settings.workspace;
  settings_.stiffness_N_per_mm = settings.stiffness_N_per_mm;
  settings_.max_force_N = settings.device.max_force_N;
  observer_.release();
}

LoopTick ClosedLoop::tick(Interaction& interaction, PointA target, LoopFault fault, const MotionPhase& phase) {
  LoopTick out;
  const PointMm sensed = device_.sensed();
  out.hip = settings_.workspace.toMolecule(sensed);
  const ForceN before = command_;
  if (fault == LoopFault::Lost) {
    out.stepped = false;
  } else {
    DevicePose given{.position = sensed};
    if (fault == LoopFault::NotANumber) given.position.mm.x = std::numeric_limits<double>::quiet_NaN();
    settings_.probe_A = interaction.probe_A();  // a script changes it at once, without the limited rate
    if (fault == LoopFault::Doubled) step_.tick(settings_, &interaction, given, {}, phase);
    const ServoSample sample = step_.tick(settings_, &interaction, given, {}, phase);
    last_ = sample.contact;
    body_ = sample.shownBody();
    command_ = sample.force;
  }
  out.contact = last_;
  out.body = body_;
  out.force = command_;
  device_.tick(fault == LoopFault::Late ? before : command_, settings_.workspace.toDevice(target));

  const double k = 1e3 * settings_.stiffness_N_per_mm;
  const Vec3 here = device_.position().mm;
  const Vec3 moved_m = 1e-3 * (here - place_mm_);
  observer_.add(device_.held().N, moved_m, !last_.touching() && device_.held().N == Vec3(0));

  // The held force corresponds to a position that differs by the device's motion since the reading and by rounding.
  recent_m_.push_back(glm::length(moved_m));
  if (recent_m_.size() > static_cast<std::size_t>(figures_.delay_ticks) + 1) recent_m_.erase(recent_m_.begin());
  double off_m = 0.87e-3 * figures_.resolution_mm;
  for (const double m : recent_m_) off_m += m;
  if (out.contact.touching() || glm::length(device_.held().N) > 0) sampling_ += k * off_m * glm::length(moved_m);
  place_mm_ = here;
  return out;
}

}  // namespace moltact::bench
