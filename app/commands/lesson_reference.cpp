// moltact lesson-reference: prints the page docs/lesson-reference.md from the tables that the lesson reader uses.
#include "app/commands/command.h"
#include "engine/lesson/reference.h"
#include "engine/platform/terminal.h"

namespace moltact {

void addLessonReference(CLI::App& app) {
  app.add_subcommand("lesson-reference", "Print every key of a lesson as a Markdown page")->callback([] {
    out() << Lines{lessonReference()};
  });
}

}  // namespace moltact
