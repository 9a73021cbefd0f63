// A recording of the servo loop: each tick's inputs, its force and torque, and the state before the first tick. A
// replay by the same build with the same scene gives bitwise identical forces. Values are read by name, type and range,
// never as raw memory. docs/devices.md describes the file format. Not for the haptic thread, except RecordedTick.
// Units: millimetre, newton, second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/platform/append_file.h"
#include "engine/servo/recorded_motion.h"
#include "engine/servo/servo_step.h"

namespace moltact {

/// `RecordedTick::motion` of a tick whose spheres moved in a way that the file, of an earlier version, does not contain.
inline constexpr std::uint32_t kUnknownMotion = ~std::uint32_t{0};

/// One tick with all inputs of its force except the interaction.
struct RecordedTick {
  ServoSettings settings;
  DevicePose pose;
  TickTime time;
  DeviceSpecs device;         ///< of the device in use
  bool other_device = false;  ///< the device differs from that of the last tick
  ForceN force;
  Vec3 torque_N_mm{0.0};                ///< zero for a device without torque, and in files of earlier versions
  std::optional<PoseA> body_pose = {};  ///< as in Response; empty in files of earlier versions
  bool at_rest = true;                  ///< as in Response
  std::uint32_t motion = 0;             ///< number of the spheres' motion, from 1; 0: they are at rest
  std::int32_t motion_tick = 0;         ///< of that motion
  // Results for display while recording; the file contains only fallen_back.
  bool fallen_back = false;  ///< the fallback was used because the chosen device was disconnected
  bool touching = false;
  LimitFlags limits = {};
  std::uint64_t motion_serial = 0;  ///< SphereMotion::serial(); 0: the spheres are at rest
};

struct ServoRecording {
  std::map<std::string, std::string> labels;  ///< description by the recorder: "molecule", "method", "device"
  std::optional<ServoStep> start;             ///< empty: recorded by another build or version; forces may then differ
  std::vector<RecordedTick> ticks;
  std::vector<RecordedMotion> motions;  ///< of the spheres, in their order
  std::vector<Sphere> placed;           ///< the spheres before the first motion; empty: as in the molecule
  bool torques = true;                  ///< false: written by an earlier version, without torques
  bool body_poses = true;               ///< false: written by an earlier version, without poses of bodies
  std::string torn;                     ///< why the rest of the file could not be read; empty: it is complete
};

/// Limit on the ticks of a recording (66 minutes and 40 s; a tick takes 432 bytes of memory).
inline constexpr std::size_t kMaxRecordedTicks = 4'000'000;

/// Writes a recording while it is made. Each block of 256 ticks is passed to the system as a whole, so that a crash of
/// the program loses at most one block. After a Problem nothing more is written; the blocks written before stay
/// readable.
class ServoRecordingWriter {
 public:
  /// Opens the file early, so that obstacles are known before a user holds the device. An existing file is a Problem
  /// unless `replace`; it then stays until begin() has written. A file without begin() is removed.
  static Expected<ServoRecordingWriter> create(const std::filesystem::path& file, bool replace = false);
  /// Call before the first tick. Labels: no line ends in keys or values, no '=' in keys.
  std::optional<Problem> begin(const std::map<std::string, std::string>& labels, const ServoStep& start);
  /// The places of the spheres for which the interaction was created, after begin(), if they are not the molecule's.
  std::optional<Problem> place(std::span<const Sphere> spheres);
  /// The next motion, before the first of its ticks.
  std::optional<Problem> addMotion(const RecordedMotion& motion);
  std::optional<Problem> add(const RecordedTick& tick);
  /// Writes the remaining ticks and blocks until the disk has them.
  std::optional<Problem> finish();
  /// Number of ticks in the file (complete blocks).
  std::uint64_t kept() const { return kept_; }

 private:
  explicit ServoRecordingWriter(AppendFile file) : file_(std::move(file)) {}
  std::optional<Problem> writeBlock();
  std::optional<Problem> append(std::string_view magic, std::uint32_t ticks, const std::string& bytes);
  AppendFile file_;
  std::string block_;
  std::uint32_t ticks_in_block_ = 0;
  std::uint64_t kept_ = 0;
  std::optional<Problem> broken_;
  std::optional<ServoSettings> last_;
  DeviceSpecs device_;  // of the device in use, as last written
};

/// Reads a recording. A file of another format, invalid labels or an invalid state give a Problem. A truncated or
/// damaged file gives the ticks before the damage, with the reason in `torn`.
Expected<ServoRecording> readServoRecording(const std::filesystem::path& file);

/// The touch setup of a recording's first tick; there must be at least one tick.
TouchSetup touchOf(const ServoRecording& recording);

struct ReplayResult {
  std::uint64_t ticks = 0;
  std::uint64_t motion_unknown = 0;  ///< ticks whose spheres moved in an unknown way; here they are at rest
  /// The first tick whose force, torque or pose of the body differs from the recorded one in any bit.
  std::optional<std::uint64_t> first_difference;
  double max_difference_N = 0, max_difference_N_mm = 0;
  double max_difference_A = 0;  ///< of the position of the body's middle
};

/// Replays the recorded ticks with an interaction created as for the recording (null: none), and compares forces,
/// torques and rest poses of a body. `scene`: the interaction's; null: its motions are unknown.
ReplayResult replay(const ServoRecording& recording, Interaction* interaction, const SphereGrid* scene = nullptr);

/// The labels that describe a recording's scene. "balls" is a fingerprint that reveals a changed molecule;
/// "untouchable" and "held" list the spheres (from 0) that are not felt or in the hand, if there are any.
std::map<std::string, std::string> sceneLabels(const SphereGrid& scene, const HeldBody* body);

struct RecordedScene {
  std::shared_ptr<const SphereGrid> spheres;
  std::shared_ptr<const HeldBody> body;  ///< null: the probe
};

/// Restores the scene from its labels and the molecule's spheres. Lists with invalid indices are ignored.
RecordedScene recordedScene(const std::map<std::string, std::string>& labels, SharedArray<Sphere> spheres);

/// A fingerprint of the number of spheres and all their values (FNV-1a), for a recording's label "balls".
std::string fingerprint(const SphereGrid& scene);

}  // namespace moltact
