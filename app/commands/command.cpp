#include "app/commands/command.h"

#include "app/commands/program.h"

// One line per command, in the order of `moltact --help`. The function add<Name>(CLI::App&) is in the command's own
// file.
#define MOLTACT_COMMANDS(X) \
  X(Info)                   \
  X(Replay)                 \
  X(Play)                   \
  X(Render)                 \
  X(Export)                 \
  X(Fetch)                  \
  X(Grid)                   \
  X(Scan)                   \
  X(Simulate)               \
  X(Modes)                  \
  X(Report)                 \
  X(Forget)                 \
  X(Study)                  \
  X(Class)                  \
  X(Kit)                    \
  X(Bench)                  \
  X(Devices)                \
  X(Device)                 \
  X(Check)                  \
  X(NewLesson)              \
  X(Pack)                   \
  X(LessonReference)        \
  X(ManualPage)             \
  X(Completion)

namespace moltact {

#define MOLTACT_DECLARE(Name) void add##Name(CLI::App& app);
MOLTACT_COMMANDS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

void addAllCommands(CLI::App& app) {
#define MOLTACT_ADD(Name) add##Name(app);
  MOLTACT_COMMANDS(MOLTACT_ADD)
#undef MOLTACT_ADD
  for (CLI::App* command : app.get_subcommands({})) completeCommand(*command);
}

}  // namespace moltact
