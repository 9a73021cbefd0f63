#include "engine/servo/safety_limits.h"

#include "engine/language/catalogue.h"

namespace moltact {

std::span<const LimitWords> limitWords() {
  static constexpr LimitWords kWords[] = {
      {Limit::NotFinite, N_("Not a number"), N_("A value was not a number: no force, then a soft start.")},
      {Limit::Clamp, N_("Greatest force"), N_("The force is cut to the greatest that is allowed.")},
      {Limit::Heat, N_("Heat"), N_("The motors are warm: the force is cut until they have cooled.")},
      {Limit::Slew, N_("Slew"), N_("The force changes less fast than the method asks.")},
      {Limit::SoftStart, N_("Soft start"), N_("The force grows slowly from nothing.")},
      {Limit::StalePlace, N_("Stale place"), N_("The device has reported no new position: the force falls to zero.")},
      {Limit::LateLoop, N_("Late loop"), N_("The computer was late: no force, then a soft start.")},
      {Limit::Jump, N_("Jump"), N_("The place leapt as no hand can: the contact is forgotten.")},
      {Limit::Speed, N_("Speed"), N_("The hand is fast: the force no longer drives it on.")},
      {Limit::Damping, N_("Damping"), N_("Energy was made: the force brakes until it is gone.")},
      {Limit::EnergyCut, N_("Energy"), N_("More energy was made than braking takes: no force, then a soft start.")},
      {Limit::Stiffness, N_("Stiffness"), N_("The surface is softer than asked, so that it does not buzz.")},
      {Limit::Unplugged, N_("Unplugged"), N_("The device is gone: no force.")},
      {Limit::Panic, N_("Stopped"), N_("All force is stopped until you allow it again.")},
      {Limit::DeviceFault, N_("Device"), N_("The device reports a fault or wants to be calibrated: no force.")},
  };
  return kWords;
}

}  // namespace moltact
