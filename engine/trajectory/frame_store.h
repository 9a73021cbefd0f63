// The frames of a trajectory as positions of a molecule's atoms: read when they are needed, smoothed, and kept while
// memory allows. One thread at a time, not the haptic one; the calls block on the disk. Unit: angstrom.
#pragma once

#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "engine/trajectory/frame_placer.h"

namespace moltact {

using AtomPositions = std::shared_ptr<const std::vector<Vec3>>;

class FrameStore {
 public:
  /// Limit on the memory of the kept frames (unit: byte). At least kMinFrames are kept.
  static constexpr std::size_t kMaxStored_bytes = std::size_t{96} << 20, kMinFrames = 4;

  FrameStore(std::unique_ptr<TrajectoryFile> file, FramePlacer placer)
      : file_(std::move(file)), placer_(std::move(placer)) {}
  /// Opens the file and finds its first frames.
  static Expected<std::unique_ptr<FrameStore>> open(const std::filesystem::path& file,
                                                    std::shared_ptr<const Molecule> molecule, const FrameFit& fit);

  TrajectoryFile& file() { return *file_; }
  const FramePlacer& placer() const { return placer_; }

  /// The positions at a frame, which must be less than file().frames(). `smoothing`: the mean over so many frames before
  /// and after it, fewer at the ends; of a covalent molecule that has leapt (leap_guard.h), over those on this side.
  Expected<AtomPositions> at(std::size_t frame, std::size_t smoothing = 0);
  /// The time of a frame that is kept; empty if it is not, or has none.
  std::optional<double> time_ps(std::size_t frame) const;
  /// Half of the shortest edge of the periodic cell of a frame that is kept, else of the one that was read last: a covalent
  /// molecule that moves farther from one frame to the next leaps. 0 without a cell.
  double leapLimit_A(std::size_t frame) const;

 private:
  Expected<AtomPositions> placed(std::size_t frame);

  std::unique_ptr<TrajectoryFile> file_;
  FramePlacer placer_;
  struct Kept {
    AtomPositions positions;
    std::optional<double> time_ps;
    double leap_limit_A = 0.0;
  };
  std::map<std::size_t, Kept> kept_;
  std::list<std::size_t> order_;  // of kept_, the oldest first
  double last_limit_A_ = 0.0;     // leapLimit_A of the frame that was read last
};

/// The positions between two frames: linear.
std::vector<Vec3> between(std::span<const Vec3> from, std::span<const Vec3> to, double share);

/// What the frames of a trajectory say about a molecule.
struct TrajectorySurvey {
  std::size_t every = 1;             ///< every n-th frame was read
  std::vector<float> rmsd_A;         ///< of each of these frames from the molecule's structure, over CA, P and C1' or
                                     ///< else all atoms
  std::vector<float> fluctuation_A;  ///< of each atom: root mean square distance from its mean position
};

/// Reads frames `first` to `last` (exclusive), at most `most` of them, evenly spaced.
Expected<TrajectorySurvey> surveyTrajectory(FrameStore& frames, std::size_t first, std::size_t last, std::size_t most);

}  // namespace moltact
