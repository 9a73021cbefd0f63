// Computes the maps of an EnergyGrid from the atoms of a scene, on several threads. Any thread except the haptic one; the
// call returns when all is computed. Units: angstrom, kcal/mol.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "engine/haptics/field/energy_grid.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// Receives the finished share of the work, 0 to 1, on the calling thread, a few times a second. False cancels.
using GridProgress = std::function<bool(double share)>;

/// Runs work(0) to work(count - 1) on `threads` threads, this one included; 0: one per processor. A system without threads
/// needs 1. Returns false if `progress` cancelled.
bool runGridWork(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                 const GridProgress& progress);

/// The energies of PairSum with the same arguments, on the nodes of `box`: Lennard-Jones for atoms of each of `sizes`
/// (gridSizes()) with depth 1, and electrostatic for a charge of 1. Walls are not folded; see foldWalls(). Empty if
/// cancelled. Throws std::bad_alloc if memory is insufficient.
std::optional<GridMaps> computeGridMaps(const SphereGrid& scene, std::span<const PairAtom> atoms, const GridBox& box,
                                        std::span<const float> sizes, const PairModel& model, int threads = 0,
                                        const GridProgress& progress = {});

}  // namespace moltact
