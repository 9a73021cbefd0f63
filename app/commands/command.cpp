#include "app/commands/command.h"

namespace moltact {

void addAllCommands(CLI::App&) {
}

}  // namespace moltact
