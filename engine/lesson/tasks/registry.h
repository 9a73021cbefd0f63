// The kinds of touch task that there are. A kind is added with its own file and one line in registry.cpp; what it asks of
// keys, scene and molecule is checked by its own functions.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

struct TaskKind {
  std::string_view name;      ///< also the key that carries its target: "reach: element O"; no key of another kind
  std::string_view meaning;   ///< one sentence for authors
  std::vector<KeySpec> keys;  ///< its own keys, the one called `name` first
  std::unique_ptr<Task> (*make)(const TaskSpec& spec, const Molecule& molecule);
  /// Adds problems with keys that do not go together, as if from file ""; may be null.
  void (*check)(const TaskSpec& spec, std::vector<Problem>& problems) = nullptr;
  /// The same for what its atoms in the step's molecule tell, beyond that each selection selects some; `untouchable` as
  /// for Task::leaveOut; may be null.
  void (*check_molecule)(const TaskSpec& spec, const Molecule& molecule, std::span<const std::uint32_t> untouchable,
                         std::vector<Problem>& problems) = nullptr;
  /// The same for what does not go with the scene that it is done in; may be null.
  void (*check_scene)(const TaskSpec& spec, const SceneSpec& scene, std::vector<Problem>& problems) = nullptr;
  /// What is judged of a body in the hand, for authors; empty: the kind judges a probe only, and a step whose hand holds
  /// a body cannot have it.
  std::string_view of_body = {};
  /// Whether a body is judged in the form that `spec` gives the task; null: in every form, if `of_body` says so.
  bool (*form_judges_body)(const TaskSpec& spec) = nullptr;
  /// Adds problems with what the scene's hand holds, in the scene's structures; not called where it holds the probe; may be
  /// null.
  void (*check_body)(const TaskSpec& spec, const std::shared_ptr<const HeldBody>& body,
                     std::span<const StructureChoice> structures, std::vector<Problem>& problems) = nullptr;

  bool judgesBody(const TaskSpec& spec) const {
    return !of_body.empty() && (!form_judges_body || form_judges_body(spec));
  }
};

std::span<const TaskKind> taskKinds();

/// The kind of that name, or nullptr.
const TaskKind* findTaskKind(std::string_view name);

/// The task, at its start. `spec` must come from the reader; the molecule is not kept.
std::unique_ptr<Task> makeTask(const TaskSpec& spec, const Molecule& molecule);

}  // namespace moltact
