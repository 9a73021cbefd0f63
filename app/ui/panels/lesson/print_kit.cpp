#include "app/ui/panels/lesson/print_kit.h"

#include <filesystem>

#include "app/ui/application/application.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/kit_page.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

void writeInto(Application& app, const std::filesystem::path& lesson, const std::filesystem::path& folder) {
  const Expected<std::string> page = kitPageOf(lesson, KitFor::Teacher);
  if (!page) return app.messages.error(page.problem().text());
  const std::filesystem::path file = folder / kitPageName(lesson, KitFor::Teacher);
  if (const auto problem = writeWhole(file, *page)) return app.messages.error(problem->text());
  app.messages.notice(trf("The teacher's kit is in {0}. Open it in a browser to print it.", file.string()));
}

}  // namespace

void writeTeachersKit(Application& app) {
  app.file_dialog.ask({.title = tr("A folder for the teacher's kit"),
                       .chosen = [&app, lesson = app.lesson.file()](
                                     const std::filesystem::path& folder) { writeInto(app, lesson, folder); }},
                      app.options().attempts_folder);
}

}  // namespace moltact
