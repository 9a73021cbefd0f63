// A recording of the servo loop's ticks: each tick's inputs and its force, and the state from which the first began, so
// that a replay on the same build with the same scene gives the same forces to the last bit. Nothing in memory is a
// copy of the file's bytes: values are read by name, type and range. What the file holds: docs/devices.md. Not for the
// haptic thread but RecordedTick. Units: millimetre, newton, second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/ball_scene.h"
#include "engine/platform/append_file.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// One tick with all that its force depended on but the interaction.
struct RecordedTick {
  ServoSettings settings;
  DevicePose pose;
  TickTime time;
  DeviceSpecs device;         ///< of the one that leads
  bool other_device = false;  ///< that is another than in the last tick
  ForceN force;
  // What came of it, for who watches a recording grow; the file holds the first and the last of these only.
  bool fallen_back = false;  ///< the fallback led, for the chosen device was gone
  bool touching = false;
  LimitFlags limits = {};
  bool spheres_moved = false;  ///< the scene's: their frames are not recorded, so that no replay gives these forces
};

struct ServoRecording {
  std::map<std::string, std::string> labels;  ///< what the recorder wrote about it: "molecule", "method", "device"
  std::optional<ServoStep> start;  ///< none where another build or version made the file: the forces may then differ
  std::vector<RecordedTick> ticks;
  std::string torn;  ///< why the rest could not be read; empty: it is whole
};

/// Longer ones are neither written nor read (66 minutes and 40 s; a tick takes 416 bytes of memory).
inline constexpr std::size_t kMostRecordedTicks = 4'000'000;

/// Writes a recording as it comes. Each block of 256 ticks is handed to the system whole before the next is begun, so
/// that a crash of the program costs no more than one. After a Problem nothing more is written; what was kept stays
/// readable.
class ServoRecordingWriter {
 public:
  /// Opens the file, so that what stands in its way is known before anybody holds a device. What is there already is a
  /// Problem unless it may be replaced; it then stays until begin() has written. A file that was never begun goes.
  static Expected<ServoRecordingWriter> create(const std::filesystem::path& file, bool replace = false);
  /// Before the first tick. Labels: no line ends in keys or values, no '=' in keys.
  std::optional<Problem> begin(const std::map<std::string, std::string>& labels, const ServoStep& start);
  std::optional<Problem> add(const RecordedTick& tick);
  /// Writes what is left, and waits until the disk has it.
  std::optional<Problem> finish();
  /// Ticks that are in the file, whole blocks of them.
  std::uint64_t kept() const { return kept_; }

 private:
  explicit ServoRecordingWriter(AppendFile file) : file_(std::move(file)) {}
  std::optional<Problem> writeBlock();
  AppendFile file_;
  std::string block_;
  std::uint32_t ticks_in_block_ = 0;
  std::uint64_t kept_ = 0;
  std::optional<Problem> broken_;
  std::optional<ServoSettings> last_;
};

/// Reads a recording. What no recording is gives a Problem, and so does one whose labels or state cannot be; one that
/// breaks off, or whose rest is damaged, gives the ticks before that and says so in `torn`.
Expected<ServoRecording> readServoRecording(const std::filesystem::path& file);

/// What a recording's hand felt with at its first tick, of which it must have one.
TouchSetup touchOf(const ServoRecording& recording);

struct ReplayResult {
  std::uint64_t ticks = 0;
  std::uint64_t moving = 0;  ///< of these with spheres that moved when it was recorded, and stand here
  std::optional<std::uint64_t>
      first_difference;  ///< the first tick whose force is not the recorded one to the last bit
  double greatest_difference_N = 0;
};

/// Steps the recorded ticks with an interaction as it was newly made for the recording (null: none), and compares the
/// forces.
ReplayResult replay(const ServoRecording& recording, Interaction* felt);

/// How many balls and all of them in one number (FNV-1a): a recording's label "balls", by which it is told that its
/// molecule has changed meanwhile.
std::string fingerprint(const BallScene& scene);

}  // namespace moltact
