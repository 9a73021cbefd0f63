#include "engine/lesson/tasks/registry.h"

#include "engine/lesson/tasks/guided.h"

// One line per kind, in the order of the authors' reference. Its function is <name>Kind(), in its own file.
#define MOLTACT_TASKS(X) \
  X(reach)               \
  X(hold)                \
  X(press)               \
  X(feel)                \
  X(cross)               \
  X(avoid)               \
  X(compare)             \
  X(meet)                \
  X(trace)               \
  X(find)                \
  X(predict)             \
  X(same)                \
  X(fit)                 \
  X(measure)             \
  X(order)               \
  X(rank)                \
  X(dock)                \
  X(pull)                \
  X(pass)                \
  X(contacts)

namespace moltact {

#define MOLTACT_DECLARE(name) TaskKind name##Kind();
MOLTACT_TASKS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

std::span<const TaskKind> taskKinds() {
#define MOLTACT_ROW(name) name##Kind(),
  static const std::vector<TaskKind> kinds{MOLTACT_TASKS(MOLTACT_ROW)};
#undef MOLTACT_ROW
  return kinds;
}

const TaskKind* findTaskKind(std::string_view name) {
  for (const TaskKind& k : taskKinds())
    if (k.name == name) return &k;
  return nullptr;
}

std::unique_ptr<Task> makeTask(const TaskSpec& spec, const Molecule& molecule) {
  const TaskKind* kind = findTaskKind(spec.kind);
  std::unique_ptr<Task> task = kind ? kind->make(spec, molecule) : nullptr;
  return task && hasGuide(spec) ? makeGuided(spec, std::move(task), molecule) : std::move(task);
}

}  // namespace moltact
