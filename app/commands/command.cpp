#include "app/commands/command.h"

namespace moltact {

void addAllCommands(CLI::App& app) {
  addRenderCommand(app);
}

}  // namespace moltact
