// moltact check FILE|PACK|FOLDER…: prints every error of lessons with its place, its line and a caret.
#include "engine/lesson/check.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/lesson_argument.h"
#include "app/commands/print_json.h"
#include "app/commands/source_excerpt.h"
#include "app/commands/value_types.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "engine/lesson/source_text.h"
#include "engine/lesson/teachers_kit.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct CheckArguments {
  std::vector<std::string> paths;
  bool json = false, play = false;
};

struct Checked {
  std::string file;
  std::string text;  ///< of the file; empty where it could not be read
  std::vector<Problem> errors, warnings;
  bool words = false;                        ///< a glossary, not a lesson
  std::optional<ShownMinutes> minutes = {};  ///< of a valid lesson
  std::vector<Problem> notes = {};           ///< what the teacher's kit of a valid lesson lacks
};

// Runs the scripted learner through the lesson and reports the touch tasks that it cannot solve.
void playLesson(const fs::path& file, const Lesson& lesson, LessonMolecules& molecules, std::vector<Problem>& errors) {
  const auto tell = [&](const LearnerEvent& e) {
    if (e.kind == LearnerEvent::Kind::GaveUp)
      errors.push_back({file.string(), e.place.line, e.place.column, trf("this task cannot be done: {0}", e.note),
                        tr("try it with 'moltact play', choose another place, or ask for less")});
    if (e.kind == LearnerEvent::Kind::Fault)
      errors.push_back({file.string(), e.place.line, e.place.column, e.note, {}});
  };
  ScriptedLearner learner(
      std::make_shared<const Lesson>(lesson), [&](const NamedMolecule& named) { return molecules.find(file, named); },
      tell);
  learner.demonstrate();
  learner.demonstrateStepsLeft();
}

Checked checkFile(const fs::path& file, LessonMolecules& molecules, bool play) {
  Checked out{file.string(), {}, {}, {}, false};
  auto bytes = readLessonFile(file);
  if (!bytes) {
    out.errors.push_back(bytes.problem());
    return out;
  }
  out.text = *bytes;
  LessonCheck check =
      checkLesson(out.file, *std::move(bytes), [&](const NamedMolecule& named) { return molecules.find(file, named); });
  if (check.lesson && check.errors.empty())
    check.errors = checkFacts(*check.lesson, [&](const NamedMolecule& named) { return molecules.find(file, named); });
  if (play && check.lesson && check.errors.empty()) playLesson(file, *check.lesson, molecules, check.errors);
  if (check.lesson) out.minutes = shownMinutes(*check.lesson);
  if (check.lesson && check.errors.empty()) out.notes = kitLacks(*check.lesson, kitOf(file));
  out.errors = std::move(check.errors);
  out.warnings = std::move(check.warnings);
  return out;
}

// A shell's "*.md" also matches a text about the lessons that contains no lesson.
bool isReadme(const fs::path& file) {
  std::error_code error;
  return lower(lessonName(file).id) == "readme" && fs::exists(file, error) && !looksLikeLesson(file);
}

// The glossaries beside the lessons and among the named files, each file once.
void checkGlossaries(std::vector<Checked>& all, std::vector<fs::path> files) {
  std::error_code error;
  for (const Checked& lesson : all) {
    const fs::path folder = fs::path(lesson.file).has_parent_path() ? fs::path(lesson.file).parent_path() : ".";
    if (lesson.text.empty() || !fs::is_directory(folder, error)) continue;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
      if (isGlossaryFile(it->path()))
        files.push_back(fs::path(lesson.file).has_parent_path() ? it->path() : it->path().filename());
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  for (const fs::path& file : files) {
    Checked out{file.string(), {}, {}, {}, false};
    if (Expected<std::string> bytes = readLessonFile(file)) {
      Glossary words = readGlossary(out.file, *bytes);
      out.errors = std::move(words.errors);
      out.warnings = std::move(words.warnings);
      out.text = *std::move(bytes);
    } else {
      out.errors.push_back(bytes.problem());
    }
    out.words = true;
    all.push_back(std::move(out));
  }
}

// Checks every lesson of a pack and reports it by its name in the pack.
void checkPack(const std::string& path, LessonMolecules& molecules, bool play, std::vector<Checked>& all) {
  const Expected<LessonArgument> argument = LessonArgument::open(path);
  if (!argument) {
    all.push_back({path, {}, {argument.problem()}, {}, false});
    return;
  }
  for (const fs::path& file : lessonsIn(argument->pack()->folder()).lessons) {
    Checked checked = checkFile(file, molecules, play);
    checked.file = argument->shown(checked.file);
    checked.notes.clear();  // packs contain no kits
    for (std::vector<Problem>* problems : {&checked.errors, &checked.warnings})
      for (Problem& p : *problems) p = argument->shown(std::move(p));
    all.push_back(std::move(checked));
  }
}

struct Row {
  const Problem* problem;
  const char* severity;
};

/// Errors and warnings of a file together, sorted by their place in the file.
std::vector<Row> rowsOf(const Checked& checked) {
  std::vector<Row> rows;
  for (const Problem& p : checked.errors) rows.push_back({&p, NC_("severity", "error")});
  for (const Problem& p : checked.warnings) rows.push_back({&p, NC_("severity", "warning")});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
    return a.problem->line != b.problem->line ? a.problem->line < b.problem->line
                                              : a.problem->column < b.problem->column;
  });
  return rows;
}

void printText(const Checked& checked) {
  const SourceText source(checked.file, checked.text);
  for (const Row& row : rowsOf(checked)) {
    const Problem& p = *row.problem;
    out() << p.file;
    if (p.line) out() << ':' << p.line << ':' << p.column;
    out() << ": " << trc("severity", row.severity) << ": " << p.message << (p.remedy.empty() ? "" : "; ") << p.remedy
          << '\n';
    if (p.line) out() << Lines{sourceExcerpt(source.line(p.line), p.column)};
  }
  for (const Problem& p : checked.notes)
    out() << p.file << (p.line ? ":" + std::to_string(p.line) + ":" + std::to_string(p.column) : "") << ": "
          << trc("severity", NC_("severity", "note")) << ": " << p.message << "; " << p.remedy << '\n';
  if (const auto& minutes = checked.minutes)
    out() << trf("{0}: {1} min for the core, {2} min with all steps", checked.file, minutes->core, minutes->all)
          << '\n';
}

nlohmann::ordered_json jsonOf(const Checked& checked) {
  auto out = nlohmann::ordered_json::array();
  for (const Row& row : rowsOf(checked)) {
    const Problem& p = *row.problem;
    out.push_back({{"file", p.file},
                   {"line", p.line},
                   {"column", p.column},
                   {"severity", row.severity},
                   {"message", p.message},
                   {"remedy", p.remedy}});
  }
  return out;
}

void run(const CheckArguments& arguments) {
  std::vector<Checked> all;
  std::vector<fs::path> passed_over, glossaries;
  LessonMolecules molecules;
  for (const std::string& path : arguments.paths) {
    std::error_code error;
    if (hasPackName(path)) {
      checkPack(path, molecules, arguments.play, all);
      continue;
    }
    if (!fs::is_directory(path, error)) {
      if (isGlossaryFile(path) && fs::exists(path, error))
        glossaries.push_back(path);
      else if (isReadme(path) || isKitFile(path))
        passed_over.push_back(path);
      else
        all.push_back(checkFile(path, molecules, arguments.play));
      continue;
    }
    LessonFolder folder = lessonsIn(path);
    if (folder.fault) all.push_back({path, {}, {*std::move(folder.fault)}, {}, false});
    for (const fs::path& file : folder.lessons) all.push_back(checkFile(file, molecules, arguments.play));
    for (const fs::path& file : folder.others)
      if (!isGlossaryFile(file) && !isKitFile(file)) passed_over.push_back(file);
  }
  checkGlossaries(all, std::move(glossaries));

  std::size_t errors = 0, warnings = 0, lessons = 0;
  for (const Checked& c : all) {
    lessons += !c.text.empty() && !c.words;
    errors += c.errors.size();
    warnings += c.warnings.size();
  }
  if (arguments.json) {
    nlohmann::ordered_json document = {{"problems", nlohmann::ordered_json::array()},
                                       {"lessons", lessons},
                                       {"errors", errors},
                                       {"warnings", warnings},
                                       {"minutes", nlohmann::ordered_json::array()},
                                       {"notes", nlohmann::ordered_json::array()}};
    for (const Checked& c : all) {
      for (auto& problem : jsonOf(c)) document["problems"].push_back(std::move(problem));
      if (c.minutes)
        document["minutes"].push_back({{"file", c.file}, {"core", c.minutes->core}, {"all", c.minutes->all}});
      for (const Problem& p : c.notes)
        document["notes"].push_back(
            {{"file", p.file}, {"line", p.line}, {"column", p.column}, {"message", p.message}, {"remedy", p.remedy}});
    }
    printDocument(document);
  } else {
    for (const Checked& c : all) printText(c);
    for (const fs::path& file : passed_over) out() << trf("{0}: no lesson, passed over", file.string()) << '\n';
    std::string found = errors ? trnf("{0} error", "{0} errors", errors, errors) : tr("no errors");
    if (warnings) found = trf("{0}, {1}", found, trnf("{0} warning", "{0} warnings", warnings, warnings));
    out() << trnf("{0} lesson checked: {1}", "{0} lessons checked: {1}", lessons, lessons, found) << '\n';
  }
  // The errors have already been printed.
  if (errors) throw CommandFailed{};
}

}  // namespace

void addCheck(CLI::App& app) {
  auto arguments = std::make_shared<CheckArguments>();
  CLI::App* command = app.add_subcommand("check", "Check lessons: list every error with its location and a remedy");
  command->add_option("paths", arguments->paths, "Lessons (.md), packs (.moltact), or folders to search for lessons")
      ->type_name(kFilesOrFoldersType)
      ->required();
  command->add_flag("--play", arguments->play,
                    "Also let a scripted hand do each touch task, and report tasks that cannot be done");
  command->add_flag("--json", arguments->json, "Print one JSON document, for editors");
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
