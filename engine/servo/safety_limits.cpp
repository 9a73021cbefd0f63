#include "engine/servo/safety_limits.h"

namespace moltact {

std::span<const LimitWords> limitWords() {
  static constexpr LimitWords kWords[] = {
      {Limit::NotFinite, "Not a number", "A value was not a number: no force, then a soft start."},
      {Limit::Clamp, "Greatest force", "The force is cut to the greatest that is allowed."},
      {Limit::Heat, "Heat", "The motors are warm: the force is cut until they have cooled."},
      {Limit::Slew, "Slew", "The force changes less fast than the method asks."},
      {Limit::SoftStart, "Soft start", "The force grows slowly from nothing."},
      {Limit::StalePlace, "Stale place", "The device has told no new place: the force falls to nothing."},
      {Limit::LateLoop, "Late loop", "The computer was late: no force, then a soft start."},
      {Limit::Jump, "Jump", "The place leapt as no hand can: the contact is forgotten."},
      {Limit::Speed, "Speed", "The hand is fast: the force no longer drives it on."},
      {Limit::Damping, "Damping", "Energy was made: the force brakes until it is gone."},
      {Limit::EnergyCut, "Energy", "More energy was made than braking takes: no force, then a soft start."},
      {Limit::Stiffness, "Stiffness", "The surface is softer than asked, so that it does not buzz."},
      {Limit::Unplugged, "Unplugged", "The device is gone: no force."},
      {Limit::Panic, "Stopped", "All force is stopped until you allow it again."},
      {Limit::DeviceFault, "Device", "The device reports a fault or wants to be calibrated: no force."},
  };
  return kWords;
}

}  // namespace moltact
