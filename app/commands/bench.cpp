#include "app/commands/bench.h"

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "app/commands/command.h"
#include "app/commands/value_types.h"
#include "engine/language/catalogue.h"
#include "engine/platform/folders.h"
#include "engine/platform/run_program.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

struct Bench {
  BenchRunner runner = nullptr;
  std::vector<std::string> words;
};

Bench& bench() {
  static Bench bench;
  return bench;
}

void measure(const BenchArguments& arguments) {
  if (bench().runner) return bench().runner(arguments);
  std::error_code error;
  for (const std::filesystem::path& program : programFiles("moltact-bench")) {
    if (!std::filesystem::is_regular_file(program, error)) continue;
    std::vector<std::string> words = bench().words;
    if (words.empty()) break;
    words[0] = program.string();
    const Expected<int> status = becomeProgram(words);
    if (!status) throw CommandError{status.problem().text()};
    if (*status == 0) return;
    throw CommandFailed{};
  }
  throw CommandError{
      tr("the measurements are a program of their own, moltact-bench, which is not here; in a build from the sources, "
         "build "
         "its target: cmake --build --preset release --target moltact-bench")};
}

}  // namespace

void setBench(BenchRunner runner, std::vector<std::string> words) { bench() = {runner, std::move(words)}; }

void addBench(CLI::App& app) {
  auto arguments = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand("bench", "Measure speed, accuracy, feel and stability of every method");
  command->add_option("part", arguments->part, "tables, chart, feel, hands, stability, bodies, energies or all")
      ->capture_default_str()
      ->check(CLI::IsMember({"tables", "chart", "feel", "hands", "stability", "bodies", "energies", "all"}));
  command->add_flag("--quick", arguments->quick, "Take a minute instead of a quarter of an hour, with rougher figures");
  command
      ->add_option("--methods", arguments->methods,
                   "Measure only these methods, separated by commas (exact and exact-body are always included)")
      ->delimiter(',');
  command
      ->add_option(
          "--recording", arguments->recordings,
          "Use these recorded hands instead of the shipped ones, for the part hands only: a .recording, or rows of "
          "numbers (docs/hands.md)")
      ->type_name(kFileType);
  command
      ->add_option("--molecule", arguments->recording_molecule,
                   "The molecule of these hands, if the file does not name it")
      ->type_name(kMoleculeType);
  command
      ->add_option(
          "--page-ticks", arguments->page_ticks,
          "Add the ticks of a page to the chart of energies: what moltact_energy_ticks printed (docs/energies.md)")
      ->type_name(kFileType);
  command->add_option("--seed", arguments->seed, "Random seed of the scenes and motions")->capture_default_str();
  command->add_option("--json", arguments->json, "Write all tables to this file")->type_name(kFileType);
  command->add_option("--csv", arguments->csv, "Write each table to a file in this folder")->type_name(kFolderType);
  command->add_option("--svg", arguments->svg, "Write the charts to this folder")->type_name(kFolderType);
  command->add_option("--markdown", arguments->markdown, "Write all tables to this page")->type_name(kFileType);
  command->add_option("--docs", arguments->docs, "Regenerate the tables and charts of the pages in this folder")
      ->type_name(kFolderType);
  command->callback([arguments] {
    // The pages show only the program's own recordings.
    if (!arguments->recordings.empty() && arguments->part == "all") arguments->part = "hands";
    if (!arguments->recordings.empty() && !arguments->docs.empty()) throw CLI::ExcludesError("--recording", "--docs");
    measure(*arguments);
  });
}

}  // namespace moltact
