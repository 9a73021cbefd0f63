// Generates recordings of a hand from choices: in the program's format, with values that a device or a file might
// contain.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "engine/servo/servo_recording.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {

/// The bytes of a recording that begins with a new loop.
std::string recordingOf(const std::map<std::string, std::string>& labels, const std::vector<RecordedTick>& ticks);

/// A recording of one block (at most 256 ticks) in parts; when it is assembled again, its checksums are correct.
struct RecordingParts {
  std::string labels, build, state, ticks;
  std::uint32_t count = 0;
  std::string file() const;
};
RecordingParts partsOf(const std::string& recording);

/// Replaces, removes or duplicates up to 7 of the state's values.
void changeState(std::string& state, Choices& choices);

/// A hand that moves around the scene, with up to 15 ticks whose positions, times, settings or figures are extreme or
/// not numbers. Some choices also change the labels or the state. At most 256 ticks.
std::string madeRecording(Choices& choices, std::size_t ticks, const Workspace& workspace);

}  // namespace moltact::fuzz
