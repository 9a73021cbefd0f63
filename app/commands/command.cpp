#include "app/commands/command.h"

namespace moltact {

void addBench(CLI::App& app);
void addFetch(CLI::App& app);
void addInfo(CLI::App& app);
void addRender(CLI::App& app);
void addReplay(CLI::App& app);

void addAllCommands(CLI::App& app) {
  addInfo(app);
  addReplay(app);
  addRender(app);
  addFetch(app);
  addBench(app);
}

}  // namespace moltact
