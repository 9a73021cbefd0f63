// Faults of a real machine in a tick of the servo loop, and of a device in its readings. Injected by the stability
// bench, the device check and the fault tests. Plain data.
#pragma once

#include <cstdint>

namespace moltact {

enum class LoopFault : std::uint8_t {
  None,
  Late,          ///< the response is late; the device holds the last force meanwhile
  Lost,          ///< the tick is lost
  Doubled,       ///< the tick runs twice with one reading
  Stall,         ///< the loop stalls within the tick
  PositionJump,  ///< the position is far off
  NotANumber,    ///< the position is NaN
  Frozen,        ///< the device delivers no new data
};

}  // namespace moltact
