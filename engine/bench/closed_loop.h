// Hand, device and tracker in a closed loop on a virtual clock, for measuring their interaction. Units: angstrom in the
// molecule, millimetre and newton at the hand, joule.
#pragma once

#include "engine/bench/passivity_observer.h"
#include "engine/device/device_model.h"
#include "engine/servo/loop_fault.h"
#include "engine/servo/servo_step.h"

namespace moltact::bench {

struct LoopSettings {
  DeviceParameters device;
  HandParameters hand;
  Workspace workspace;
  double stiffness_N_per_mm = 0.3;  ///< of the spring between HIP and SCP
};

struct LoopTick {
  PointA hip;           ///< as read from the device, even if the program received NaN
  Contact contact;      ///< of the last step
  PoseA body;           ///< of what is held, in the last step
  ForceN force;         ///< as commanded, clamped to the device's peak force
  bool stepped = true;  ///< false on a lost tick
};

/// A tick of the servo loop without the safety stage, to measure a method alone.
class UnguardedStep final : public ServoStep {
 public:
  explicit UnguardedStep(const DeviceSpecs& device) : ServoStep(device, false) {}
};

class ClosedLoop {
 public:
  /// The device starts at rest at `start`.
  ClosedLoop(const LoopSettings& settings, PointA start);

  /// Performs one tick: reads the device, steps the servo loop, commands the force, and moves the device while the hand
  /// moves to `target`. Supports the faults Late, Lost, Doubled and NotANumber. `phase`: where the spheres are.
  LoopTick tick(Interaction& interaction, PointA target, LoopFault fault = LoopFault::None,
                const MotionPhase& phase = {});

  /// The friction of the surface; the loop approaches the coefficient at kFrictionSlew_per_s.
  void setFriction(const Friction& friction) { settings_.surface.friction = friction; }

  const DeviceModel& device() const { return device_; }
  DeviceModel& device() { return device_; }

  /// Energy generated at the device between two releases, by the method and by sampling, delay and rounding (unit: J).
  double made_J() const { return observer_.made_J(); }

  /// Upper bound of the energy that sampling, delay and rounding can generate with a surface of at most this stiffness,
  /// such as a plain wall (unit: J). It is the sum of K |dx| (displacement since the reading + rounding).
  double samplingBound_J() const { return sampling_; }

 private:
  ServoSettings settings_;
  DeviceParameters figures_;
  DeviceModel device_;
  UnguardedStep step_;
  PassivityObserver observer_;
  Contact last_;
  PoseA body_;
  ForceN command_;
  Vec3 place_mm_;
  std::vector<double> recent_m_;  // path lengths since the reading on which the held force is based
  double sampling_ = 0;
};

/// The spring's force clamped to max_N; zero without contact.
ForceN springForce(const LoopSettings& settings, const Contact& contact, double max_N);

}  // namespace moltact::bench
