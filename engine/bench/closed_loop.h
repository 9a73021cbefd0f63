// Hand, device and tracker in a loop on a virtual clock: what a person would do to a method and it to the
// person. Units: angstrom in the molecule, millimetre and newton at the hand, joule.
#pragma once

#include "engine/bench/passivity_observer.h"
#include "engine/device/device_model.h"
#include "engine/haptics/tracker.h"

namespace moltact::bench {

struct LoopSettings {
  DeviceParameters device;
  HandParameters hand;
  Workspace workspace;
  double stiffness_N_per_mm = 0.3;  ///< of the spring between HIP and SCP
};

/// What the servo loop does with a tick; all but Normal are faults that a real machine shows.
enum class TickKind : std::uint8_t {
  Normal,
  Lost,        ///< the program misses the tick: the device holds the last command
  Late,        ///< the program answers too late for this tick: the device holds the last command once more
  Doubled,     ///< the program runs twice on one reading
  NotANumber,  ///< the reading is NaN
};

struct LoopTick {
  PointA hip;           ///< as read, even where the program was given NaN
  Contact contact;      ///< the last answer
  ForceN force;         ///< as commanded, cut to the device's greatest
  bool stepped = true;  ///< false on a lost tick
};

class ClosedLoop {
 public:
  /// The device begins at rest at `start`.
  ClosedLoop(const LoopSettings& settings, PointA start);

  /// One tick: reads the device, steps the tracker, commands the force, moves the device with the hand led to
  /// `target`.
  LoopTick tick(Tracker& tracker, PointA target, TickKind kind = TickKind::Normal);

  const DeviceModel& device() const { return device_; }
  DeviceModel& device() { return device_; }

  /// Energy that came out of nothing at the device between two releases: the method's and what sampling,
  /// delay and rounding add (unit: J).
  double made_J() const { return observer_.made_J(); }

  /// The most that sampling, delay and rounding could have made with any surface whose force changes by no
  /// more than the stiffness times the way moved, as a plain wall's does (unit: J): sum of K |dx| (way since
  /// the reading + rounding).
  double samplingBound_J() const { return sampling_; }

 private:
  LoopSettings settings_;
  DeviceModel device_;
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
