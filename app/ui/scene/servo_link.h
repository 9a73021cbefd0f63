// The window's interface to the servo loop: passes settings and interactions to it and returns samples. The loop runs
// either as the real thread at 1 kHz or as the same ticks on the frames' clock, so that a script is reproducible.
// Window's thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "engine/device/mouse_device.h"
#include "engine/servo/servo_thread.h"

namespace moltact {

enum class ServoClock {
  RealThread,  ///< the haptic thread, on the wall clock
  Frames,      ///< for scripts: advance() executes as many ticks as the frame is long, so that every run is identical
  Page,        ///< the same ticks without a thread, for the real duration of a page's frames
};

class ServoLink {
 public:
  explicit ServoLink(ServoClock clock);
  ~ServoLink();

  /// The loop, for exchanges that do not involve the window: settings, the chosen device, a recording. Functions that
  /// exist here must be called here.
  ServoLoop& loop() { return thread_ ? thread_->loop() : *frames_; }
  const ServoLoop& loop() const { return thread_ ? thread_->loop() : *frames_; }

  /// The fallback device, which the pointer's hand leads.
  MouseDevice& mouse() { return mouse_; }
  /// Sets the device to be used from now on; null: only the mouse. The old device's force ends along the slew, then it
  /// is closed.
  void setDevice(std::unique_ptr<Device> device);
  /// Whether a chosen device leads the hand, and not the mouse.
  bool deviceLeads() const { return loop().device() && !loop().fallenBack(); }
  /// The device that leads the hand.
  const DeviceInfo& device() const { return deviceLeads() ? loop().device()->info() : mouse_.info(); }
  /// Ends the force permanently along the slew; it is zero on return.
  void endForce();
  /// Replaces the scene's interaction for a test of the device. Its ticks appear only in newest(). setInteraction()
  /// restores the scene's.
  void tryInteraction(std::unique_ptr<Interaction> felt);
  bool trying() const { return trying_; }
  /// The newest tick, of any scene.
  const ServoSample& newest() const { return newest_; }

  /// Sets another interaction, or another method of it, in the same scene.
  void setInteraction(std::unique_ptr<Interaction> felt);
  /// Passes the next motion of this scene's spheres to the loop (ServoLoop::setMotion). Returns false while the
  /// previous one is waiting.
  bool setMotion(std::shared_ptr<const SphereMotion> motion);
  /// The motion of this scene's spheres during a tick of the last advance() or of newest(); null: they were at rest.
  std::shared_ptr<const SphereMotion> motionOf(const ServoSample& sample) const { return motionOf(sample.motion); }
  /// The same by the motion's serial number.
  std::shared_ptr<const SphereMotion> motionOf(std::uint64_t serial) const;
  /// Begins a new scene: advance() no longer returns ticks of the previous one.
  void begin(const ServoSettings& settings, std::unique_ptr<Interaction> felt);
  /// Repositions the same molecule by `settings`: advance() no longer returns ticks before this discontinuity.
  void beginAgain(const ServoSettings& settings);
  std::uint32_t scene() const { return scene_; }

  /// Records every tick from the next interaction on, until called with false.
  void record(bool on);
  bool records() const { return records_; }
  /// Number of interactions passed to the loop so far.
  std::uint32_t handedOver() const { return handed_over_; }

  /// On the frames' clock, ticks are only timed if this is on.
  void timeTicks(bool on) { timed_ = on; }

  /// Called once per frame: returns every tick since the last call, oldest first. The reference is valid until the next
  /// call.
  const std::vector<ServoSample>& advance(double dt_s);
  /// Every tick of the last advance(), including those of other scenes and tests.
  const std::vector<ServoSample>& everyTick() const { return every_; }
  /// On the frames' clock: delays the next tick by this time, to simulate a busy computer.
  void simulateStall(double s) { stall_s_ = s; }

  /// The thread on the wall clock; null if frames execute the ticks.
  const ServoThread* thread() const { return thread_.get(); }
  ServoClock clock() const { return clock_; }

 private:
  bool ofThisScene(const ServoSample& sample) const;
  void handOver(std::unique_ptr<Interaction> felt, std::uint32_t scene);
  void take(const ServoSample& sample);
  void tickOfFrame();
  void release();

  const ServoClock clock_;
  MouseDevice mouse_;  // outlives the loop, which reads it
  std::vector<ServoSample> ticks_, every_;
  ServoSample newest_;
  // of this scene, beginning with that of the oldest tick still needed
  std::deque<std::shared_ptr<const SphereMotion>> motions_;
  bool trying_ = false, records_ = false;
  std::uint32_t scene_ = 0, first_placement_ = 0, handed_over_ = 0;
  // On the frames' clock only:
  std::optional<ServoLoop> frames_;
  std::int64_t now_ns_ = 0;
  double owed_s_ = 0.0, stall_s_ = 0.0;
  bool timed_ = false;
  std::unique_ptr<ServoThread> thread_;  // the last member, so that it is destroyed first
};

}  // namespace moltact
