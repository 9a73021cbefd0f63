// The bodies, scenes and hand paths on which methods for a rigid body are timed and compared. The bodies are parts of
// molecules of the library, pressed into the rest of a molecule, dragged and twisted. Units: angstrom, radian, second.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/molecule/molecule.h"

namespace moltact::bench {

struct BodyTask {
  std::string name;
  std::shared_ptr<const SphereGrid> scene;
  std::shared_ptr<const HeldBody> body;
  Vec3 home;                              ///< of the body's middle; free of overlap, up to 0.3 A from contact
  Vec3 into;                              ///< unit vector: where the hand presses first
  double depth_A = 0.0, twist_rad = 0.0;  ///< how deep the hand presses, and how far it twists
};

/// All tasks, by ascending number of the body's atoms, and those of the chart.
inline constexpr std::array<std::string_view, 7> kBodyTasks{"1", "10", "35", "35 in 122796", "200", "1069", "5000"};
inline constexpr std::array<std::string_view, 5> kBodyChartTasks{"1", "10", "35", "200", "1069"};

/// Opens a molecule of the library by its id.
using OpenMolecule = std::function<Expected<Molecule>(const std::string& id)>;

/// Returns the task of one of these names, or the problem of its molecule:
/// * 1, 10: the first atoms of amprenavir, in the protein of 1HPV; the other atoms of amprenavir are left out;
/// * 35: all its atoms, in the same protein; "35 in 122796": in 81 copies of that protein, side by side;
/// * 200: the first 200 atoms of ubiquitin, at the surface of the protein of 1HPV;
/// * 1069: one chain of 2HHB beside the others;
/// * 5000: generated spheres, packed as in a protein, beside four copies of them.
Expected<BodyTask> bodyTask(std::string_view name, const OpenMolecule& open);

/// From home the hand presses along a direction that turns, and twists the body back and forth.
std::vector<PoseA> pathOf(const BodyTask& task, int ticks);

/// The time of a plain loop of 1000 sphere distances: the minimum of 3000 (unit: nanosecond). Times of ticks are divided by
/// it, so that figures of different machines can be compared.
double distanceLoop_ns();

}  // namespace moltact::bench
