#include "engine/servo/servo_loop.h"

#include <algorithm>
#include <utility>

#include "engine/platform/force_inhibit.h"

namespace moltact {

ServoLoop::ServoLoop(Device& fallback) : fallback_(fallback), step_(fallback.info()) {}

ServoLoop::~ServoLoop() {
  collect();
  delete pending_.exchange(nullptr);
  delete current_;
  delete pending_motion_.exchange(nullptr);
  delete motion_;
  delete next_motion_;
}

// The step keeps its count, so that samples are numbered consecutively.
void ServoLoop::begin(std::int64_t now_ns) noexcept {
  switch_.emplace(fallback_, chosen_.get());
  time_ = {};
  last_ns_ = now_ns;
}

void ServoLoop::end() noexcept {
  if (chosen_) chosen_->stop();
  fallback_.write(ForceN{});
  rampDownForce(false);
}

void ServoLoop::setDevice(std::unique_ptr<Device> device) {
  switch_.reset();
  chosen_ = std::move(device);
  if (chosen_) chosen_->rotateHand(has_orientation_);
}

void ServoLoop::record(bool on) {
  if (on) recording_ = std::make_unique<Recording>();
  records_ = on;
}

void ServoLoop::setInteraction(std::unique_ptr<Interaction> interaction, std::uint32_t scene) {
  collect();
  has_orientation_ = interaction && interaction->hasOrientation();
  if (chosen_) chosen_->rotateHand(has_orientation_);
  reactions_ = nullptr;
  if (interaction) {
    Reactions room;
    room.room.resize(interaction->maxReactionCount());
    reactions_ = std::make_shared<TripleBuffer<Reactions>>(room);
  }
  auto next = std::unique_ptr<SceneInteraction>(
      new SceneInteraction{std::move(interaction), scene,
                           reactions_});  // without make_unique, which clang before 16 does not support for aggregates
  delete pending_.exchange(next.release(), std::memory_order_acq_rel);
}

bool ServoLoop::setMotion(std::shared_ptr<const SphereMotion> motion, std::uint32_t scene) {
  collect();
  if (pending_motions_scene_ == scene && pending_motion_.load(std::memory_order_acquire)) return false;
  pending_motions_scene_ = scene;
  auto next = std::unique_ptr<SceneMotion>(new SceneMotion{std::move(motion), scene});
  delete pending_motion_.exchange(next.release(), std::memory_order_acq_rel);
  return true;
}

void ServoLoop::collect() {
  delete retired_.exchange(nullptr, std::memory_order_acq_rel);
  delete retired_motion_.exchange(nullptr, std::memory_order_acq_rel);
}

// The motion phase of the active scene's spheres in this tick.
MotionPhase ServoLoop::nextMotion() noexcept {
  const auto isFelt = [this](const SceneMotion* motion) {
    return motion && current_ && motion->scene == current_->scene;
  };
  const bool ended = !isFelt(motion_) || motion_tick_ >= motion_->motion->ticks();
  // A motion is replaced only when its return slot is free, as for interactions.
  if (ended && !last_motion_ && !retired_motion_.load(std::memory_order_acquire)) {
    if (next_motion_ && !isFelt(next_motion_) && pending_motion_.load(std::memory_order_acquire))
      last_motion_ = std::exchange(next_motion_, nullptr);  // its scene never arrived
    if (!next_motion_) next_motion_ = pending_motion_.exchange(nullptr, std::memory_order_acq_rel);
    if (!last_motion_ && isFelt(next_motion_)) {
      last_motion_ = std::exchange(motion_, std::exchange(next_motion_, nullptr));
      motion_tick_ = 0;
    }
  }
  if (!isFelt(motion_)) return {};
  motion_tick_ = std::min(motion_tick_ + 1, motion_->motion->ticks());
  return {motion_->motion.get(), double(motion_tick_) / motion_->motion->ticks()};
}

// Called after the step, which may have used the motion for the last time.
void ServoLoop::putDownMotion() noexcept {
  if (last_motion_) retired_motion_.store(std::exchange(last_motion_, nullptr), std::memory_order_release);
}

// The newest settings, without force if their owner stalls or ramps it down, or if the process ends.
ServoSettings ServoLoop::watchedSettings(double dt_s) noexcept {
  ServoSettings settings = settings_.read();
  const std::uint32_t heartbeat = heartbeat_.load(std::memory_order_relaxed);
  silent_s_ = heartbeat != last_heartbeat_ ? 0.0 : silent_s_ + std::max(0.0, dt_s);
  last_heartbeat_ = heartbeat;
  if (expects_.load(std::memory_order_relaxed) && silent_s_ > kWatchdog_s) settings.force_on = false;
  if (ramp_down_force_.load(std::memory_order_acquire)) settings.force_on = false;
  if (forceInhibited()) settings.panic = true;
  return settings;
}

void ServoLoop::tick(std::int64_t began_ns, std::optional<std::int64_t> due_ns, std::int64_t (*now)()) noexcept {
  if (ticking_.test_and_set(std::memory_order_acquire)) return;

  // The next interaction is accepted only when the return slot for the old one is free, so that nothing is destroyed
  // here.
  if (pending_.load(std::memory_order_acquire) && !retired_.load(std::memory_order_acquire)) {
    SceneInteraction* next = pending_.exchange(nullptr, std::memory_order_acq_rel);
    if (current_) retired_.store(current_, std::memory_order_release);
    current_ = next;
    if (recording_) recording_->begun = true;
  }

  const std::int64_t late_ns = began_ns - due_ns.value_or(std::min(began_ns, last_ns_ + kPeriod_ns));
  time_.dt_s = double(began_ns - last_ns_) * 1e-9;
  last_ns_ = began_ns;
  const bool records = records_ && recording_->begun;
  if (records && !recording_->started) {
    step_.forgetInteraction();
    recording_->start = step_;
    recording_->started = true;
  }
  const ServoSettings settings = watchedSettings(time_.dt_s);
  const DevicePose pose = switch_->read(kTick_s, step_);
  const MotionPhase phase = nextMotion();
  const bool impulses = wants_impulses_.load(std::memory_order_relaxed);
  TripleBuffer<Reactions>* const reactions =
      current_ && (impulses || wants_reactions_.load(std::memory_order_relaxed)) ? current_->reactions.get() : nullptr;
  ServoSample sample = step_.tick(settings, current_ ? current_->interaction.get() : nullptr, pose, time_, phase,
                                  reactions ? &reactions->back() : nullptr);
  if (reactions) {
    if (impulses) impulses_.add(reactions->back().forces(), kTick_s, current_->scene);
    reactions->publish();
  }
  putDownMotion();
  const TickTime time_was = time_;
  sample.scene = current_ ? current_->scene : 0;
  switch_->write({sample.force, sample.torque_N_mm}, sample.limits.has(Limit::Panic));
  fallen_back_.store(switch_->fallenBack(), std::memory_order_relaxed);
  gives_.store(!switch_->fallenBack() && (sample.force.N != Vec3(0.0) || sample.torque_N_mm != Vec3(0.0)),
               std::memory_order_release);
  const std::int64_t work_ns = now ? now() - began_ns : 0;
  time_.delay_s = double(work_ns) * 1e-9;
  sample.work_us = float(work_ns) * 1e-3f;
  sample.late_us = float(late_ns) * 1e-3f;
  samples_.push(sample);
  if (records)
    recording_->ring.push({settings, pose, time_was, switch_->info(), switch_->other(), sample.force,
                           sample.torque_N_mm, sample.body_pose, sample.at_rest, 0, phase.motion ? motion_tick_ : 0,
                           switch_->fallenBack(), sample.contact.touching(), sample.limits,
                           phase.motion ? phase.motion->serial() : 0});
  ticking_.clear(std::memory_order_release);
}

}  // namespace moltact
