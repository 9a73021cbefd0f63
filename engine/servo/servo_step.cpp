#include "engine/servo/servo_step.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace moltact {
namespace {

// The force of the springs alone, clamped to the limit.
Wrench unguarded(const WantedWrench& wanted) {
  const double size = glm::length(wanted.force_N);
  if (!wanted.on || !std::isfinite(size)) return {};
  return {{size > wanted.max_N ? wanted.force_N * (wanted.max_N / size) : wanted.force_N}, wanted.torque_N_mm};
}

// The stretch and energy of a response's contact springs, in the device's space.
Springs springsOf(const Response& response, double A_per_mm) {
  return {.stretch_mm = glm::length(response.contact.displacement_A) / A_per_mm,
          .torque_mm2 = glm::length(response.torque_A2) / (A_per_mm * A_per_mm),
          .energy_mm2 = response.contact.energy_A2 / (A_per_mm * A_per_mm)};
}

// Force and torque of a response in the device's space, with the given stiffness of springs and share of the field.
struct Pull {
  Vec3 force_N{0.0}, torque_N_mm{0.0};
};
Pull pullOf(const Response& response, const Workspace& workspace, double stiffness_N_per_mm, double field_share) {
  Pull out{workspace.spring(response.contact.displacement_A, stiffness_N_per_mm).N,
           workspace.torque_N_mm(response.torque_A2, stiffness_N_per_mm)};
  if (response.field) {
    const DeviceForce field = inDevice(*response.field, workspace);
    out.force_N += field_share * field.force_N;
    out.torque_N_mm += field_share * field.torque_N_mm;
  }
  return out;
}

void store(const Response& response, const Workspace& workspace, const Pull& pull, Stored& out) {
  out.springs = springsOf(response, workspace.A_per_mm);
  if (!response.field) return;
  const DeviceForce field = inDevice(*response.field, workspace);
  out.field = true;
  out.field_energy_N_mm = field.energy_N_mm;
  out.field_stiffness_N_per_mm = field.stiffness_N_per_mm;
  out.force_N = glm::length(pull.force_N);
  out.torque_N_mm = glm::length(pull.torque_N_mm);
}

}  // namespace

ServoSample ServoStep::tick(const ServoSettings& settings, Interaction* interaction, const DevicePose& pose,
                            const TickTime& time, const MotionPhase& phase, Reactions* reactions) noexcept {
  ServoSample out;
  out.tick = tick_++;
  out.time_s = double(out.tick) * kTick_s;
  const bool lost = guarded_ && safety_.beginTick(pose, time);
  // A hand that was placed elsewhere or jumped restarts from its position.
  if (lost || pose.discontinuities != hand_discontinuities_)
    clutch_.forget();
  else if (settings.discontinuities != discontinuities_)
    clutch_.restart();
  out.hand = clutch_.place(pose, settings.clutch, workspace_mm_, push_, kTick_s);
  out.buttons = pose.buttons;
  const PoseA at = settings.workspace.toMolecule(out.hand, clutch_.orient(pose.orientation));
  out.hip = at.place;
  out.orientation = at.orientation;
  out.has_interaction = interaction != nullptr;
  out.holds_body = interaction && interaction->hasOrientation();
  out.discontinuities = settings.discontinuities;

  // A new interaction keeps the state in which it was handed over: one that was led to the hand keeps the contact over
  // a change of method.
  out.contact_reset = std::exchange(other_device_, false) || lost || settings.discontinuities != discontinuities_ ||
                      pose.discontinuities != hand_discontinuities_;
  const bool changed = interaction != last_interaction_ || out.contact_reset;
  if (interaction && out.contact_reset) interaction->reset();
  last_interaction_ = interaction;
  discontinuities_ = settings.discontinuities;
  hand_discontinuities_ = pose.discontinuities;
  // With another scale the same displacement gives another force.
  const bool rescaled = std::exchange(A_per_mm_, settings.workspace.A_per_mm) != settings.workspace.A_per_mm;
  if (changed || rescaled) safety_.restart();
  safety_.stop(settings.panic);

  WantedWrench wanted{.on = false};
  Stored before;
  if (reactions) reactions->tick = out.tick, reactions->count = 0;
  push_ = Vec3(0.0);
  if (interaction) {
    // First the surface moves with the hand at rest, then the hand. Energy stored in the first step is the work of the
    // surface, not of the hand or the loop.
    const bool carried = moveSurface(settings, *interaction, phase, changed) && !changed && !rescaled;
    if (carried) respondBefore(settings.workspace, *interaction, before);
    setSurface(settings.surface, *interaction, changed);
    out.probe_A = interaction->probe_A();
    out.surface = interaction->surface();
    const Response response = interaction->respond(at);
    out.contact = response.contact;
    out.memory_usage = interaction->memoryUsage();
    feel(settings, response, wanted);
    const double k = wanted.stiffness_N_per_mm, share = safety_.fieldShare();
    if (carried) wanted.before = &before;
    out.torque_A2 = response.torque_A2;
    out.stiffness_factor = response.stiffness_factor;
    out.spring_N_per_A = k / settings.workspace.A_per_mm;
    out.field_share = share;
    if (response.field) out.field = response.field;
    if (response.body_pose) out.body_pose = response.body_pose;
    out.at_rest = response.at_rest;
    if (response.molecular_energy) out.molecular_energy = response.molecular_energy;
    if (reactions && wanted.on && response.acts())
      reactions->count = interaction->reactions(response, k / settings.workspace.A_per_mm, share, reactions->room);
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

// Moves the surface to its state in this tick; returns false if it is at rest.
bool ServoStep::moveSurface(const ServoSettings& settings, Interaction& interaction, const MotionPhase& phase,
                            bool changed) noexcept {
  bool moved = false;
  // The probe grows or shrinks a little in each tick, so that the surface carries the finger instead of striking it.
  if (std::isfinite(settings.probe_A)) {
    const double goal = std::clamp(settings.probe_A, 0.0, kMaxProbe_A);
    const double now = interaction.probe_A(), limit = kProbeSlew_A_per_s * kTick_s;
    if (goal != now) {
      interaction.setProbe(changed ? goal : now + std::clamp(goal - now, -limit, limit));
      moved = now > 0.0 || interaction.probe_A() > 0.0;  // a body has no probe
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

// A new interaction has the new properties at once.
void ServoStep::setSurface(const SurfaceProperties& goal, Interaction& interaction, bool changed) noexcept {
  const SurfaceProperties now = interaction.surface();
  const double dt_s = changed ? std::numeric_limits<double>::infinity() : kTick_s;
  if (const SurfaceProperties next = surfaceTowards(now, goal, dt_s); next != now) interaction.setSurface(next);
}

// The stored energy after the motion of the surface, with the hand still at its last pose. The stiffness of this tick
// is not known yet, so the sizes use that of the last tick, like its own stored energy.
void ServoStep::respondBefore(const Workspace& workspace, Interaction& interaction, Stored& before) noexcept {
  const Response moved = interaction.respond(last_at_);
  const Pull pull = pullOf(moved, workspace, safety_.stiffnessInForce_N_per_mm(), safety_.fieldShare());
  store(moved, workspace, pull, before);
}

void ServoStep::feel(const ServoSettings& settings, const Response& response, WantedWrench& wanted) noexcept {
  const Contact& contact = response.contact;
  const Workspace& workspace = settings.workspace;
  wanted.max_N = settings.max_force_N;
  wanted.on = settings.force_on && !clutch_.held() && contact.fault == Fault::None;
  if (!response.acts()) return;
  wanted.stiffness_N_per_mm = settings.stiffness_N_per_mm;
  double field_share = 1.0;
  if (guarded_) {
    LocalStiffness felt{.stiffness_factor = response.stiffness_factor};
    if (response.rotational_A2 != 0.0)
      felt.rotational_mm2 = response.rotational_A2 / (workspace.A_per_mm * workspace.A_per_mm);
    if (response.field) {
      felt.field = true;
      const DeviceForce field = inDevice(*response.field, workspace);
      felt.field_N_per_mm = field.stiffness_N_per_mm;
      felt.field_rotational_N_mm = field.rotational_stiffness_N_mm;
    }
    wanted.stiffness_N_per_mm = safety_.stiffness(settings.stiffness_N_per_mm, felt);
    field_share = safety_.fieldShare();
  }
  const Pull pull = pullOf(response, workspace, wanted.stiffness_N_per_mm, field_share);
  wanted.force_N = pull.force_N;
  wanted.torque_N_mm = pull.torque_N_mm;
  if (const double size = glm::length(wanted.force_N); size > 0.0 && std::isfinite(size)) push_ = wanted.force_N / size;
  store(response, workspace, pull, wanted.stored);
}

}  // namespace moltact
