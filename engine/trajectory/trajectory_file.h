// The frames of a trajectory in a file, read one by one from the disk: DCD (CHARMM, NAMD), XTC and TRR (GROMACS), the
// frames of a GRO file and the models of a PDB or mmCIF file. Also NetCDF (AMBER convention); its library is loaded
// when such a file is opened. One thread at a time, not the haptic one; the calls block on the disk. Units: angstrom,
// picosecond.
//
// Formats whose frames differ in size are searched for the beginnings of frames: openTrajectory finds the first one,
// findMore the others. 8 bytes are kept for each frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

struct TrajectoryFrame {
  std::vector<Vec3> positions_A;  ///< one per atom of the file
  std::optional<double> time_ps;
  std::optional<glm::dmat3> cell_A;  ///< the columns are the vectors of the periodic cell
};

class TrajectoryFile {
 public:
  virtual ~TrajectoryFile() = default;

  /// "DCD".
  virtual std::string_view format() const = 0;
  std::size_t atoms() const { return atoms_; }
  /// The number of frames found so far.
  std::size_t frames() const { return frames_; }
  /// All frames have been found.
  bool complete() const { return complete_; }
  /// What was left out or assumed, one sentence each.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Searches for further frames, at least one and about as many as fit into `bytes` of the file. A frame that is cut
  /// short ends the trajectory, with a warning. Does nothing if complete().
  virtual void findMore(std::uint64_t bytes) = 0;
  /// Reads a frame; `frame` must be less than frames(). Every coordinate is finite and at most kMaxCoordinate_A.
  virtual Expected<TrajectoryFrame> read(std::size_t frame) = 0;

 protected:
  std::size_t atoms_ = 0, frames_ = 0;
  bool complete_ = false;
  std::vector<std::string> warnings_;
};

struct TrajectoryFormat {
  std::string_view ending;  ///< of file names, in lower case: ".dcd"
  std::string_view name;    ///< "DCD"; several endings may have the same
  bool describes_atoms;     ///< the format of a structure, which may hold several models or frames
};

/// All formats that are read, one entry per ending.
std::vector<TrajectoryFormat> trajectoryFormats();
/// True if the name has the ending, in upper or lower case, of a format that does not describe its atoms.
bool hasTrajectoryName(const std::filesystem::path& file);

/// Opens a trajectory and finds at least its first frame. The format follows from the name, or from the content if the
/// name has no known ending.
Expected<std::unique_ptr<TrajectoryFile>> openTrajectory(const std::filesystem::path& file);
/// The same for bytes in memory; `file` is the name for the format and for problems. NetCDF is read from files only.
Expected<std::unique_ptr<TrajectoryFile>> openTrajectoryBytes(std::string bytes, const std::filesystem::path& file);

}  // namespace moltact
