// The servo loop without its clock: all work of a tick, and the data exchange with it. The caller of tick() supplies
// the time: the haptic thread the wall clock (servo_thread.h), the window's frames and tests a virtual one. Data are
// exchanged as complete values without locks. Units: nanosecond, second.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "engine/core/sample_ring.h"
#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/haptics/interaction.h"
#include "engine/servo/atom_impulses.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class ServoLoop {
 public:
  static constexpr std::int64_t kPeriod_ns = 1'000'000;

  /// `fallback` is read while no other device is chosen or the chosen one is disconnected; it must outlive the loop.
  explicit ServoLoop(Device& fallback);
  ~ServoLoop();
  ServoLoop(const ServoLoop&) = delete;
  ServoLoop& operator=(const ServoLoop&) = delete;

  // For the owner, at any time; these calls do not block.

  void setSettings(const ServoSettings& settings) noexcept {
    settings_.write(settings);
    heartbeat_.fetch_add(1, std::memory_order_relaxed);
  }
  /// Starts the watchdog: from now on the owner must set settings at least every kWatchdog_s. Otherwise the loop gives
  /// no force, because it could not receive the panic key either.
  void expectSettings() noexcept { expects_.store(true, std::memory_order_relaxed); }
  static constexpr double kWatchdog_s = 1.0;

  /// Hands over the interaction of a scene (null: no force) with the scene's number, which every sample of it carries.
  /// Settings set before this call apply to the interaction's first tick. The replaced interaction is returned by a
  /// tick and destroyed on this thread.
  void setInteraction(std::unique_ptr<Interaction> interaction, std::uint32_t scene = 0);

  /// Hands over the next motion of that scene's spheres (engine/haptics/sphere_motion.h); never null. It begins when
  /// the previous motion has ended, and its end state stays until another motion begins. Returns false, without handing
  /// over, while the previous one still waits to begin; try again in a later frame. A motion for a scene that is not
  /// active yet waits for that scene.
  bool setMotion(std::shared_ptr<const SphereMotion> motion, std::uint32_t scene = 0);

  /// True if the force depends on the hand's orientation; a rotation of the device then rotates the hand instead of the
  /// view.
  bool hasOrientation() const noexcept { return has_orientation_; }

  /// The chosen device, for its info() and status(); null: none.
  Device* device() const noexcept { return chosen_.get(); }
  /// True if the newest tick used the fallback because the chosen device was disconnected.
  bool fallenBack() const noexcept { return fallen_back_.load(std::memory_order_relaxed); }

  /// While true, ramps the force down along the slew limit and gives none: before a device is closed or the program
  /// ends.
  void rampDownForce(bool on) noexcept { ramp_down_force_.store(on || ramp_down_for_good_, std::memory_order_release); }
  /// Ramps the force down permanently.
  void endForce() noexcept {
    ramp_down_for_good_ = true;
    rampDownForce(true);
  }
  /// Ramps the force down. Calls pass(), which must let one tick pass, until two consecutive ticks gave no force (the
  /// first of them may have begun earlier), at most kRelease_ms times.
  template <class Pass>
  void release(Pass&& pass) {
    rampDownForce(true);
    for (int k = 0, none = 0; chosen_ && none < 2 && k < kRelease_ms; ++k) {
      pass();
      none = gives() ? 0 : none + 1;
    }
  }
  static constexpr int kRelease_ms = 50;
  /// True if the newest tick gave the chosen device any force.
  bool gives() const noexcept { return gives_.load(std::memory_order_acquire); }

  /// While true, each tick also computes the reactions on the scene's atoms, for the picture.
  void wantReactions(bool on) noexcept { wants_reactions_.store(on, std::memory_order_relaxed); }
  /// The reactions of the newest tick with the newest interaction; none before that tick. The reference is valid until
  /// the next call or the next interaction.
  const Reactions& reactions() noexcept { return reactions_ ? reactions_->read() : no_reactions_; }

  /// While true, the ticks sum the impulses on the scene's atoms, for code that moves the atoms: each tick adds its
  /// reactions times kTick_s.
  void wantImpulses(bool on) noexcept { wants_impulses_.store(on, std::memory_order_relaxed); }
  /// The impulses of all ticks since the last call, however much time has passed (atom_impulses.h). They continue over
  /// a change of the interaction within one scene. The reference is valid until the next call.
  const AtomImpulses& takeImpulses() noexcept { return impulses_.take(); }

  /// Calls take(sample) for every tick since the last call, oldest first (at most the last 4 s). Call it in each frame:
  /// it also destroys the objects returned by the ticks.
  template <class Take>
  void drain(Take&& take) {
    collect();
    ServoSample sample;
    while (samples_.pop(sample)) take(sample);
  }

  /// Calls take(tick) for each recorded tick since the last call (at most the last 4 s), and sets `start` to the state
  /// before the first recorded tick.
  template <class Take>
  void drainRecording(ServoStep& start, Take&& take) {
    RecordedTick tick;
    while (recording_ && recording_->ring.pop(tick)) {
      start = recording_->start;
      take(tick);
    }
  }
  /// Number of recorded ticks that were dropped because drainRecording() was not called in time.
  std::size_t lostOfRecording() const { return recording_ ? recording_->ring.dropped() : 0; }

  // For the owner, while no tick runs.

  /// Prepares the next tick, due one period after `now_ns`; it treats its device as a new one.
  void begin(std::int64_t now_ns) noexcept;
  /// Writes zero force to the chosen device and the fallback, as the last act.
  void end() noexcept;
  /// Between end() and begin(): sets the device for the following ticks; null: the fallback. Closes the old device.
  void setDevice(std::unique_ptr<Device> device);
  /// Between end() and begin(): records every tick with all its inputs, starting with the tick that receives the next
  /// interaction, until called with false.
  void record(bool on);

  // For the thread that ticks, one at a time.

  /// Performs one tick that began at `began_ns` and was due at `due_ns`. Without a due time, as with a device's own
  /// clock, it was due one period after the previous tick. `now` is the clock that measures the duration of the tick,
  /// which the next tick uses; null: ticks take no time. A concurrent second tick is ignored; it can occur while one
  /// clock takes over from another.
  void tick(std::int64_t began_ns, std::optional<std::int64_t> due_ns, std::int64_t (*now)()) noexcept;

 private:
  ServoSettings watchedSettings(double dt_s) noexcept;
  MotionPhase nextMotion() noexcept;
  void putDownMotion() noexcept;
  void collect();

  Device& fallback_;
  std::unique_ptr<Device> chosen_;
  TripleBuffer<ServoSettings> settings_;
  std::atomic<std::uint32_t> heartbeat_{0};  // number of settings handed over
  std::atomic<bool> expects_{false};
  SampleRing<ServoSample, 4096> samples_;
  // An interaction that is handed over, with its scene's number; a null interaction ends the contact.
  struct SceneInteraction {
    std::unique_ptr<Interaction> interaction;
    std::uint32_t scene = 0;
    std::shared_ptr<TripleBuffer<Reactions>> reactions;  // null without an interaction
  };
  std::atomic<SceneInteraction*> pending_{nullptr};  // to the ticks: the next one
  std::atomic<SceneInteraction*> retired_{nullptr};  // from the ticks: the replaced one
  SceneInteraction* current_ = nullptr;              // owned by the ticks
  // A motion that is handed over, with its scene's number.
  struct SceneMotion {
    std::shared_ptr<const SphereMotion> motion;
    std::uint32_t scene = 0;
  };
  std::atomic<SceneMotion*> pending_motion_{nullptr}, retired_motion_{nullptr};  // as above
  std::uint32_t pending_motions_scene_ = 0;                                      // owned by the owner's thread
  SceneMotion* motion_ = nullptr;                                                // ticks: the one in use
  SceneMotion* next_motion_ = nullptr;                                           // ticks: waits for its scene
  SceneMotion* last_motion_ = nullptr;  // ticks: replaced in this tick, in which the interaction may still read it
  int motion_tick_ = 0;                 // of the motion in use
  struct Recording {
    SampleRing<RecordedTick, 4096> ring;
    ServoStep start;       // written before the first tick is pushed
    bool begun = false;    // ticks: the interaction to start with has arrived
    bool started = false;  // ticks: the state at the first tick is saved
  };
  std::unique_ptr<Recording> recording_;
  bool records_ = false;  // changed only while no tick runs
  std::atomic<bool> fallen_back_{false};
  std::atomic<bool> ramp_down_force_{false};
  bool ramp_down_for_good_ = false, has_orientation_ = false;  // owner's thread
  std::atomic<bool> gives_{false};
  std::atomic<bool> wants_reactions_{false}, wants_impulses_{false};
  std::shared_ptr<TripleBuffer<Reactions>> reactions_;  // owner's end of the newest interaction's buffer
  Reactions no_reactions_;
  ImpulseExchange impulses_;
  // Used only by the thread that ticks, guarded by ticking_.
  std::atomic_flag ticking_ = ATOMIC_FLAG_INIT;
  ServoStep step_;
  std::optional<DeviceSwitch> switch_;
  TickTime time_;
  std::uint32_t last_heartbeat_ = 0;
  double silent_s_ = 0;
  std::int64_t last_ns_ = 0;
};

}  // namespace moltact
