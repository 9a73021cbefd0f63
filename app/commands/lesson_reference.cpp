// moltact lesson-reference: the page docs/lesson-reference.md, from the tables with which lessons are read.
#include <iostream>

#include "app/commands/command.h"
#include "engine/lesson/reference.h"

namespace moltact {

void addLessonReference(CLI::App& app) {
  app.add_subcommand("lesson-reference", "Print every key of a lesson as a Markdown page")->callback([] { std::cout << lessonReference(); });
}

}  // namespace moltact
