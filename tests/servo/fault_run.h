// Runs a hand, a device model and the servo loop in contact with random molecules on a virtual clock, while every
// possible external fault occurs. After every tick, the guarantees for the force are checked by rules that share no
// code with the safety stage. The same seed gives the same run. Units: millimetre, newton, second, joule.
#pragma once

#include <cstdint>
#include <string>

namespace moltact::test {

struct FaultRunResult {
  std::string broken;           ///< the first guarantee that was broken, with tick and fault; empty: none
  std::uint64_t ticks = 0;      ///< of the servo loop
  std::uint64_t contact = 0;    ///< ticks with contact
  std::uint64_t turned = 0;     ///< ticks with a rigid body in contact
  std::uint64_t exact = 0;      ///< those with the exact body
  std::uint64_t faults = 0;     ///< injected faults
  std::uint64_t cuts = 0;       ///< number of times the force was cut because energy was generated while the hand was
                                ///< still
  std::uint64_t body_cuts = 0;  ///< the same for a rigid body whose force exceeded the maximum. The sum of its springs'
                                ///< energy is then unknown, and the energy limit must end the force.
  double peak_N = 0;
  double restless_m_per_s = 0;  ///< maximum speed of the device a second after a fault with the hand held still, except
                                ///< while it slides off and its energy decreases
};

/// About 12 s of contact with `faults` faults.
FaultRunResult runFaults(std::uint64_t seed, int faults = 8);

}  // namespace moltact::test
