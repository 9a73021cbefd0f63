// The path of a hand in a file, for replaying it through methods: recordings of this program, and rows of numbers from
// other sources. Not for the haptic thread. Units: angstrom, or the device's millimetre until mappedTo() maps the path
// to a molecule; second.
//
// A text file of numbers has a row per tick. Numbers are separated by blanks, tabs, commas or semicolons. Lines that
// begin with '#', '%', ';' or "//" are comments; a comment of the form "# key: value" is stored as a label. The
// following labels are interpreted:
//
//   columns      the meaning of a row's numbers, such as "t x y z fx fy fz"; others than these seven are ignored.
//                Without it three numbers are x y z, four t x y z, seven and more t x y z fx fy fz.
//   unit         unit of positions: A, mm, cm or m (default mm)
//   tick_s       time between rows without t (default 0.001)
//   time_unit    unit of t: s or ms (default s)
//   probe_A
//   molecule
//
// A header line of words before the first row is ignored, unless it names such columns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/servo/servo_recording.h"

namespace moltact {

struct HandPath {
  std::string name;                           ///< the file's stem
  std::map<std::string, std::string> labels;  ///< "molecule", "device", "hand", "stroke" and others
  double probe_A = kWaterProbe_A;
  bool on_molecule = true;      ///< positions are in the molecule's space (A), else in a device's (mm)
  std::vector<Vec3> places;     ///< the HIP, one position per tick of 1 ms
  std::vector<bool> touched;    ///< true where a force was felt; empty if the file does not contain this
  std::size_t passed_over = 0;  ///< number of ignored header lines

  std::string label(const std::string& key) const {
    const auto found = labels.find(key);
    return found == labels.end() ? std::string() : found->second;
  }
};

/// Reads rows of numbers. Rows with another period are interpolated linearly to 1 ms. Returns a Problem with its line
/// if a row is invalid or longer than 64 KiB, a position is beyond 1e9 A or mm, or times do not ascend. The same
/// applies to a file without rows, with more than 25 million rows or ticks, or with more than 1000 labels.
Expected<HandPath> readHandPath(const std::filesystem::path& file);

/// The HIP of each tick of a recording, from the first valid position; an invalid one (devices are untrusted) repeats
/// the previous tick. `felt` must be new, made for the recording; the clutch depends on its contact. With another
/// interaction or none the path differs only where a clutch was held by the surface.
HandPath handPathOf(const ServoRecording& recording, std::string name, Interaction* felt);

/// Formats the path as rows of numbers with labels, to 0.001 A; readHandPath() reads it back.
std::string textOf(const HandPath& path);

/// Maps a device's path to a molecule at `A_per_mm`. The middle of the touching part lies on the surface in front of
/// the molecule's middle, +z; the axes are kept. If the file does not say which part touches, the whole path counts. A
/// path on a molecule is returned unchanged.
HandPath mappedTo(const HandPath& path, const SphereGrid& scene, double A_per_mm);

}  // namespace moltact
