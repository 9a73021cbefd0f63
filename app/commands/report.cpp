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
#include "engine/results/study_csv.h"
#include "engine/results/study_page.h"

namespace moltact {
namespace {

struct Arguments {
  std::vector<std::string> results;
  std::string csv, html, gradebook, code_word;
  bool anonymous = false, study = false;
};

void write(const std::string& file, const std::string& bytes) {
  if (const auto problem = writeWhole(file, bytes)) throw CommandError{problem->text()};
}

std::string nowText() {
  const std::string now = utcText(std::chrono::system_clock::now());
  return now.substr(0, 10) + " " + now.substr(11, 5) + " UTC";
}

// The results of a study, with the codebook beside its table.
void reportStudy(const Arguments& arguments, const std::vector<std::filesystem::path>& named) {
  StudyCount count(arguments.anonymous);
  const std::vector<Problem> passed_over = forEachAttempt(named, [&](const Attempt& attempt) { count.add(attempt); });
  for (const Problem& p : passed_over) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  const Expected<StudyData> study = count.finish();
  if (!study) throw CommandError{study.problem().text()};
  std::filesystem::path codebook = arguments.csv;
  codebook.replace_extension("codebook.csv");
  std::vector<NamedOutput> outputs{{"--html", arguments.html}, {"--csv", arguments.csv}};
  if (!arguments.csv.empty()) outputs.push_back({"--csv", codebook.string()});
  checkOutputs(outputs);
  if (!arguments.csv.empty()) {
    write(arguments.csv, studyCsv(*study));
    write(codebook.string(), studyCodebook());
  }
  if (!arguments.html.empty()) write(arguments.html, studyPage(*study, passed_over, nowText()));
  out() << trf("{0}: {1} students in {2} groups, {3} attempts", study->name, study->students.size(),
               study->groups.size(), study->attempts)
        << '\n';
}

void run(const Arguments& arguments) {
  const std::vector<std::filesystem::path> named(arguments.results.begin(), arguments.results.end());
  if (arguments.study) return reportStudy(arguments, named);
  const ClassReading reading = readClass(
      named, {.anonymous = arguments.anonymous || !arguments.code_word.empty(), .code_word = arguments.code_word});
  for (const Problem& p : reading.passed_over) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  const ClassSummary& summary = reading.summary;
  if (summary.attempts == 0) throw CommandError{tr("there are no attempts to report on in what was named")};
  checkOutputs({{"--csv", arguments.csv}, {"--html", arguments.html}, {"--gradebook", arguments.gradebook}});
  if (!arguments.gradebook.empty()) write(arguments.gradebook, gradebookCsv(summary));
  if (!arguments.csv.empty()) write(arguments.csv, classCsv(summary));
  if (!arguments.html.empty()) write(arguments.html, classPage(summary, reading.passed_over, nowText()));
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
  CLI::Option* gradebook = command
                               ->add_option("--gradebook", arguments->gradebook,
                                            "Write marks for a learning platform to this file: a row for each named "
                                            "student, a column for each lesson")
                               ->type_name(kFileType);
  command->add_flag("--anonymous", arguments->anonymous, "Replace names by S01, S02 ...");
  CLI::Option* code_word =
      command
          ->add_option(
              "--code-word", arguments->code_word,
              "Replace names by codes computed from the name and WORD, the same in every report with that WORD")
          ->type_name("WORD");
  command
      ->add_flag("--study", arguments->study,
                 "Report on a study (moltact study): gains, effect sizes and the tests' questions; --csv is then a row "
                 "for each student and question, with a codebook beside it")
      ->excludes(gradebook)
      ->excludes(code_word);
  command->callback([arguments] {
    if (arguments->csv.empty() && arguments->html.empty() && arguments->gradebook.empty())
      throw CLI::RequiredError("--csv, --html or --gradebook");
    run(*arguments);
  });
}

}  // namespace moltact
