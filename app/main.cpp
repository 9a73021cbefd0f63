// The entry point: runs a command without a window, or opens the window if there is none.
#include <exception>
#include <new>

#include "app/commands/command.h"
#include "app/commands/language_option.h"
#include "app/window_options.h"
#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace {

int run(int argc, char** argv) {
  CLI::App app{"Moltact: learn structural biology by touching molecules", "moltact"};
  app.set_version_flag("--version", MOLTACT_VERSION);
  moltact::WindowArguments window;
  moltact::addWindowArguments(app, window);
  moltact::addAllCommands(app);
  moltact::addImd(app, window);
  // Error messages contain the text that was typed.
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return moltact::oneLine(e.what()) + "\nRun with --help for more information.\n";
  });
  moltact::selectLanguage();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e, moltact::cleanOut(), moltact::cleanErr()) == 0 ? 0 : 2;
  }
  if (app.get_subcommands().empty() || app.got_subcommand("imd")) return moltact::runWindowArguments(window);
  return 0;
}

// Converts an exception of a command to a message and an exit status.
int runCommand(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const moltact::CommandError& e) {
    moltact::err() << "moltact: " << e.text << '\n';
    return e.status;
  } catch (const moltact::CommandFailed&) {
    return 1;
  } catch (const std::bad_alloc&) {
    moltact::err() << "moltact: "
                   << moltact::tr("not enough memory for this; close other programs, or take a smaller file") << '\n';
  } catch (const std::exception& e) {
    moltact::err() << "moltact: " << moltact::trf("it could not go on: {0}", e.what()) << '\n';
  }
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const moltact::CrashStack crash_stack;
  moltact::takeSizeLimitsAsErrors();
  const int status = runCommand(argc, argv);
  if (moltact::terminalWritten()) return status;
  moltact::err() << "moltact: not all of this could be printed; is there room on the disk that it goes to?\n";
  return status ? status : 1;
}
