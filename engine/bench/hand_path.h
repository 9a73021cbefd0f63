// The path of a hand as a file, for replaying it through methods: recordings of this program, and rows of numbers that
// others have written. Not for the haptic thread. Units: angstrom, or the device's millimetre until the path is laid on
// a molecule; second.
//
// A text file of numbers has a row for each tick. Numbers are separated by blanks, tabs, commas or semicolons. Lines
// that begin with '#', '%', ';' or "//" are comments; a comment of the form "# key: value" is kept as a label. These
// labels are understood:
//
//   columns      the meaning of a row's numbers, such as "t x y z fx fy fz"; others than these seven are ignored.
//                Without it three numbers are x y z, four t x y z, seven and more t x y z fx fy fz.
//   unit         A or mm, cm, m, of the places; without it millimetres
//   tick_s       the time between rows without t (default 0.001)
//   time_unit    s or ms, of t (default s)
//   probe_A
//   molecule
//
// Words in a head line before the first row are ignored, unless they name such columns.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/servo/servo_recording.h"

namespace moltact::bench {

struct HandPath {
  std::string name;                           ///< the file's stem
  std::map<std::string, std::string> labels;  ///< "molecule", "device", "hand", "stroke" and what else it says
  double probe_A = kWaterProbe_A;
  bool on_molecule = true;      ///< places are in the molecule's space (A), else in a device's (mm)
  std::vector<Vec3> places;     ///< the HIP, a tick of 1 ms each
  std::vector<bool> touched;    ///< whether a force was felt there; empty where the file does not say
  std::size_t passed_over = 0;  ///< lines of a head of words

  std::string label(const std::string& key) const {
    const auto found = labels.find(key);
    return found == labels.end() ? std::string() : found->second;
  }
};

/// Reads rows of numbers. Rows of another clock are read as a hand that moved evenly from row to row. A
/// Problem, with its line, where a row is broken or longer than 64 KiB, a place is beyond 1e9 A or mm, a time does not
/// ascend, there is no row, or there are more than 25 million rows or ticks or 1000 labels.
Expected<HandPath> readHandPath(const std::filesystem::path& file);

/// The HIP of each tick of a recording, from the first that is a place; one that is none (a device may tell anything)
/// is where the tick before was. `felt`: as it was newly made for the recording (the clutch asks
/// for the contact); with another or none the way is the same but where a clutch was held by the surface.
HandPath handPathOf(const ServoRecording& recording, std::string name, Interaction* felt);

/// As rows of numbers with labels, to 0.001 A, so that readHandPath reads the same back.
std::string textOf(const HandPath& path);

/// Lays a device's way on a molecule at `A_per_mm`: the middle of the part that touched something (of all,
/// where the file does not say) comes to lie on the surface in front of the molecule's middle, +z; the axes
/// stay. Places on a molecule stay as they are.
HandPath mappedTo(const HandPath& path, const SphereGrid& scene, double A_per_mm);

}  // namespace moltact::bench
