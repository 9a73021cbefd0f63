// Faults that a real machine causes in a tick of the servo loop, and a device in its reading. The stability bench, the
// device check and the fault tests inject them. Plain data.
#pragma once

#include <cstdint>

namespace moltact {

enum class LoopFault : std::uint8_t {
  None,
  Late,          ///< the answer comes too late for its tick: the device holds the last force meanwhile
  Lost,          ///< no tick comes
  Doubled,       ///< a tick comes twice, on one reading
  Stall,         ///< the loop is stalled within its tick
  PositionJump,  ///< the position is far off
  NotANumber,    ///< the position is not a number
  Frozen,        ///< nothing new comes from the device
};

}  // namespace moltact
