#include "engine/lesson/tasks/registry.h"

#include "engine/lesson/tasks/kinds.h"

namespace moltact {

std::span<const TaskKind> taskKinds() {
  static const std::vector<TaskKind> kinds{
      reachKind(),   holdKind(), pressKind(), feelKind(), crossKind(),   avoidKind(),
      compareKind(), meetKind(), traceKind(), findKind(), predictKind(), sameKind(),
  };
  return kinds;
}

const TaskKind* findTaskKind(std::string_view name) {
  for (const TaskKind& k : taskKinds())
    if (k.name == name) return &k;
  return nullptr;
}

std::unique_ptr<Task> makeTask(const TaskSpec& spec, const Molecule& molecule) {
  const TaskKind* kind = findTaskKind(spec.kind);
  return kind ? kind->make(spec, molecule) : nullptr;
}

}  // namespace moltact
