// moltact forget NAME: deletes what folders of results hold about one student.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/platform/terminal.h"
#include "engine/results/attempt_file.h"
#include "engine/results/forget_student.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct ForgetArguments {
  std::string student;
  std::vector<std::string> results;
  bool yes = false;
};

std::vector<fs::path> foldersOf(const ForgetArguments& arguments) {
  if (!arguments.results.empty()) return {arguments.results.begin(), arguments.results.end()};
  std::error_code error;
  const fs::path own = attemptsFolder();
  if (own.empty() || !fs::is_directory(own, error))
    throw CommandError{tr("there are no results on this computer; name the files or folders to search")};
  return {own};
}

void list(const std::string& title, const std::vector<fs::path>& files) {
  if (files.empty()) return;
  out() << title << ":\n";
  for (const fs::path& file : files) out() << "  " << file.string() << '\n';
}

void listTraces(const StudentTraces& traces) {
  list(tr("attempts"), traces.attempts);
  std::vector<fs::path> with_predictions;
  for (const auto& one : traces.predictions) with_predictions.push_back(one.file);
  list(tr("attempts of others, which lose this student's predictions"), with_predictions);
  list(tr("recordings of a hand, by the name of the file"), traces.recordings);
  list(tr("reports that name the student"), traces.reports);
}

// What the command does not delete, and the person has to look at.
void listRest(const StudentTraces& traces) {
  list(tr("not deleted, though it contains the name; look at it yourself"), traces.others);
  if (traces.nameless > 0)
    out() << trnf("{0} attempt has no name; if it is this student's, delete the file.",
                  "{0} attempts have no name; if one is this student's, delete the file.", traces.nameless,
                  traces.nameless)
          << '\n';
}

void run(const ForgetArguments& arguments) {
  const std::string student(trimmed(arguments.student));
  if (student.empty()) throw CommandError{tr("name the student, as in the attempts: moltact forget 'Ada Lovelace'")};
  const StudentTraces traces = tracesOf(student, foldersOf(arguments));
  for (const Problem& p : traces.passed_over) err() << "moltact: " << trf("passed over: {0}", p.text()) << '\n';
  if (!traces.alike.empty()) {
    std::string alike;
    for (const std::string& name : traces.alike) alike += (alike.empty() ? "'" : ", '") + name + "'";
    err() << "moltact: " << trf("note: there are also attempts of {0}, which is another name", alike) << '\n';
  }
  if (traces.empty()) {
    listRest(traces);
    throw CommandError{trf(
        "there is nothing of '{0}' to delete; write the name as the student gave it, and name the folders to search",
        student)};
  }
  listTraces(traces);
  if (!arguments.yes) {
    listRest(traces);
    out() << tr("Nothing is deleted yet: repeat the command with --yes.") << '\n';
    return;
  }
  const std::vector<Problem> faults = forgetStudent(traces);
  for (const Problem& p : faults) err() << "moltact: " << p.text() << '\n';
  listRest(traces);
  if (!faults.empty()) throw CommandError{tr("not everything was deleted; see above, and run the command again")};
  out() << tr("All of this is deleted. Copies elsewhere, on other computers, in backups or on a learning platform, are "
              "not. Write the reports anew with moltact report.")
        << '\n';
}

}  // namespace

void addForget(CLI::App& app) {
  auto arguments = std::make_shared<ForgetArguments>();
  CLI::App* command =
      app.add_subcommand("forget", "Delete what is kept about one student: attempts, recordings, reports");
  command->add_option("name", arguments->student, "The student's name, exactly as in the attempts")->required();
  command
      ->add_option("results", arguments->results,
                   "Files or folders to search, including subfolders (default: the attempts on this computer)")
      ->type_name(kFilesOrFoldersType);
  command->add_flag("--yes", arguments->yes, "Delete; without it the files are only listed");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
