// The program's entry: a command on the line runs without a window; none opens the window.
#include <iostream>

#include "app/commands/command.h"

int main(int argc, char** argv) {
  CLI::App app{"Moltact: learn structural biology by touching molecules", "moltact"};
  app.set_version_flag("--version", MOLTACT_VERSION);
  moltact::addAllCommands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  } catch (const moltact::CommandError& e) {
    std::cerr << "moltact: " << e.text << '\n';
    return 1;
  }
  return 0;
}
