// The window's end of the servo loop: settings and what is felt go out, samples come back. Either the real thread at
// 1 kHz or the same ticks on the frames' clock, so that a script repeats exactly. Window's thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "engine/device/mouse_device.h"
#include "engine/servo/servo_thread.h"

namespace moltact {

enum class ServoClock {
  RealThread,  ///< the haptic thread, at the wall's clock
  Frames,      ///< a script's: ticks are stepped in advance(), as many as the frame is long, and every run is the same
  Page,        ///< the same ticks where no thread can be had, by the time that a page's frames really take
};

class ServoLink {
 public:
  explicit ServoLink(ServoClock clock);
  ~ServoLink();

  /// The loop of this link, for the exchange that needs nothing of the window: settings, the chosen device, a recording.
  /// What has a function here must be called here.
  ServoLoop& loop() { return thread_ ? thread_->loop() : *frames_; }
  const ServoLoop& loop() const { return thread_ ? thread_->loop() : *frames_; }

  /// The stand-in device, which the hand leads.
  MouseDevice& mouse() { return mouse_; }
  /// The device to be felt with from now on; null: the mouse alone. The old one's force goes along the slew, then it is
  /// closed.
  void setDevice(std::unique_ptr<Device> device);
  /// A chosen device leads, and not the mouse.
  bool deviceLeads() const { return loop().device() && !loop().fallenBack(); }
  /// The one that leads.
  const DeviceInfo& device() const { return deviceLeads() ? loop().device()->info() : mouse_.info(); }
  /// Lets the force go along the slew, for good; there is none when it returns.
  void endForce();
  /// An interaction that is no part of the scene, to try a device with: its ticks are seen in newest() alone. The
  /// scene's is taken up again by setInteraction().
  void tryInteraction(std::unique_ptr<Interaction> felt);
  bool trying() const { return trying_; }
  /// The newest tick of all, of whatever scene.
  const ServoSample& newest() const { return newest_; }

  /// Another interaction, or another method of it, in the same scene.
  void setInteraction(std::unique_ptr<Interaction> felt);
  /// The next motion of this scene's spheres (ServoLoop::setMotion); false while the one before waits.
  bool setMotion(std::shared_ptr<const SphereMotion> motion);
  /// The motion of this scene's spheres in which the tick was made, of the ticks of the last advance() and of newest();
  /// null: they were at rest.
  std::shared_ptr<const SphereMotion> motionOf(const ServoSample& sample) const;
  /// A new scene: what was felt of the one before no longer comes out of advance().
  void begin(const ServoSettings& settings, std::unique_ptr<Interaction> felt);
  /// The same molecule, placed again by `settings`: ticks of earlier discontinuities no longer come out.
  void beginAgain(const ServoSettings& settings);
  std::uint32_t scene() const { return scene_; }

  /// Records every tick from the next interaction on, until false.
  void record(bool on);
  /// How many interactions were handed over so far.
  std::uint32_t handedOver() const { return handed_over_; }

  /// On the frames' clock ticks take no time, unless they are timed for someone who looks at it.
  void timeTicks(bool on) { timed_ = on; }

  /// Once a frame: gives every tick since the last call, oldest first. The reference holds until the next call.
  const std::vector<ServoSample>& advance(double dt_s);
  /// Every tick of the last advance(), of whatever scene or try.
  const std::vector<ServoSample>& everyTick() const { return every_; }
  /// On the frames' clock: the loop stands for so long before its next tick, as a busy computer lets it.
  void simulateStall(double s) { stall_s_ = s; }

  /// The thread at the wall's clock; null where frames make the ticks.
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
  std::deque<std::shared_ptr<const SphereMotion>> motions_;  // of this scene, from that of the oldest tick held on
  bool trying_ = false;
  std::uint32_t scene_ = 0, first_placement_ = 0, handed_over_ = 0;
  // On the frames' clock:
  std::optional<ServoLoop> frames_;
  std::int64_t now_ns_ = 0;
  double owed_s_ = 0.0, stall_s_ = 0.0;
  bool timed_ = false;
  std::unique_ptr<ServoThread> thread_;  // last, so that it ends first
};

}  // namespace moltact
