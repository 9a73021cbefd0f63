// Hand, device and tracker in a closed loop on a virtual clock: how a person and a method act on each other. Units:
// angstrom in the molecule, millimetre and newton at the hand, joule.
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
  PointA hip;           ///< as read, even where the program was given NaN
  Contact contact;      ///< the last answer
  ForceN force;         ///< as commanded, clamped to the device's greatest
  bool stepped = true;  ///< false on a lost tick
};

/// The servo loop's own step without the safety stage, so that a method alone is judged.
class UnguardedStep final : public ServoStep {
 public:
  explicit UnguardedStep(const DeviceSpecs& device) : ServoStep(device, false) {}
};

class ClosedLoop {
 public:
  /// The device begins at rest at `start`.
  ClosedLoop(const LoopSettings& settings, PointA start);

  /// One tick: reads the device, steps the servo loop, commands the force, and moves the device while the hand is led to
  /// `target`. Supports the faults Late, Lost, Doubled and NotANumber.
  LoopTick tick(Interaction& interaction, PointA target, LoopFault fault = LoopFault::None);

  const DeviceModel& device() const { return device_; }
  DeviceModel& device() { return device_; }

  /// Energy made at the device between two releases: the method's, plus that of sampling, delay and rounding (unit: J).
  double made_J() const { return observer_.made_J(); }

  /// The most energy that sampling, delay and rounding could have made with any surface whose force changes by no more
  /// than the stiffness times the displacement, as a plain wall's does (unit: J): the sum of K |dx| (displacement since
  /// the reading + rounding).
  double samplingBound_J() const { return sampling_; }

 private:
  ServoSettings settings_;
  DeviceParameters figures_;
  DeviceModel device_;
  UnguardedStep step_;
  PassivityObserver observer_;
  Contact last_;
  ForceN command_;
  Vec3 place_mm_;
  std::vector<double> recent_m_;  // ways moved since the reading that the held force belongs to
  double sampling_ = 0;
};

/// The spring's force cut to max_N; zero without contact.
ForceN springForce(const LoopSettings& settings, const Contact& contact, double max_N);

}  // namespace moltact::bench
