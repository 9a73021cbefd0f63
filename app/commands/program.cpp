#include "app/commands/program.h"

#include <exception>
#include <new>

#include "app/commands/command.h"
#include "app/commands/language_option.h"
#include "engine/language/catalogue.h"
#include "engine/platform/file_guard.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

int guarded(const std::function<int()>& work) {
  try {
    return work();
  } catch (const CommandError& e) {
    err() << "moltact: " << e.text << '\n';
    return e.status;
  } catch (const CommandFailed&) {
    return 1;
  } catch (const std::bad_alloc&) {
    err() << "moltact: " << tr("not enough memory for this; close other programs, or take a smaller file") << '\n';
  } catch (const std::exception& e) {
    err() << "moltact: " << trf("it could not go on: {0}", e.what()) << '\n';
  }
  return 1;
}

}  // namespace

int runMain(const std::function<int()>& work) {
  const CrashStack crash_stack;
  takeSizeLimitsAsErrors();
  const int status = guarded(work);
  if (terminalWritten()) return status;
  err() << "moltact: not all of this could be printed; is there room on the disk that it goes to?\n";
  return status ? status : 1;
}

std::optional<int> parsed(CLI::App& app, int argc, char** argv) {
  app.set_version_flag("--version", MOLTACT_VERSION);
  // Error messages contain the text that was typed.
  app.failure_message([](const CLI::App*, const CLI::Error& e) {
    return oneLine(e.what()) + "\nRun with --help for more information.\n";
  });
  selectLanguage();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e, cleanOut(), cleanErr()) == 0 ? 0 : 2;
  }
  return std::nullopt;
}

void completeCommand(CLI::App& command) {
  addLanguageOption(command);
  command.preparse_callback([](std::size_t) { static const FileGuard inputs_stay; });
}

}  // namespace moltact
