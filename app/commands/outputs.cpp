#include "app/commands/outputs.h"

#include "app/commands/command.h"

namespace moltact {

void checkOutputs(const std::vector<NamedOutput>& outputs) {
  if (const auto problem = overwriteProblem(outputs)) throw CommandError{problem->text()};
}

}  // namespace moltact
