#include "app/commands/device_path.h"

#include <algorithm>
#include <memory>

#include "app/commands/command.h"
#include "app/commands/number_range.h"
#include "app/commands/value_types.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

struct PathOptions {
  std::string file, out;
  std::vector<std::string> labels;
  double before_touch_s = -1;
};

// The interaction of the recording, created anew. Null if its molecule, interaction or method does not exist here.
std::unique_ptr<Interaction> feltOf(const ServoRecording& recording) {
  const auto key = findMoleculeKey(labelledMolecule(recording.labels), MoleculeFolders::ofThisComputer());
  if (!key || recording.ticks.empty()) return nullptr;
  const auto molecule = readMolecule(*key);
  if (!molecule) return nullptr;
  const RecordedScene scene = recordedScene(recording.labels, molecule->spheres);
  const TouchSetup touch = touchOf(recording);
  return makeInteraction(interactionInput(touch, *molecule, scene.spheres, scene.body));
}

void run(const PathOptions& options) {
  auto path = openHandPath(options.file);
  if (!path) throw CommandError{path.problem().text()};
  for (const std::string& label : options.labels) {
    const std::size_t is = label.find('=');
    if (is == std::string::npos || is == 0)
      throw CommandError{
          Problem{"--label", 0, 0, trf("\"{0}\" is no KEY=VALUE", label), tr("write for example --label hand=Anna")}
              .text()};
    path->labels[label.substr(0, is)] = label.substr(is + 1);
  }
  if (options.before_touch_s >= 0) {
    const auto at = [&](auto it) { return std::size_t(it - path->touched.begin()); };
    const std::size_t first = at(std::find(path->touched.begin(), path->touched.end(), true));
    if (first == path->touched.size())
      throw CommandError{
          Problem{options.file, 0, 0, tr("nothing is touched in it"), tr("leave --touching out")}.text()};
    const std::size_t last = at(std::find(path->touched.rbegin(), path->touched.rend(), true).base()) - 1;
    const std::size_t begin = first - std::min(first, std::size_t(options.before_touch_s * 1000));
    path->places = {path->places.begin() + std::ptrdiff_t(begin), path->places.begin() + std::ptrdiff_t(last) + 1};
  }
  if (const auto problem = writeWhole(options.out, textOf(*path))) throw CommandError{problem->text()};
  out() << path->places.size() << " ticks in " << options.out << '\n';
}

}  // namespace

Expected<HandPath> openHandPath(const std::filesystem::path& file) {
  if (file.extension() != ".recording") return readHandPath(file);
  const auto recording = readServoRecording(file);
  if (!recording) return recording.problem();
  if (recording->ticks.empty())
    return Problem{file.string(), 0, 0, tr("the recording holds no ticks"), tr("record it again")};
  if (!recording->torn.empty()) err() << "moltact: " << recording->torn << "; the hand's way ends there\n";
  auto path = handPathOf(*recording, file.stem().string(), feltOf(*recording).get());
  if (path.places.empty())
    return Problem{file.string(), 0, 0, tr("the hand is nowhere in this recording"), tr("record it again")};
  return path;
}

void addDevicePath(CLI::App& device) {
  const auto options = std::make_shared<PathOptions>();
  CLI::App* command = device.add_subcommand(
      "path", "Write the path of a recorded hand as rows of numbers: x y z (angstrom), one row per tick");
  command->add_option("FILE", options->file, "A recording")->type_name(kFileType)->required();
  command->add_option("--out", options->out, "The file to write")->type_name(kFileType)->required();
  command->add_option("--label", options->labels, "KEY=VALUE, written to the file's header; may be repeated");
  command
      ->add_option("--touching", options->before_touch_s,
                   "Write only the part from this many seconds before the first touch to the last")
      ->check(numberFrom(0.0, 3600.0));
  command->callback([options] { run(*options); });
}

}  // namespace moltact
