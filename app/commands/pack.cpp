// moltact pack LESSON: one file to be handed out.
#include <filesystem>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_lesson.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct PackArguments {
  std::string lesson, out;
};

std::string sizeText(std::size_t bytes) { return std::to_string((bytes + 1023) / 1024) + " kB"; }

void run(const PackArguments& arguments) {
  const fs::path lesson = arguments.lesson;
  if (lower(lesson.extension().string()) != ".md")
    throw CommandError{trf("{0} is no lesson; name a file that ends in .md", arguments.lesson)};
  const PackedLesson packed = packLesson(lesson);
  for (const Problem& p : packed.warnings) err() << "moltact: " << trf("note: {0}", p.text()) << '\n';
  for (const Problem& p : packed.errors) err() << "moltact: " << p.text() << '\n';
  if (!packed.pack) throw CommandError{tr("nothing was packed; correct the errors above")};
  fs::path out_file = arguments.out;
  if (out_file.empty()) out_file = fs::path(lesson).replace_extension(kPackEnding);
  if (const auto problem = writeWhole(out_file, packed.pack->bytes)) throw CommandError{problem->text()};
  out() << out_file.string() << " is written (" << sizeText(packed.pack->bytes.size()) << "):\n";
  for (const std::string& name : packed.pack->files) out() << "  " << name << '\n';
  for (const std::string& name : packed.pack->library)
    out() << "  " << name << " is not packed: every Moltact has it\n";
}

}  // namespace

void addPack(CLI::App& app) {
  auto arguments = std::make_shared<PackArguments>();
  CLI::App* command = app.add_subcommand(
      "pack", "Pack a lesson with its translations, molecules and pictures into one file to hand out (.moltact)");
  command->add_option("lesson", arguments->lesson, "The lesson (.md); it is checked first")
      ->type_name(kFileType)
      ->required();
  command->add_option("-o,--out", arguments->out, "Where to write it (default: beside the lesson, LESSON.moltact)")
      ->type_name(kFileType);
  command->callback([arguments] { run(*arguments); });
}

}  // namespace moltact
