// `moltact study PLAN`: makes the packs or pages of a study from its plan (docs/study.md).
#include <filesystem>
#include <memory>
#include <system_error>

#include "app/commands/command.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_page.h"
#include "engine/pack/study_pages.h"
#include "engine/pack/study_plan.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct StudyArguments {
  std::string plan, out, page;
  bool packs = false;
};

struct Output {
  fs::path file;
  std::string bytes, note;
};

void report(const std::vector<Problem>& problems, bool warnings) {
  for (const Problem& p : problems) err() << "moltact: " << (warnings ? trf("note: {0}", p.text()) : p.text()) << '\n';
}

std::string editionText(const fs::path& edition) {
  if (edition.empty())
    throw CommandError{
        tr("there is no browser edition here to make pages of; make it with './run.sh web', name one with --page, or "
           "write "
           "packs with --packs")};
  Expected<std::string> text = readFile(edition, kMaxPageBytes, tr("name the moltact.html of the browser edition"));
  if (!text) throw CommandError{text.problem().text()};
  return *std::move(text);
}

std::string taken(Expected<std::string> page) {
  if (!page) throw CommandError{page.problem().text()};
  return *std::move(page);
}

std::vector<Output> outputsOf(const StudyArguments& arguments, const StudyPlan& plan, const StudyPacks& study) {
  const fs::path folder = arguments.out;
  std::vector<Output> out;
  const fs::path edition = arguments.page.empty() ? browserEdition() : fs::path(arguments.page);
  const std::string page = arguments.packs ? std::string() : editionText(edition);
  const std::vector<DrawnStudent> students = plan.draws ? drawStudents(plan) : std::vector<DrawnStudent>();
  for (const StudyPack& pack : study.packs) {
    const std::string note = pack.group.empty() ? tr("every group, the delayed test") : trf("group {0}", pack.group);
    if (arguments.packs)
      out.push_back({folder / (pack.name + kPackEnding), pack.bytes, note});
    else if (!plan.draws || pack.group.empty())
      out.push_back(
          {folder / (pack.name + ".html"), taken(pageWithPack(page, edition.string(), pack.name, pack.bytes)), note});
  }
  if (!plan.draws) return out;
  if (!arguments.packs)
    out.push_back({folder / (plan.study + ".html"),
                   taken(pageWithDraw(page, edition.string(), plan, study.packs, students)),
                   tr("every group, assigned by the code")});
  out.push_back({folder / (plan.study + "-codes.csv"), drawTable(plan, students),
                 trf("{0} codes and their groups; students see only their code", students.size())});
  return out;
}

void run(const StudyArguments& arguments) {
  const StudyPlanReading reading = readStudyPlan(arguments.plan);
  report(reading.errors, false);
  if (!reading.plan) throw CommandError{tr("nothing was made; correct the errors above")};
  const StudyPacks study = packStudy(*reading.plan);
  report(study.warnings, true);
  report(study.errors, false);
  if (!study.errors.empty()) throw CommandError{tr("nothing was made; correct the errors above")};
  const std::vector<Output> outputs = outputsOf(arguments, *reading.plan, study);
  std::vector<NamedOutput> named;
  for (const Output& o : outputs) named.push_back({"--out", o.file.string()});
  checkOutputs(named);
  std::error_code failed;
  if (!arguments.out.empty()) fs::create_directories(arguments.out, failed);
  for (const Output& o : outputs) {
    if (const auto problem = writeWhole(o.file, o.bytes)) throw CommandError{problem->text()};
    out() << o.file.string() << ": " << o.note << '\n';
  }
}

}  // namespace

void addStudy(CLI::App& app) {
  auto arguments = std::make_shared<StudyArguments>();
  CLI::App* command = app.add_subcommand("study", "Make the pages of a study from its plan: tests, lessons by group");
  command->add_option("plan", arguments->plan, "The plan (.md)")->type_name(kFileType)->required();
  command->add_option("-o,--out", arguments->out, "Output folder (default: the current one)")->type_name(kFolderType);
  command->add_flag("--packs", arguments->packs,
                    "Write packs (.moltact) for the desktop program, for haptic devices, instead of pages");
  command
      ->add_option("--page", arguments->page,
                   "The browser edition to use (default: the moltact.html that was built or installed)")
      ->type_name(kFileType);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
