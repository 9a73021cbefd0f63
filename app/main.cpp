// The program's entry: a command on the line runs without a window; none opens the window.
#include <iostream>

#include "app/commands/command.h"
#include "app/window_options.h"

int main(int argc, char** argv) {
  CLI::App app{"Moltact: learn structural biology by touching molecules", "moltact"};
  app.set_version_flag("--version", MOLTACT_VERSION);
  moltact::WindowArguments window;
  moltact::addWindowArguments(app, window);
  moltact::addAllCommands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const moltact::CommandError& e) {
    std::cerr << "moltact: " << e.text << '\n';
    return 1;
  }
  if (app.get_subcommands().empty()) return moltact::runWindowArguments(window);
  return 0;
}
