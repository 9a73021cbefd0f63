// The kinds of touch task. To add a kind, add its own file and one line in registry.cpp. The kind's own functions check
// what it requires of keys, scene and molecule.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

/// The usual duration of a kind of task, to find the place, do the task and read its instructions: `base_s`, plus
/// `each_s` for each item that the key `each` counts or lists.
struct TaskTime {
  double base_s = 0.0, each_s = 0.0;
  std::string_view each = {};       ///< empty: no items
  std::string_view each_what = {};  ///< the item in an author's words: "pair"
};

struct TaskKind {
  std::string_view name;     ///< also the key of its target: "reach: element O"; differs from every key of other kinds
  std::string_view meaning;  ///< one sentence for authors
  TaskTime time;
  std::vector<KeySpec> keys;  ///< its own keys; the one called `name` comes first
  std::unique_ptr<Task> (*make)(const TaskSpec& spec, const Molecule& molecule);
  /// Adds problems with keys that exclude each other, as if from file ""; may be null.
  void (*check)(const TaskSpec& spec, std::vector<Problem>& problems) = nullptr;
  /// Adds problems with the atoms in the step's molecule, beyond selections that select none; `untouchable` as for
  /// Task::leaveOut. May be null.
  void (*check_molecule)(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                         std::vector<Problem>& problems) = nullptr;
  /// Adds problems with keys that do not suit the scene of the task; may be null.
  void (*check_scene)(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) = nullptr;
  /// What is judged of a held body, as a sentence for authors. Empty: the kind judges only a probe, and steps with a
  /// held body cannot use it.
  std::string_view of_body = {};
  /// Whether the form of the task that `spec` gives judges a body. Null: every form does if `of_body` is not empty.
  bool (*form_judges_body)(const TaskSpec& spec) = nullptr;
  /// Adds problems with what the scene's hand holds, in the scene's structures; not called where it holds the probe; may be
  /// null.
  void (*check_body)(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                     std::span<const StructureChoice> structures, std::vector<Problem>& problems) = nullptr;

  /// Adds problems with the forces between atoms of the task's scene; not called where it has none; may be null.
  void (*check_forces)(const TaskSpec& spec, const SceneForces& forces, std::vector<Problem>& problems) = nullptr;
  /// Its path names what the hand holds, so the scene need not let these atoms be touched.
  bool names_held = false;

  bool judgesBody(const TaskSpec& spec) const {
    return !of_body.empty() && (!form_judges_body || form_judges_body(spec));
  }
};

std::span<const TaskKind> taskKinds();

/// The kind with that name, or null.
const TaskKind* findTaskKind(std::string_view name);

/// Makes a task in its initial state. `spec` must come from the reader; the molecule is not stored.
std::unique_ptr<Task> makeTask(const TaskSpec& spec, const Molecule& molecule);

}  // namespace moltact
