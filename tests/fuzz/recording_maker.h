// Recordings of a hand put together by choices: as a program of ours writes them, with what a device or a file might
// tell.
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

/// A recording of one block (at most 256 ticks), taken apart; put together again its checksums are right.
struct RecordingParts {
  std::string labels, build, state, ticks;
  std::uint32_t count = 0;
  std::string file() const;
};
RecordingParts partsOf(const std::string& recording);

/// Up to 7 of the state's values become others, go or come twice.
void changeState(std::string& state, Choices& choices);

/// A hand that goes round in the scene, with up to 15 ticks whose places, times, settings or figures are at the ends of
/// what is read, or are no numbers; with some choices the labels or the state are others too. Ticks: at most 256.
std::string madeRecording(Choices& choices, std::size_t ticks, const Workspace& workspace);

}  // namespace moltact::fuzz
