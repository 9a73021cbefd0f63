// A hand, a device model and the servo loop in contact with random molecules, on a virtual clock, while everything goes
// wrong that the outside can do: what is promised of the force is judged after every tick, by rules that share nothing
// with the safety stage. The same seed gives the same run. Units: millimetre, newton, second, joule.
#pragma once

#include <cstdint>
#include <string>

namespace moltact::test {

struct FaultRunResult {
  std::string broken;           ///< the first promise that was broken, with tick and fault; empty: none
  std::uint64_t ticks = 0;      ///< of the servo loop
  std::uint64_t contact = 0;    ///< in which it touched
  std::uint64_t turned = 0;     ///< in which what touched was a rigid body
  std::uint64_t faults = 0;     ///< that were done to it
  std::uint64_t cuts = 0;       ///< of the force, for energy that was made, while the hand was still
  std::uint64_t body_cuts = 0;  ///< the same of a rigid body whose force was above the greatest: what its springs store
                                ///< together is then not known, and the energy limit has to end the force
  double peak_N = 0;
  double restless_m_per_s = 0;  ///< greatest speed of the device a second after a fault, the hand held still, but where
                                ///< it slides off and its energy falls
};

/// Some 12 s of touching with `faults` faults.
FaultRunResult runFaults(std::uint64_t seed, int faults = 8);

}  // namespace moltact::test
