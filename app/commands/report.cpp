// `moltact report`: reads the attempts of a class and writes a table for spreadsheets and a page.
#include <algorithm>
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
  bool anonymous = false, typed_texts = false, study = false;

  NamesShown names() const {
    return {.anonymous = anonymous || !code_word.empty(), .typed_texts = typed_texts, .code_word = code_word};
  }
};

// The names of files and folders often name students.
std::vector<Problem> withoutFileNames(std::vector<Problem> problems) {
  std::vector<std::string> files;
  for (Problem& p : problems) {
    const auto known = std::find(files.begin(), files.end(), p.file);
    const std::size_t number = std::size_t(known - files.begin()) + 1;
    if (known == files.end()) files.push_back(p.file);
    p.file = trf("file {0}", number);
  }
  return problems;
}

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
  if (!arguments.html.empty())
    write(arguments.html,
          studyPage(*study, arguments.anonymous ? withoutFileNames(passed_over) : passed_over, nowText()));
  out() << trf("{0}: {1} students in {2} groups, {3} attempts", study->name, study->students.size(),
               study->groups.size(), study->attempts)
        << '\n';
}

void run(const Arguments& arguments) {
  const std::vector<std::filesystem::path> named(arguments.results.begin(), arguments.results.end());
  if (arguments.study) return reportStudy(arguments, named);
  const NamesShown names = arguments.names();
  const ClassReading reading = readClass(named, names);
  for (const Problem& p : reading.passed_over) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  const ClassSummary& summary = reading.summary;
  if (summary.attempts == 0) throw CommandError{tr("there are no attempts to report on in what was named")};
  checkOutputs({{"--csv", arguments.csv}, {"--html", arguments.html}, {"--gradebook", arguments.gradebook}});
  if (!arguments.gradebook.empty()) write(arguments.gradebook, gradebookCsv(summary));
  if (!arguments.csv.empty()) write(arguments.csv, classCsv(summary));
  if (!arguments.html.empty())
    write(arguments.html,
          classPage(summary, names.anonymous ? withoutFileNames(reading.passed_over) : reading.passed_over, nowText()));
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
  CLI::Option* anonymous =
      command->add_flag("--anonymous", arguments->anonymous,
                        "Replace names by S01, S02 ..., leave out typed texts but right answers and numbers, and give "
                        "the day only");
  CLI::Option* code_word =
      command
          ->add_option("--code-word", arguments->code_word,
                       "The same, with codes computed from the name and WORD, the same in every report with that WORD")
          ->type_name("WORD");
  CLI::Option* typed_texts =
      command->add_flag("--typed-texts", arguments->typed_texts,
                        "With --anonymous or --code-word: keep typed texts, with the names of the class replaced");
  command
      ->add_flag("--study", arguments->study,
                 "Report on a study (moltact study): gains, effect sizes and the tests' questions; --csv is then a row "
                 "for each student and question, with a codebook beside it")
      ->excludes(gradebook)
      ->excludes(code_word)
      ->excludes(typed_texts);
  command->callback([arguments, anonymous, code_word] {
    if (arguments->typed_texts && anonymous->count() == 0 && code_word->count() == 0)
      throw CLI::ValidationError("--typed-texts", "give it with --anonymous or --code-word");
    if (arguments->csv.empty() && arguments->html.empty() && arguments->gradebook.empty())
      throw CLI::RequiredError("--csv, --html or --gradebook");
    run(*arguments);
  });
}

}  // namespace moltact
