// A recording of the servo loop's ticks: each tick's inputs, its force and torque, and the state from which the first began, so
// that a replay on the same build with the same scene gives the same forces to the last bit. Nothing in memory is a
// copy of the file's bytes: values are read by name, type and range. docs/devices.md describes the file. Not for the
// haptic thread, except RecordedTick. Units: millimetre, newton, second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/platform/append_file.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// One tick with all inputs of its force except the interaction.
struct RecordedTick {
  ServoSettings settings;
  DevicePose pose;
  TickTime time;
  DeviceSpecs device;         ///< of the device that leads
  bool other_device = false;  ///< another device than in the last tick leads
  ForceN force;
  Vec3 torque_N_mm{0.0};                ///< zero where the device drives none, and in files of earlier versions
  std::optional<PoseA> body_pose = {};  ///< as in Response; none in files of earlier versions
  bool at_rest = true;                  ///< as in Response
  // Results, for watching a recording grow; the file holds only the first and the last of these.
  bool fallen_back = false;  ///< the fallback led because the chosen device was gone
  bool touching = false;
  LimitFlags limits = {};
  bool spheres_moved =
      false;  ///< the scene's spheres moved; their frames are not recorded, so no replay gives these forces
};

struct ServoRecording {
  std::map<std::string, std::string> labels;  ///< the recorder's description: "molecule", "method", "device"
  std::optional<ServoStep> start;  ///< none where another build or version made the file; then the forces may differ
  std::vector<RecordedTick> ticks;
  bool torques = true;     ///< false: of an earlier version, which did not keep them
  bool body_poses = true;  ///< the same
  std::string torn;        ///< the reason why the rest could not be read; empty: the file is complete
};

/// Longer ones are neither written nor read (66 minutes and 40 s; a tick takes 416 bytes of memory).
inline constexpr std::size_t kMaxRecordedTicks = 4'000'000;

/// Writes a recording while it is made. Each block of 256 ticks is handed to the system whole before the next is begun,
/// so that a crash of the program costs at most one block. After a Problem nothing more is written; the blocks written
/// before stay readable.
class ServoRecordingWriter {
 public:
  /// Opens the file, so that any obstacle is known before anybody holds a device. An existing file is a Problem unless
  /// it may be replaced; it then stays until begin() has written. A file that was never begun is removed.
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
  DeviceSpecs device_;  // that leads, as far as it has been written
};

/// Reads a recording. A file that is no recording gives a Problem, and so do labels or a state that are invalid. A file
/// that is cut off or damaged gives the ticks before the damage, and `torn` says so.
Expected<ServoRecording> readServoRecording(const std::filesystem::path& file);

/// What a recording's hand felt with at its first tick, of which it must have one.
TouchSetup touchOf(const ServoRecording& recording);

struct ReplayResult {
  std::uint64_t ticks = 0;
  std::uint64_t moving = 0;  ///< those whose spheres moved during the recording and are at rest here
  /// The first tick whose force, torque or pose of the body differs from the recorded one in any bit.
  std::optional<std::uint64_t> first_difference;
  double greatest_difference_N = 0, greatest_difference_N_mm = 0;
  double greatest_difference_A = 0;  ///< of the place of the body's middle
};

/// Steps the recorded ticks with an interaction made as for the recording (null: none), and compares forces, torques and
/// the poses in which a body rests.
ReplayResult replay(const ServoRecording& recording, Interaction* interaction);

/// What a recording's labels say of its scene: "balls", a fingerprint that shows whether the molecule has changed since;
/// "untouchable" and "held", the spheres (counted from 0) that are not felt and that the hand holds, where there are such.
std::map<std::string, std::string> sceneLabels(const SphereGrid& scene, const HeldBody* body);

struct RecordedScene {
  std::shared_ptr<const SphereGrid> spheres;
  std::shared_ptr<const HeldBody> body;  ///< null: the probe
};

/// The scene of these labels, of its molecule's spheres. Labels that name others than there are name none.
RecordedScene recordedScene(const std::map<std::string, std::string>& labels, SharedArray<Sphere> spheres);

/// The number of spheres and all their values in one number (FNV-1a): a recording's label "balls", which shows whether
/// its molecule has changed since.
std::string fingerprint(const SphereGrid& scene);

}  // namespace moltact
