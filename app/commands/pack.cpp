// moltact pack LESSON: writes one file for distribution. The program opens it as a pack, a browser opens it as a page,
// or a learning platform takes it as a course.
#include <filesystem>
#include <memory>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_lesson.h"
#include "engine/pack/pack_page.h"
#include "engine/pack/platform_pack.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/results/translation_shape.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct PackArguments {
  std::string lesson, out, page;
  std::string scorm;  // "1.2" or "2004"; empty: no SCORM
  bool html = false, cmi5 = false;

  std::optional<LearningPlatform> platform() const {
    if (cmi5) return LearningPlatform::Cmi5;
    if (scorm.empty()) return std::nullopt;
    return scorm == "2004" ? LearningPlatform::Scorm2004 : LearningPlatform::Scorm12;
  }
};

std::string sizeText(std::size_t bytes) { return std::to_string((bytes + 1023) / 1024) + " kB"; }

PlatformCourse courseOf(const fs::path& file) {
  const LessonReading reading = readLesson(file);
  PlatformCourse out;
  out.name = file.stem().string();
  if (!reading.lesson) return out;  // it was packed, so it can be read
  out.title = reading.lesson->title;
  out.description = reading.lesson->description;
  out.language = reading.lesson->language.empty() ? lessonName(file).language : reading.lesson->language;
  out.goals = reading.lesson->goals;
  return out;
}

// Translations whose steps, tasks or questions are not those of the lesson.
std::vector<Problem> differingTranslations(const fs::path& lesson, const std::vector<std::string>& packed) {
  std::vector<Problem> out;
  const LessonReading reading = readLesson(lesson);
  for (const std::string& name : packed) {
    const fs::path file(name);
    if (!reading.lesson || file.has_parent_path() || file == lesson.filename() ||
        lower(file.extension().string()) != ".md" || lessonName(file).id != lessonName(lesson).id)
      continue;
    const fs::path whole = lesson.parent_path() / file;
    const LessonReading translation = readLesson(whole);
    if (!translation.lesson) continue;
    if (auto fault = translationFault(*reading.lesson, lesson.filename().string(), *translation.lesson, whole.string()))
      out.push_back(*std::move(fault));
  }
  return out;
}

// The browser edition with the pack embedded; for a learning platform in a zip with its manifest.
std::string page(const PackArguments& arguments, const fs::path& lesson, const std::string& pack) {
  const fs::path edition = arguments.page.empty() ? browserEdition() : fs::path(arguments.page);
  if (edition.empty())
    throw CommandError{tr(
        "there is no browser edition here to put the lesson into; make it with './run.sh web', or name a moltact.html "
        "with --page")};
  Expected<std::string> text = readFile(edition, kMaxPageBytes, tr("name the moltact.html of the browser edition"));
  if (!text) throw CommandError{text.problem().text()};
  const std::optional<LearningPlatform> platform = arguments.platform();
  Expected<std::string> whole = platform
                                    ? platformZip(*platform, courseOf(lesson), *std::move(text), edition.string(), pack)
                                    : pageWithPack(*std::move(text), edition.string(), lesson.stem().string(), pack);
  if (!whole) throw CommandError{whole.problem().text()};
  return *std::move(whole);
}

std::string endingOf(std::optional<LearningPlatform> platform, bool html) {
  if (!platform) return html ? ".html" : kPackEnding;
  switch (*platform) {
    case LearningPlatform::Scorm12:
      return ".scorm12.zip";
    case LearningPlatform::Scorm2004:
      return ".scorm2004.zip";
    case LearningPlatform::Cmi5:
      return ".cmi5.zip";
  }
  return ".zip";
}

void run(const PackArguments& arguments) {
  const fs::path lesson = arguments.lesson;
  if (lower(lesson.extension().string()) != ".md")
    throw CommandError{trf("{0} is no lesson; name a file that ends in .md", arguments.lesson)};
  const PackedLesson packed = packLesson(lesson);
  for (const Problem& p : packed.warnings) err() << "moltact: " << trf("note: {0}", p.text()) << '\n';
  for (const Problem& p : packed.errors) err() << "moltact: " << p.text() << '\n';
  if (!packed.pack) throw CommandError{tr("nothing was packed; correct the errors above")};
  const std::optional<LearningPlatform> platform = arguments.platform();
  if (platform) {
    const std::vector<Problem> faults = differingTranslations(lesson, packed.pack->files);
    for (const Problem& p : faults) err() << "moltact: " << p.text() << '\n';
    if (!faults.empty()) throw CommandError{tr("nothing was packed; correct the errors above")};
  }
  const bool html = arguments.html || !arguments.page.empty() || platform;
  fs::path out_file = arguments.out;
  if (out_file.empty()) out_file = fs::path(lesson).replace_extension(endingOf(platform, html));
  checkOutputs({{"--out", out_file}});
  const std::string bytes = html ? page(arguments, lesson, packed.pack->bytes) : packed.pack->bytes;
  if (const auto problem = writeWhole(out_file, bytes)) throw CommandError{problem->text()};
  out() << out_file.string() << " is written (" << sizeText(bytes.size()) << "):\n";
  for (const std::string& name : packed.pack->files) out() << "  " << name << '\n';
  for (const std::string& name : packed.pack->library)
    out() << "  " << name << " is not packed: every Moltact has it\n";
}

}  // namespace

void addPack(CLI::App& app) {
  auto arguments = std::make_shared<PackArguments>();
  CLI::App* command = app.add_subcommand(
      "pack", "Pack a lesson with its translations, molecules and pictures into one file (.moltact)");
  command->add_option("lesson", arguments->lesson, "The lesson (.md); it is checked first")
      ->type_name(kFileType)
      ->required();
  command->add_option("-o,--out", arguments->out, "Output file (default: LESSON.moltact beside the lesson)")
      ->type_name(kFileType);
  CLI::Option* html = command->add_flag("--html", arguments->html,
                                        "Write a page that contains the program, LESSON.html, for any browser");
  CLI::Option* scorm =
      command
          ->add_option(
              "--scorm", arguments->scorm,
              "Write a zip for a learning platform, LESSON.scorm12.zip: SCORM 1.2, which every platform takes, "
              "or 2004 (4th edition)")
          ->type_name("[1.2|2004]")
          ->expected(0, 1)
          ->check(CLI::Validator(
              [](const std::string& edition) {
                return edition.empty() || edition == "1.2" || edition == "2004"
                           ? std::string()
                           : "'" + edition + "' is no edition of SCORM: write --scorm 1.2 or --scorm 2004, " +
                                 "or the lesson before --scorm";
              },
              ""))
          ->excludes(html);
  command
      ->add_flag("--cmi5", arguments->cmi5,
                 "Write a zip for a learning platform with a record store (xAPI), LESSON.cmi5.zip")
      ->excludes(html)
      ->excludes(scorm);
  command
      ->add_option("--page", arguments->page,
                   "The browser edition to use (default: the moltact.html that was built or installed)")
      ->type_name(kFileType);
  command->callback([arguments, scorm] {
    if (scorm->count() > 0 && arguments->scorm.empty()) arguments->scorm = "1.2";
    run(*arguments);
  });
}

}  // namespace moltact
