// The servo loop without its clock: everything that a tick does, and everything that crosses to and from it. The caller
// of tick() supplies the time: the haptic thread the wall clock (servo_thread.h); the window's frames and tests a
// virtual one. Values cross whole and without locks. Units: nanosecond, second.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/sample_ring.h"
#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/haptics/interaction.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class ServoLoop {
 public:
  static constexpr std::int64_t kPeriod_ns = 1'000'000;

  /// `fallback` is read while no other device is chosen or the chosen one is gone; it must outlive the loop.
  explicit ServoLoop(Device& fallback);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  // For the owner, at any time; none blocks.

  void setSettings(const ServoSettings& settings) noexcept {
    settings_.write(settings);
    heartbeat_.fetch_add(1, std::memory_order_relaxed);
  }
  /// From now on the owner hands settings over at least every kWatchdog_s. While it does not, the loop cannot hear the
  /// panic key either, and gives no force.
  void expectSettings() noexcept { expects_.store(true, std::memory_order_relaxed); }
  static constexpr double kWatchdog_s = 1.0;

  /// Hands over the interaction of a scene (null: nothing is felt) with the scene's number, which every sample of it
  /// carries. Settings set before this call are in force when the interaction is first asked. The old interaction comes
  /// back and is destroyed here, never in a tick.
  void setInteraction(std::unique_ptr<Interaction> interaction, std::uint32_t scene = 0);

  /// Hands over the next motion of that scene's spheres (engine/haptics/sphere_motion.h). It begins as soon as the one
  /// before has ended; when it has ended itself it stays until another comes. False, and nothing is handed over, while
  /// the one before still waits to begin: try again a picture later. Never null. A motion in a scene that is not felt
  /// yet waits for that scene.
  bool setMotion(std::shared_ptr<const SphereMotion> motion, std::uint32_t scene = 0);

  /// It is felt how the hand is oriented: a rotation on the device rotates the hand, and not the view.
  bool hasOrientation() const noexcept { return has_orientation_; }

  /// The chosen device, for its info() and status(); null where none is.
  Device* device() const noexcept { return chosen_.get(); }
  /// Whether the fallback, at the newest tick, replaces a chosen device that is gone.
  bool fallenBack() const noexcept { return fallen_back_.load(std::memory_order_relaxed); }

  /// While true, ramps the force down along the slew and gives none: a device is put away, or the program ends.
  void rampDownForce(bool on) noexcept { ramp_down_force_.store(on || ramp_down_for_good_, std::memory_order_release); }
  /// Ramps the force down for good.
  void endForce() noexcept {
    ramp_down_for_good_ = true;
    rampDownForce(true);
  }
  /// Ramps the force down and calls pass(), which lets a period's tick go by, until two ticks in a row gave none (the
  /// first of them may have begun before); at most kRelease_ms times.
  template <class Pass>
  void release(Pass&& pass) {
    rampDownForce(true);
    for (int k = 0, none = 0; chosen_ && none < 2 && k < kRelease_ms; ++k) {
      pass();
      none = gives() ? 0 : none + 1;
    }
  }
  static constexpr int kRelease_ms = 50;
  /// Whether the newest tick gave the chosen device any force.
  bool gives() const noexcept { return gives_.load(std::memory_order_acquire); }

  /// While true, each tick also works out the reactions on the atoms of the scene, for whoever moves these.
  void wantReactions(bool on) noexcept { wants_reactions_.store(on, std::memory_order_relaxed); }
  /// Those of the newest tick with the newest interaction that was handed over; none before that tick. The reference
  /// holds until the next call, or the next interaction.
  const Reactions& reactions() noexcept { return reactions_ ? reactions_->read() : no_reactions_; }

  /// The newest tick.
  const ServoSample& latest() noexcept { return latest_.read(); }
  /// Calls take(sample) for every tick since the last call, oldest first (the last 4 s at most). Call it each frame: it
  /// also destroys the objects that the ticks have returned.
  template <class Take>
  void drain(Take&& take) {
    collect();
    ServoSample sample;
    while (samples_.pop(sample)) take(sample);
  }

  /// Calls take(tick) for each recorded tick since the last call (the last 4 s at most), and sets `start` to the state
  /// from which the first began.
  template <class Take>
  void drainRecording(ServoStep& start, Take&& take) {
    RecordedTick tick;
    while (recording_ && recording_->ring.pop(tick)) {
      start = recording_->start;
      take(tick);
    }
  }
  /// Ticks that were not recorded because nobody drained them in time.
  std::size_t lostOfRecording() const { return recording_ ? recording_->ring.dropped() : 0; }

  // For the owner, while nobody ticks.

  /// The first tick from now on is due a period after `now_ns`; it treats its device as another one.
  void begin(std::int64_t now_ns) noexcept;
  /// Gives no force to the chosen device and the fallback, as the last act.
  void end() noexcept;
  /// Between end() and begin(): sets the device to be used from then on, null for the fallback. Closes the old one.
  void setDevice(std::unique_ptr<Device> device);
  /// Between end() and begin(): records every tick with all its inputs, from the tick in which the next interaction is
  /// handed over, until false.
  void record(bool on);

  // For the caller that ticks, one at a time.

  /// Performs one tick that began at `began_ns` and was due at `due_ns`; without a due time it was due a period after
  /// the last, as a device's own clock counts. `now` is the clock that measures how long the tick takes, which the next
  /// tick uses; null where ticks take no time. A second tick at the same time, from two clocks of which one takes over
  /// from the other, is ignored.
  void tick(std::int64_t began_ns, std::optional<std::int64_t> due_ns, std::int64_t (*now)()) noexcept;

 private:
  ServoSettings watchedSettings(double dt_s) noexcept;
  MotionPhase nextMotion() noexcept;
  void putDownMotion() noexcept;
  void collect();

  Device& fallback_;
  std::unique_ptr<Device> chosen_;
  TripleBuffer<ServoSettings> settings_;
  std::atomic<std::uint32_t> heartbeat_{0};  // how often settings were handed over
  std::atomic<bool> expects_{false};
  TripleBuffer<ServoSample> latest_;
  SampleRing<ServoSample, 4096> samples_;
  // An interaction that crosses, with its scene's number; null inside: nothing is to be felt.
  struct HandedInteraction {
    std::unique_ptr<Interaction> interaction;
    std::uint32_t scene = 0;
    std::shared_ptr<TripleBuffer<Reactions>> reactions;  // null without an interaction
  };
  std::atomic<HandedInteraction*> pending_{nullptr};  // the next
  std::atomic<HandedInteraction*> retired_{nullptr};  // one that a tick has put down
  HandedInteraction* current_ = nullptr;              // the ticks'
  // A motion that crosses, with its scene's number.
  struct HandedMotion {
    std::shared_ptr<const SphereMotion> motion;
    std::uint32_t scene = 0;
  };
  std::atomic<HandedMotion*> pending_motion_{nullptr}, retired_motion_{nullptr};  // as above
  std::uint32_t pending_motions_scene_ = 0;                                       // the owner's
  HandedMotion* motion_ = nullptr;                                                // the ticks': the one in force
  HandedMotion* next_motion_ = nullptr;                                           // the ticks': waits for its scene
  HandedMotion* last_motion_ = nullptr;  // the ticks': put down in this tick, in which what is felt may still ask it
  int motion_tick_ = 0;                  // of the one in force
  struct Recording {
    SampleRing<RecordedTick, 4096> ring;
    ServoStep start;       // written before the first tick is pushed
    bool begun = false;    // the ticks': what it is to begin with is there
    bool started = false;  // the ticks': the state at the first one is kept
  };
  std::unique_ptr<Recording> recording_;
  bool records_ = false;  // changed only while nobody ticks
  std::atomic<bool> fallen_back_{false};
  std::atomic<bool> ramp_down_force_{false};
  bool ramp_down_for_good_ = false, has_orientation_ = false;  // the owner's
  std::atomic<bool> gives_{false};
  std::atomic<bool> wants_reactions_{false};
  std::shared_ptr<TripleBuffer<Reactions>> reactions_;  // the owner's end of the newest interaction's
  Reactions no_reactions_;
  // A tick's own, taken by whoever ticks.
  std::atomic_flag ticking_ = ATOMIC_FLAG_INIT;
  ServoStep step_;
  std::optional<DeviceSwitch> switch_;
  TickTime time_;
  std::uint32_t last_heartbeat_ = 0;
  double silent_s_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace moltact
