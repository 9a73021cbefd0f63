#include "app/ui/panels/lesson/class_report.h"

#include <array>
#include <chrono>
#include <filesystem>

#include "app/ui/application/application.h"
#include "engine/language/catalogue.h"
#include "engine/platform/hand_over.h"
#include "engine/platform/write_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_files.h"
#include "engine/results/class_page.h"

namespace moltact {
namespace {

void writeReport(Application& app, const std::filesystem::path& folder) {
  const std::array named{folder};
  const ClassReading reading = readClass(named);
  const ClassSummary& summary = reading.summary;
  if (summary.attempts == 0)
    return app.messages.error(trf("There are no results of students in {0}.", folder.string()));
  const std::string now = utcText(std::chrono::system_clock::now());
  const std::filesystem::path page = folder / "class.html", table = folder / "class.csv";
  const std::string made = now.substr(0, 10) + " " + now.substr(11, 5) + " UTC";
  if (const auto problem = writeWhole(page, classPage(summary, reading.passed_over, made)))
    return app.messages.error(problem->text());
  if (const auto problem = writeWhole(table, classCsv(summary))) return app.messages.error(problem->text());
  handOver(page);
  app.messages.notice(
      trf("{0}. The report is in {1}, the table in {2}.", summaryText(summary), page.string(), table.string()));
}

}  // namespace

void reportOnClass(Application& app) {
  app.file_dialog.ask({.title = tr("The folder with your class's results"),
                       .chosen = [&app](const std::filesystem::path& folder) { writeReport(app, folder); }},
                      app.options().attempts_folder);
}

}  // namespace moltact
