#include "engine/servo/servo_step.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {
namespace {

// The springs' own, cut to the greatest force.
Wrench unguarded(const WantedWrench& wanted) {
  const double size = glm::length(wanted.force_N);
  if (!wanted.on || !std::isfinite(size)) return {};
  return {{size > wanted.most_N ? wanted.force_N * (wanted.most_N / size) : wanted.force_N}, wanted.torque_N_mm};
}

// What an answer stretches and stores, in the device's space.
Springs springsOf(const Response& response, double A_per_mm) {
  return {.stretch_mm = glm::length(response.contact.displacement_A) / A_per_mm,
          .torque_mm2 = glm::length(response.torque_A2) / (A_per_mm * A_per_mm),
          .energy_mm2 = response.contact.energy_A2 / (A_per_mm * A_per_mm)};
}

}  // namespace

ServoSample ServoStep::tick(const ServoSettings& settings, Interaction* interaction, const DevicePose& pose,
                            const TickTime& time, const MotionPhase& phase) noexcept {
  ServoSample out;
  out.tick = tick_++;
  out.time_s = double(out.tick) * kTick_s;
  const bool lost = guarded_ && safety_.beginTick(pose, time);
  // A hand that was placed elsewhere, or jumped, starts from where it is.
  if (lost || settings.discontinuities != discontinuities_ || pose.discontinuities != hand_discontinuities_)
    clutch_.restart();
  out.hand = clutch_.place(pose, settings.clutch, workspace_mm_, push_, kTick_s);
  out.buttons = pose.buttons;
  const PoseA at = settings.workspace.toMolecule(out.hand, pose.orientation);
  out.hip = at.place;
  out.orientation = at.orientation;
  out.has_interaction = interaction != nullptr;
  out.discontinuities = settings.discontinuities;

  // A new interaction comes as its maker left it: one that was led to the hand keeps the contact over a change of
  // method.
  out.placed = std::exchange(other_device_, false) || lost || settings.discontinuities != discontinuities_ ||
               pose.discontinuities != hand_discontinuities_;
  const bool changed = interaction != last_interaction_ || out.placed;
  if (interaction && out.placed) interaction->reset();
  last_interaction_ = interaction;
  discontinuities_ = settings.discontinuities;
  hand_discontinuities_ = pose.discontinuities;
  // At another scale the same displacement gives another force.
  const bool rescaled = std::exchange(A_per_mm_, settings.workspace.A_per_mm) != settings.workspace.A_per_mm;
  if (changed || rescaled) safety_.restart();
  safety_.stop(settings.panic);

  WantedWrench wanted{.on = false};
  push_ = Vec3(0.0);
  if (interaction) {
    // First the surface moves under a hand at rest, then the hand: what the springs take up in the first of these
    // is the surface's work, and none that the hand or the loop does.
    const bool carried = moveSurface(settings, *interaction, phase, changed) && !changed && !rescaled;
    const Springs before = carried ? springsOf(interaction->respond(last_at_), settings.workspace.A_per_mm) : Springs{};
    out.probe_A = interaction->probe_A();
    const Response response = interaction->respond(at);
    out.contact = response.contact;
    out.memory_usage = interaction->memoryUsage();
    wanted = feel(settings, response, interaction->parallelSprings());
    if (carried) wanted.before = before;
    last_at_ = at;
    if (phase.motion) out.motion = phase.motion->serial(), out.fraction = phase.fraction;
  }
  const Wrench given = guarded_ ? safety_.output(wanted) : unguarded(wanted);
  out.force = given.force;
  out.torque_N_mm = given.torque_N_mm;
  out.limits = safety_.acted();
  out.stiffness_bound_N_per_mm = safety_.stiffnessBound_N_per_mm();
  return out;
}

// Moves the surface to its state in this tick; false where it is at rest.
bool ServoStep::moveSurface(const ServoSettings& settings, Interaction& interaction, const MotionPhase& phase,
                            bool changed) noexcept {
  bool moved = false;
  // It swells or shrinks by a little each tick, so that it carries the finger instead of striking it.
  if (std::isfinite(settings.probe_A)) {
    const double goal = std::clamp(settings.probe_A, 0.0, kLargestProbe_A);
    const double now = interaction.probe_A(), most = kProbeSlew_A_per_s * kTick_s;
    if (goal != now) {
      interaction.setProbe(changed ? goal : now + std::clamp(goal - now, -most, most));
      moved = now > 0.0 || interaction.probe_A() > 0.0;  // a body has none
    }
  }
  const std::uint64_t serial = phase.motion ? phase.motion->serial() : 0;
  const bool other = serial != std::exchange(last_motion_, serial),
             further = phase.fraction != std::exchange(last_fraction_, phase.fraction);
  if ((other || (serial && (further || changed))) && interaction.setMotion(phase.motion)) {
    if (phase.motion) interaction.advanceTo(phase.fraction);
    moved = true;
  }
  return moved;
}

WantedWrench ServoStep::feel(const ServoSettings& settings, const Response& response, double parallel) noexcept {
  const Contact& contact = response.contact;
  WantedWrench wanted{.most_N = settings.max_force_N,
                      .on = settings.force_on && !clutch_.held() && contact.fault == Fault::None};
  if (!response.felt()) return wanted;
  wanted.stiffness_N_per_mm =
      guarded_ ? safety_.stiffness(settings.stiffness_N_per_mm, parallel) : settings.stiffness_N_per_mm;
  wanted.force_N = settings.workspace.spring(contact.displacement_A, wanted.stiffness_N_per_mm).N;
  wanted.torque_N_mm = settings.workspace.torque_N_mm(response.torque_A2, wanted.stiffness_N_per_mm);
  if (const double size = glm::length(wanted.force_N); size > 0.0 && std::isfinite(size)) push_ = wanted.force_N / size;
  wanted.springs = springsOf(response, settings.workspace.A_per_mm);
  return wanted;
}

}  // namespace moltact
