// `moltact report`: reads the attempts of a class and writes a table for spreadsheets and a page.
#include <chrono>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_files.h"
#include "engine/results/class_page.h"

namespace moltact {
namespace {

struct Arguments {
  std::vector<std::string> results;
  std::string csv, html, gradebook, code_word;
  bool anonymous = false;
};

void write(const std::string& file, const std::string& bytes) {
  if (const auto problem = writeWhole(file, bytes)) throw CommandError{problem->text()};
}

void run(const Arguments& arguments) {
  const std::vector<std::filesystem::path> named(arguments.results.begin(), arguments.results.end());
  const ClassReading reading = readClass(
      named, {.anonymous = arguments.anonymous || !arguments.code_word.empty(), .code_word = arguments.code_word});
  for (const Problem& p : reading.passed_over) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  const ClassSummary& summary = reading.summary;
  if (summary.attempts == 0) throw CommandError{tr("there are no attempts to report on in what was named")};
  checkOutputs({{"--csv", arguments.csv}, {"--html", arguments.html}, {"--gradebook", arguments.gradebook}});
  if (!arguments.gradebook.empty()) write(arguments.gradebook, gradebookCsv(summary));
  if (!arguments.csv.empty()) write(arguments.csv, classCsv(summary));
  if (!arguments.html.empty()) {
    const std::string now = utcText(std::chrono::system_clock::now());
    write(arguments.html,
          classPage(summary, reading.passed_over, now.substr(0, 10) + " " + now.substr(11, 5) + " UTC"));
  }
  out() << summaryText(summary) << '\n';
}

}  // namespace

void addReport(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("report", "Report on a class: who finished what, answers, time, force and path");
  auto arguments = std::make_shared<Arguments>();
  command
      ->add_option("results", arguments->results,
                   "Attempts (.jsonl files), or folders of attempts, including their subfolders")
      ->type_name(kFilesOrFoldersType)
      ->required();
  command->add_option("--csv", arguments->csv, "Write the table to this file: a row for each student and lesson")
      ->type_name(kFileType);
  command
      ->add_option("--html", arguments->html,
                   "Write the page to this file: charts, light, dark and print, works offline")
      ->type_name(kFileType);
  command
      ->add_option(
          "--gradebook", arguments->gradebook,
          "Write marks for a learning platform to this file: a row for each named student, a column for each lesson")
      ->type_name(kFileType);
  command->add_flag("--anonymous", arguments->anonymous, "Replace names by S01, S02 ...");
  command
      ->add_option("--code-word", arguments->code_word,
                   "Replace names by codes computed from the name and WORD, the same in every report with that WORD")
      ->type_name("WORD");
  command->callback([arguments] {
    if (arguments->csv.empty() && arguments->html.empty() && arguments->gradebook.empty())
      throw CLI::RequiredError("--csv, --html or --gradebook");
    run(*arguments);
  });
}

}  // namespace moltact
