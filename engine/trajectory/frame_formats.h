// What the readers of frames share. Internal to engine/trajectory.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/trajectory/random_access_file.h"
#include "engine/trajectory/trajectory_file.h"

namespace moltact {

using OpenedTrajectory = Expected<std::unique_ptr<TrajectoryFile>>;

inline constexpr double kAngstrom_per_nanometre = 10.0;

/// Limit on the frames of a file; the places of so many take 160 MB.
inline constexpr std::size_t kMaxTrajectoryFrames = 20'000'000;

/// A trajectory whose frames begin at places that are found one after the other.
class FoundFrames : public TrajectoryFile {
 public:
  explicit FoundFrames(RandomAccessFile file) : file_(std::move(file)) {}
  void findMore(std::uint64_t bytes) override;

 protected:
  /// The end of the frame at `at`. `skipped`: it holds no positions, and is not counted. Empty at the end of the file.
  /// A Problem: the frame is damaged or cut short.
  struct Ending {
    std::uint64_t end = 0;
    bool skipped = false;
  };
  virtual Expected<std::optional<Ending>> endOf(std::uint64_t at) = 0;
  /// Finds the first frame; a Problem if there is none.
  std::optional<Problem> findFirst();

  RandomAccessFile file_;
  std::vector<std::uint64_t> begins_;  // of each frame
  std::uint64_t searched_ = 0;         // the place after the last frame found
};

/// A number of 4 or 8 bytes, the most significant byte first or last.
template <class Number>
Number orderedNumber(const char* bytes, bool big_endian) {
  static_assert(sizeof(Number) == 4 || sizeof(Number) == 8);
  std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t> bits = 0;
  for (std::size_t k = 0; k < sizeof bits; ++k) {
    const auto byte = static_cast<unsigned char>(bytes[big_endian ? k : sizeof bits - 1 - k]);
    bits = static_cast<decltype(bits)>(bits << 8 | byte);
  }
  return std::bit_cast<Number>(bits);
}

/// The Problem "frame 7: …", counted from 1.
Problem frameProblem(const std::string& file, std::size_t frame, const std::string& what);
/// The Problem that the frame is cut short.
Problem frameCutShort(const std::string& file, std::size_t frame);
/// The Problem of a file that is none of this format.
Problem notOfFormat(const std::string& file, std::string_view format);
/// Checks the positions of a frame; a Problem if one is not finite or too far away.
std::optional<Problem> checkPositions(const std::string& file, std::size_t frame, std::span<const Vec3> positions_A);
/// The cell with these vectors (angstrom) as columns; empty if they are not finite, too long or span no volume.
std::optional<glm::dmat3> cellOf(const glm::dmat3& vectors_A);
/// The cell with these edges (angstrom) and angles (degree); empty if they make none.
std::optional<glm::dmat3> cellOf(const Vec3& edges_A, const Vec3& angles_deg);

// One line for each format. Each opens the file and finds its first frame.
OpenedTrajectory openDcd(RandomAccessFile file);
OpenedTrajectory openXtc(RandomAccessFile file);
OpenedTrajectory openTrr(RandomAccessFile file);
OpenedTrajectory openAmberNetcdf(const std::filesystem::path& file);
OpenedTrajectory openGroFrames(RandomAccessFile file);
OpenedTrajectory openPdbModels(RandomAccessFile file);
OpenedTrajectory openMmcifModels(RandomAccessFile file);

}  // namespace moltact
