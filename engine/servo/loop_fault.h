// What a real machine does to a tick of the servo loop, and a device to its reading: what the stability bench, the
// device check and the fault tests put into a loop. Plain data.
#pragma once

#include <cstdint>

namespace moltact {

enum class LoopFault : std::uint8_t {
  None,
  Late,          ///< the answer comes too late for its tick: the device holds the last force meanwhile
  Lost,          ///< no tick comes
  Doubled,       ///< a tick comes twice, on one reading
  Stall,         ///< the loop stands, in its tick
  PositionJump,  ///< the place is far off
  NotANumber,    ///< the place is none
  Frozen,        ///< nothing new comes from the device
};

}  // namespace moltact
