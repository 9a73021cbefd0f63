// The entry point: runs a command without a window, or opens the window if there is none.
#include "app/commands/bench.h"
#include "app/commands/command.h"
#include "app/commands/program.h"
#include "app/window_options.h"

int main(int argc, char** argv) {
  using namespace moltact;
  return runMain([&] {
    CLI::App app{"Moltact: learn structural biology by touching molecules", "moltact"};
    WindowArguments window;
    addWindowArguments(app, window);
    addAllCommands(app);
    addSimulations(app, window);
    setBench(nullptr, {argv, argv + argc});
    if (const std::optional<int> status = parsed(app, argc, argv)) return *status;
    if (opensWindow(app)) return runWindowArguments(window);
    return 0;
  });
}
