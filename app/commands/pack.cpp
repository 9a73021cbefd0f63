// moltact pack LESSON: writes one file for distribution. The program opens it as a pack, or a browser opens it as a
// page.
#include <filesystem>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_lesson.h"
#include "engine/pack/pack_page.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct PackArguments {
  std::string lesson, out, page;
  bool html = false;
};

std::string sizeText(std::size_t bytes) { return std::to_string((bytes + 1023) / 1024) + " kB"; }

// The browser edition with the pack embedded.
std::string page(const PackArguments& arguments, const fs::path& lesson, const std::string& pack) {
  const fs::path edition = arguments.page.empty() ? browserEdition() : fs::path(arguments.page);
  if (edition.empty())
    throw CommandError{tr(
        "there is no browser edition here to put the lesson into; make it with './run.sh web', or name a moltact.html "
        "with --page")};
  Expected<std::string> text = readFile(edition, kMaxPageBytes, tr("name the moltact.html of the browser edition"));
  if (!text) throw CommandError{text.problem().text()};
  Expected<std::string> whole = pageWithPack(*std::move(text), edition.string(), lesson.stem().string(), pack);
  if (!whole) throw CommandError{whole.problem().text()};
  return *std::move(whole);
}

void run(const PackArguments& arguments) {
  const fs::path lesson = arguments.lesson;
  if (lower(lesson.extension().string()) != ".md")
    throw CommandError{trf("{0} is no lesson; name a file that ends in .md", arguments.lesson)};
  const PackedLesson packed = packLesson(lesson);
  for (const Problem& p : packed.warnings) err() << "moltact: " << trf("note: {0}", p.text()) << '\n';
  for (const Problem& p : packed.errors) err() << "moltact: " << p.text() << '\n';
  if (!packed.pack) throw CommandError{tr("nothing was packed; correct the errors above")};
  const bool html = arguments.html || !arguments.page.empty();
  fs::path out_file = arguments.out;
  if (out_file.empty()) out_file = fs::path(lesson).replace_extension(html ? ".html" : kPackEnding);
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
  command->add_flag("--html", arguments->html, "Write a page that contains the program, LESSON.html, for any browser");
  command
      ->add_option("--page", arguments->page,
                   "The browser edition to use (default: the moltact.html that was built or installed)")
      ->type_name(kFileType);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
