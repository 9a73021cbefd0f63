// A hand, a device model, molecules and the servo step on a virtual clock: what the faults of the fault suite are done
// to, and the judge of the force after every tick. Units: millimetre, newton, second, joule.
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

/// What a tick of the loop meets.
struct TickInput {
  TickTime time = {};
  std::optional<Vec3> place_mm = {};     ///< instead of the device's
  std::optional<Quat> orientation = {};  ///< likewise
  bool fresh = true, connected = true;
  bool moves = true;     ///< false: no time passes for the device
  bool to_model = true;  ///< false: the force is for another device
  bool leaps = false;    ///< the place is far from the one before

  /// Something is wrong that no force may outlast, not even for a tick.
  bool wrong() const;
};

class FaultWorld {
 public:
  explicit FaultWorld(std::uint64_t seed);

  /// One tick of the loop, judged; then one millisecond of the world.
  void tick(const TickInput& how = {});
  void ticks(int count, const TickInput& how = {}) {
    for (int k = 0; k < count; ++k) tick(how);
  }
  /// So many milliseconds in which the loop does nothing.
  void idle(int ms);
  /// From the next tick on no more than a soft start is allowed.
  void expectSoft() { judge_.expectSoft(); }
  /// As many ticks, in all of which a fault lasts.
  void lasting(int count, const TickInput& how);

  /// The hand goes from outside to some place under the surface, slides a little, and waits.
  void approach();
  /// A fault of this name begins.
  void begin(const char* fault);
  /// The hand is held still: what moves the device comes to rest, or slides off on energy that was there.
  void restAfter();

  void newScene();
  void newTracker();
  /// The spheres go to these places within so many ticks.
  void moveSpheres(const std::vector<Sphere>& to, int in_ticks);
  /// Nothing has been given to it yet.
  void otherDevice(const DeviceInfo& info);
  DeviceInfo info() const;

  const FaultRunResult& result() const { return out_; }
  PointMm placed() const { return model_.sensed(); }  ///< where the device says that it is now
  PointMm sensed() const { return sensed_; }          ///< where it said so in the last tick
  const Quat& orientation() const { return orientation_; }
  const std::vector<Sphere>& spheres() const { return scene_.spheres; }

  scenes::Random random;
  ServoSettings settings;
  std::unique_ptr<Interaction> bad;  ///< felt instead of the molecule, where there is one
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
  std::vector<std::unique_ptr<const SphereMotion>> frames_;  // of tracker_; the last is in force
  double fraction_ = 1.0;                                    // of it
  bool follows_ = true;                                      // tracker_ goes with the spheres
  bool summed_ = false;                                      // it stores in a spring for each sphere
  WatchedBody* body_ = nullptr;                              // of tracker_, where it is one
  Quat orientation_ = kNoRotation;
  Vec3 axis_ = glm::normalize(Vec3(0.3, 0.8, 0.5));
  std::string_view method_;
  const char* fault_ = "none";
  Vec3 target_mm_{40, 0, 0};
  ForceN command_;
  PointMm sensed_;
  double stretch_mm_ = 0, bent_mm_ = 0;  // the latter where the force began to be cut
  double potential_mm2_ = 0;             // what is stored, over the stiffness
  double felt_N_per_mm_ = -1;            // negative: none, or the force is cut
  ForceMonitor judge_;
  std::uint64_t cuts_ = 0;
  FaultRunResult out_;
};

}  // namespace moltact::test
