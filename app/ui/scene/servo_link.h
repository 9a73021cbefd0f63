// The window's end of the servo loop: settings and trackers go out, samples come back. Either the real thread at 1 kHz
// or the same tick stepped on the frames' clock, so that a script repeats exactly. Window's thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/device/mouse_device.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/servo_step.h"
#include "engine/servo/servo_thread.h"

namespace moltact {

enum class ServoClock {
  RealThread,  ///< the haptic thread, at the wall's clock
  Frames,      ///< ticks are stepped in advance(), as many as the frame is long
};

class ServoLink {
 public:
  explicit ServoLink(ServoClock clock);
  ~ServoLink();

  /// The stand-in device, which the hand leads.
  MouseDevice& mouse() { return mouse_; }
  /// The device to be felt with from now on; null: the mouse alone. The old one's force goes along the slew, then it is
  /// closed.
  void setDevice(std::unique_ptr<Device> device);
  /// The chosen device, for its status; null where the mouse leads alone.
  Device* chosen() const { return thread_ ? thread_->device() : chosen_.get(); }
  /// Whether the mouse stands in for a chosen device that is gone.
  bool fallenBack() const { return thread_ ? thread_->fallenBack() : switch_->fallenBack(); }
  /// A chosen device leads.
  bool held() const { return chosen() && !fallenBack(); }
  /// The one that leads.
  const DeviceInfo& device() const { return held() ? chosen()->info() : mouse_.info(); }
  /// Lets the force go along the slew, for good; there is none when it returns.
  void endForce();
  /// A tracker that is no part of the scene, to try a device with: its ticks are seen in newest() alone. The scene's is
  /// taken up again by setTracker().
  void tryTracker(std::unique_ptr<Tracker> tracker);
  bool trying() const { return trying_; }
  /// The newest tick of all, of whatever scene.
  const ServoSample& newest() const { return newest_; }

  void setSettings(const ServoSettings& settings);
  /// Another tracker in the same scene.
  void setTracker(std::unique_ptr<Tracker> tracker);
  /// A new scene: what was felt of the one before no longer comes out of advance().
  void begin(const ServoSettings& settings, std::unique_ptr<Tracker> tracker);
  /// The same molecule, placed anew by `settings`: what was felt under earlier discontinuities no longer comes out.
  void beginAgain(const ServoSettings& settings);
  std::uint32_t scene() const { return scene_; }

  /// Records every tick from the next tracker on, until false.
  void record(bool on);
  /// Calls take(tick) for each recorded tick since the last call, and tells the state that the first began from.
  template <class Take>
  void drainRecording(ServoStep& start, Take&& take) {
    if (thread_) return thread_->drainRecording(start, take);
    start = record_start_;
    for (const RecordedTick& tick : recorded_) take(tick);
    recorded_.clear();
  }
  /// Ticks that were not recorded because nobody drained them in time.
  std::size_t lostOfRecording() const { return thread_ ? thread_->lostOfRecording() : 0; }
  /// How many trackers were handed over so far.
  std::uint32_t trackers() const { return trackers_; }

  /// On the frames' clock ticks take no time, unless they are timed for someone who looks at it.
  void timeTicks(bool on) { timed_ = on; }

  /// Once a frame: gives every tick since the last call, oldest first. The reference holds until the next call.
  const std::vector<ServoSample>& advance(double dt_s);
  /// Every tick of the last advance(), of whatever scene or try.
  const std::vector<ServoSample>& everyTick() const { return every_; }
  /// On the frames' clock: the loop stands for so long before its next tick, as a busy computer lets it.
  void standStill(double s) { stands_s_ = s; }

  RealtimeStatus realtime() const;
  std::uint64_t missedTicks() const { return thread_ ? thread_->missedTicks() : 0; }
  ServoClock clock() const { return thread_ ? ServoClock::RealThread : ServoClock::Frames; }

 private:
  bool ofThisScene(const ServoSample& sample) const;
  void handOver(std::unique_ptr<Tracker> tracker, std::uint32_t scene);
  void release();

  MouseDevice mouse_;  // outlives the thread, which reads it
  std::vector<ServoSample> ticks_, every_;
  ServoSample newest_;
  bool trying_ = false;
  std::uint32_t scene_ = 0, first_placement_ = 0, trackers_ = 0;
  // Of the frames' clock:
  std::unique_ptr<Device> chosen_;
  std::optional<DeviceSwitch> switch_;
  ServoStep step_;
  ServoSettings settings_;
  std::unique_ptr<Tracker> tracker_;
  bool records_ = false;
  ServoStep record_start_;
  std::vector<RecordedTick> recorded_;
  double owed_s_ = 0.0, stands_s_ = 0.0;
  bool timed_ = false, ended_ = false;
  std::unique_ptr<ServoThread> thread_;  // last, so that it ends first
};

}  // namespace moltact
