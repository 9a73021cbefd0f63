#include "app/commands/command.h"

namespace moltact {

void addInfo(CLI::App& app);
void addFetch(CLI::App& app);

void addAllCommands(CLI::App& app) {
  addInfo(app);
  addFetch(app);
  addRenderCommand(app);
}

}  // namespace moltact
