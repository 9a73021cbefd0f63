// The environment of the fault suite: a hand, a device model, molecules and the servo step on a virtual clock, and the
// judge of the force after every tick. Units: millimetre, newton, second, joule.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/servo/force_monitor.h"
#include "engine/servo/servo_step.h"
#include "tests/servo/fault_interactions.h"
#include "tests/servo/fault_run.h"

namespace moltact::test {

/// The input of a tick.
struct TickInput {
  TickTime time = {};
  std::optional<Vec3> place_mm = {};     ///< instead of the device's position
  std::optional<Quat> orientation = {};  ///< instead of the device's orientation
  bool fresh = true, connected = true;
  bool moves = true;     ///< false: the device's time stands still
  bool to_model = true;  ///< false: the force is sent to another device
  bool leaps = false;    ///< the position is far from the previous one

  /// Whether the input has a fault after which no force is permitted, not even for a tick.
  bool wrong() const;
};

class FaultWorld {
 public:
  explicit FaultWorld(std::uint64_t seed);

  /// Runs one tick and judges it; then advances the world by one millisecond.
  void tick(const TickInput& how = {});
  void ticks(int count, const TickInput& how = {}) {
    for (int k = 0; k < count; ++k) tick(how);
  }
  /// The loop does nothing for this time.
  void idle(int ms);
  /// From the next tick on, at most a soft start is permitted.
  void expectSoft() { judge_.expectSoft(); }
  /// Runs `count` ticks during which a fault lasts.
  void lasting(int count, const TickInput& how);

  /// Moves the hand from outside to some place under the surface, slides a little, and waits.
  void approach();
  /// Begins a fault of this name.
  void begin(const char* fault);
  /// Holds the hand still: the device must come to rest, or slide off with existing energy.
  void restAfter();

  void newScene();
  void newTracker();
  /// Moves the spheres to these places within `in_ticks` ticks.
  void moveSpheres(const std::vector<Sphere>& to, int in_ticks);
  /// Another device that has not received any force yet.
  void otherDevice(const DeviceInfo& info);
  DeviceInfo info() const;

  const FaultRunResult& result() const { return out_; }
  PointMm placed() const { return model_.sensed(); }  ///< the position that the device reports now
  PointMm sensed() const { return sensed_; }          ///< the position that it reported in the last tick
  const Quat& orientation() const { return orientation_; }
  const std::vector<Sphere>& spheres() const { return scene_.spheres; }

  scenes::Random random;
  ServoSettings settings;
  std::unique_ptr<Interaction> bad;  ///< felt instead of the molecule if it is set
  bool unsound_settings = false;     ///< they may end the force at once

 private:
  static DeviceParameters deviceOf(std::uint64_t seed);
  static HandParameters handOf(scenes::Random& random);
  void lead(const Vec3& to_mm, int in_ticks);
  void judge(const ServoSample& sample, const TickInput& how);
  void broken(const char* promise, double size_N);
  double pushes_A2(PointA place) const;
  double energy_J() const;
  double stored_J() const;

  std::uint64_t seed_;
  DeviceParameters device_;
  HandParameters hand_;
  DeviceModel model_;
  ServoStep step_;
  scenes::Scene scene_;
  std::unique_ptr<Interaction> tracker_;
  std::vector<std::unique_ptr<const SphereMotion>> frames_;  // of tracker_; the last one is in force
  double fraction_ = 1.0;                                    // of the last frame's motion
  bool follows_ = true;                                      // tracker_ follows the spheres
  bool summed_ = false;                                      // its energy is the sum of one spring per sphere
  WatchedBody* body_ = nullptr;                              // tracker_, if it is such a body
  bool exact_ = false;                                       // and the exact one
  Quat orientation_ = kNoRotation;
  Vec3 axis_ = glm::normalize(Vec3(0.3, 0.8, 0.5));
  std::string_view method_;
  const char* fault_ = "none";
  Vec3 target_mm_{40, 0, 0};
  ForceN command_;
  PointMm sensed_;
  double stretch_mm_ = 0, bent_mm_ = 0;  // bent_mm_: the stretch at which the force began to be cut
  double potential_mm2_ = 0;             // stored energy divided by the stiffness
  double felt_N_per_mm_ = -1;            // negative: no force, or the force is cut
  ForceMonitor judge_;
  std::uint64_t cuts_ = 0;
  FaultRunResult out_;
};

}  // namespace moltact::test
