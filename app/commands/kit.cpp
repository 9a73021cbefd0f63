// moltact kit LESSON: writes a lesson's teacher's kit as a page for printing.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/kit_page.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/teachers_kit.h"
#include "engine/platform/folders.h"
#include "engine/platform/terminal.h"
#include "engine/platform/use_language.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct KitArguments {
  std::vector<std::string> lessons;
  std::string folder = ".";
  bool students = false, language_given = false;
};

// The file itself if its name has a language and none was asked for; else the same lesson in the language in use.
fs::path inChosenLanguage(const fs::path& file, bool language_given) {
  const LessonName name = lessonName(file);
  if (!name.language.empty() && !language_given) return file;
  std::vector<fs::path> same;
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".md" && lessonName(it->path()).id == name.id)
      same.push_back(file.parent_path() / it->path().filename());
  same = inLanguage(std::move(same), language());
  return same.empty() ? file : same.front();
}

std::vector<fs::path> lessonsNamed(const std::string& named, bool language_given) {
  std::error_code error;
  if (fs::is_directory(named, error)) {
    LessonFolder folder = lessonsIn(named);
    if (folder.fault) throw CommandError{folder.fault->text()};
    return inLanguage(std::move(folder.lessons), language());
  }
  fs::path file = named;
  if (!fs::exists(file, error) && !file.has_parent_path()) {
    const fs::path shipped = lessonsFolder() / (file.has_extension() ? named : named + ".md");
    if (fs::exists(shipped, error)) file = shipped;
  }
  return {inChosenLanguage(file, language_given)};
}

void writeKit(const fs::path& lesson_file, const KitArguments& arguments) {
  const LessonReading reading = readLesson(lesson_file);
  if (!reading.lesson) {
    for (const Problem& p : reading.errors) err() << "moltact: " << p.text() << '\n';
    throw CommandError{trf("{0} has errors, so no kit was written", lesson_file.string())};
  }
  std::string lesson_language = lessonName(lesson_file).language;
  if (lesson_language.empty()) lesson_language = reading.lesson->language;
  if (!arguments.language_given && !lesson_language.empty() && lesson_language != language())
    if (const auto problem = useLanguage(lesson_language)) err() << "moltact: " << problem->text() << '\n';
  const KitFor whom = arguments.students ? KitFor::Students : KitFor::Teacher;
  for (const Problem& p : kitLacks(*reading.lesson, kitOf(lesson_file)))
    err() << "moltact: " << trf("note: {0}", p.text()) << '\n';
  const Expected<std::string> page = kitPageOf(lesson_file, whom);
  if (!page) throw CommandError{page.problem().text()};
  const std::string name = kitPageName(lesson_file, whom);
  const fs::path file = arguments.folder == "." ? fs::path(name) : fs::path(arguments.folder) / name;
  if (const auto problem = writeWhole(file, *page)) throw CommandError{problem->text()};
  out() << trf("{0} is written", file.string()) << '\n';
}

void run(const KitArguments& arguments) {
  std::error_code error;
  fs::create_directories(arguments.folder, error);
  if (error)
    throw CommandError{trf("{0} cannot be made: {1}; choose another folder", arguments.folder, error.message())};
  for (const std::string& named : arguments.lessons)
    for (const fs::path& file : lessonsNamed(named, arguments.language_given)) writeKit(file, arguments);
}

}  // namespace

void addKit(CLI::App& app) {
  auto arguments = std::make_shared<KitArguments>();
  CLI::App* command = app.add_subcommand(
      "kit", "Write a lesson's teacher's kit for printing: teacher's page, worksheet and exit ticket");
  command
      ->add_option("lessons", arguments->lessons,
                   "Lessons (.md), names of the program's lessons, or folders of lessons")
      ->type_name(kFilesOrFoldersType)
      ->required();
  command->add_option("-o,--out", arguments->folder, "Folder for the pages")
      ->type_name(kFolderType)
      ->capture_default_str();
  command->add_flag("--students", arguments->students,
                    "Write only what students get, LESSON.worksheet.html: worksheet and exit ticket");
  command->callback([arguments, command] {
    arguments->language_given = command->count("--language") > 0;
    run(*arguments);
  });
}

}  // namespace moltact
