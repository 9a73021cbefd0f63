// `moltact report`: what a class did, from its attempts, as a table for spreadsheets and as a page.
#include <chrono>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"

namespace moltact {
namespace {

struct Arguments {
  std::vector<std::string> results;
  std::string csv, html;
  bool anonymous = false;
};

void write(const std::string& file, const std::string& bytes) {
  if (const auto problem = writeWhole(file, bytes)) throw CommandError{problem->text()};
}

void run(const Arguments& arguments) {
  std::vector<Attempt> attempts;
  std::vector<Problem> problems;
  for (const std::string& named : arguments.results) {
    const Expected<std::vector<std::filesystem::path>> files = attemptFiles(named);
    if (!files) {
      problems.push_back(files.problem());
      continue;
    }
    if (files->empty())
      problems.push_back(
          {named, 0, 0, tr("there are no .jsonl files in this folder"), tr("name the folder that holds the attempts")});
    for (const std::filesystem::path& file : *files) {
      Expected<Attempt> attempt = readAttempt(file, ReadDepth::NoTrace);
      if (!attempt) {
        problems.push_back(attempt.problem());
        continue;
      }
      problems.insert(problems.end(), attempt->problems.begin(), attempt->problems.end());
      attempts.push_back(*std::move(attempt));
    }
  }
  for (const Problem& p : problems) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  if (attempts.empty()) throw CommandError{tr("there are no attempts to report on in what was named")};
  const ClassSummary summary = summarise(std::move(attempts), arguments.anonymous);
  if (!arguments.csv.empty()) write(arguments.csv, classCsv(summary));
  if (!arguments.html.empty()) {
    const std::string now = utcText(std::chrono::system_clock::now());
    write(arguments.html, classPage(summary, problems, now.substr(0, 10) + " " + now.substr(11, 5) + " UTC"));
  }
  out() << summaryText(summary) << '\n';
}

}  // namespace

void addReport(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("report", "Report on a class: who finished what, answers, time, force and path");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("results", arguments->results, "attempts (.jsonl files) or folders of them")
      ->type_name(kFilesOrFoldersType)
      ->required();
  command->add_option("--csv", arguments->csv, "where to write the table: a row for each student and lesson")
      ->type_name(kFileType);
  command
      ->add_option("--html", arguments->html, "where to write the page: charts, light, dark and print, works offline")
      ->type_name(kFileType);
  command->add_flag("--anonymous", arguments->anonymous, "write S01, S02 ... in the place of names");
  command->callback([arguments] {
    if (arguments->csv.empty() && arguments->html.empty()) throw CLI::RequiredError("--csv or --html");
    run(*arguments);
  });
}

}  // namespace moltact
