// moltact new-lesson NAME: writes a small working lesson as a starting point.
#include "engine/lesson/new_lesson.h"

#include <filesystem>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/source_text.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct NewLessonArguments {
  std::string name, folder = ".";
};

/// Writes a file that must not exist before.
void writeNew(const fs::path& file, const std::string& text) {
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error)))
    throw CommandError{trf("{0} is there already and stays as it is; choose another name", file.string())};
  const auto problem = writeWhole(file, text, IfThere::Refuse);
  if (problem) throw CommandError{trf("{0}, or choose another folder with --folder", problem->text())};
}

/// Quotes a file's name for a shell.
std::string shellWord(const std::string& word) {
  if (word.find_first_of(" '\"\\$`&;()<>|*?[]#~!") == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

void run(const NewLessonArguments& arguments) {
  const std::string name = lessonFileName(arguments.name);
  if (name.empty() || firstBadByte(arguments.name) != std::string::npos ||
      arguments.name.find_first_of("/\n") != std::string::npos)
    throw CommandError{trf(
        "'{0}' is no name for a lesson; name it in a few words, such as 'Haem pockets', and its folder with --folder",
        arguments.name)};
  std::error_code error;
  fs::create_directories(arguments.folder, error);
  if (error)
    throw CommandError{trf("{0} cannot be made: {1}; choose another folder", arguments.folder, error.message())};
  const fs::path file = arguments.folder == "." ? fs::path(name) : fs::path(arguments.folder) / name;
  writeNew(file, newLessonText(lessonTitle(arguments.name)));
  const std::string word = shellWord(file.string());
  out() << file.string() << " is written. What to do now:\n"
        << "  moltact " << word << "          see it; it is read again each time you save it\n"
        << "  moltact check " << word << "    what is wrong with it, and what would mend it\n"
        << "  moltact info MOLECULE" << std::string(word.size() > 8 ? word.size() - 8 : 0, ' ')
        << "    the chains, residues and ligands that you can name\n"
        << "docs/write-a-lesson.md explains how to write lessons.\n";
}

}  // namespace

void addNewLesson(CLI::App& app) {
  auto arguments = std::make_shared<NewLessonArguments>();
  CLI::App* command = app.add_subcommand("new-lesson", "Write a small working lesson to start from");
  command
      ->add_option("name", arguments->name, "Name of the lesson, such as 'Haem pockets'; the file is haem-pockets.md")
      ->required();
  command->add_option("--folder", arguments->folder, "Folder for the new file")
      ->type_name(kFolderType)
      ->capture_default_str();
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
