// A task with a guide (keys `guide …`): some tries in which the way leads the hand, weaker each time, and a last one
// without it, which alone is judged. The guide's force has no part along the way (engine/haptics/guide/guide.h), so it
// finishes no try by itself. Ticks that still carry a guide's force are left out of the judged try. Window's thread.
// Units: angstrom, newton, second.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

/// Adds the keys of a guide to those of a kind.
void addGuideKeys(std::vector<KeySpec>& keys);
/// Adds problems with keys of a guide that the task does not have.
void checkGuideKeys(const TaskSpec& spec, std::vector<Problem>& problems);

/// Whether the task has a guide.
bool hasGuide(const TaskSpec& spec);
/// The number of its tries with a guide; 0 without one.
int guidedTries(const TaskSpec& spec);
/// The file of the recorded hand that guides; empty: the task's own way.
std::string guideFile(const TaskSpec& spec);

/// The way of a task over the surface: the places of its demonstration for a hand that does not press, with a gap where
/// the hand is lifted. Of several ways, the one nearest to `hand_A`, which is on the side where the hand is; without it the
/// first. Empty if the probe cannot go it.
GuidePath wayOfTask(const Task& task, const SphereGrid& spheres, double probe_A,
                    const std::optional<Vec3>& hand_A = std::nullopt);

/// Runs `inner`, a task in its initial state, in tries with and without a guide. Without a way, only the judged try is
/// left.
std::unique_ptr<Task> makeGuided(const TaskSpec& spec, std::unique_ptr<Task> inner, const Molecule& molecule);

}  // namespace moltact
