// The program's entry: a command on the line runs without a window; none opens the window.
#include <exception>
#include <iostream>
#include <new>

#include "app/commands/command.h"
#include "app/window_options.h"
#include "engine/platform/force_hold.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Moltact: learn structural biology by touching molecules", "moltact"};
  app.set_version_flag("--version", MOLTACT_VERSION);
  moltact::WindowArguments window;
  moltact::addWindowArguments(app, window);
  moltact::addAllCommands(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  if (app.get_subcommands().empty()) return moltact::runWindowArguments(window);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const moltact::CrashStack crash_stack;
  try {
    return run(argc, argv);
  } catch (const moltact::CommandError& e) {
    std::cerr << "moltact: " << e.text << '\n';
    return e.status;
  } catch (const moltact::CommandFailed&) {
    return 1;
  } catch (const std::bad_alloc&) {
    std::cerr << "moltact: not enough memory for this; close other programs, or take a smaller file\n";
  } catch (const std::exception& e) {
    std::cerr << "moltact: it could not go on: " << e.what() << '\n';
  }
  return 1;
}
