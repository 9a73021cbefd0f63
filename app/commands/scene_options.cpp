#include "app/commands/scene_options.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/commands/command.h"
#include "engine/lesson/keys.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/second_state.h"
#include "engine/molecule/catalogue.h"
#include "engine/structure/superposition.h"
#include "engine/trajectory/frame_store.h"

namespace moltact {
namespace {

Value valueOf(std::string_view key, const std::string& text) {
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
  const auto spec = std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == key; });
  Expected<Value> read = parseValue(*spec, text);
  if (!read) throw CLI::ValidationError("--" + std::string(key), read.problem().text());
  return *std::move(read);
}

void mustSelect(std::string_view key, const Selection& atoms, const Molecule& molecule) {
  if (atoms.given() && atoms.select(molecule).empty())
    throw CLI::ValidationError("--" + std::string(key), atoms.whyEmpty(molecule).text());
}

std::vector<MarkSpec> marksOf(std::string_view key, const std::string& text, const Molecule& molecule) {
  if (text.empty()) return {};
  std::vector<MarkSpec> marks = valueOf(key, text).marks;
  for (const MarkSpec& mark : marks) mustSelect(key, mark.atoms, molecule);
  return marks;
}

// The structure of --then, and the share of the way toward it.
SecondState secondOf(const SceneOptions& options, const Molecule& molecule) {
  if (options.then.empty()) {
    if (options.state != "0%")
      throw CLI::ValidationError("--state", "there is one state only: name the other by --then");
    return {};
  }
  Expected<SecondState> read = parseSecondState(options.then);
  if (!read) throw CLI::ValidationError("--then", read.problem().text());
  mustSelect("then", read->superposed_on, molecule);
  SceneSpec scene;
  scene.then = *read;
  const std::optional<double> share = stateNamed(scene, options.state);
  if (!share)
    throw CLI::ValidationError("--state", "'" + options.state + "' is no share of the way; write one from 0% to 100%");
  read->share = *share;
  return *std::move(read);
}

// The frames of --trajectory.
std::unique_ptr<FrameStore> framesOf(const SceneOptions& options, const std::shared_ptr<const Molecule>& molecule) {
  Expected<TrajectorySpec> spec = parseTrajectory(options.trajectory);
  if (!spec) throw CLI::ValidationError("--trajectory", spec.problem().text());
  mustSelect("trajectory", spec->superposed_on, *molecule);
  FrameFit fit{spec->superposed, {}};
  if (spec->superposed_on.given()) fit.on = spec->superposed_on.select(*molecule);
  auto store = FrameStore::open(spec->file, molecule, fit);
  if (!store) throw CommandError{store.problem().text()};
  return *std::move(store);
}

// The molecule at a frame of --trajectory.
Molecule atFrame(const SceneOptions& options, Molecule molecule) {
  const auto shared = std::make_shared<const Molecule>(std::move(molecule));
  const std::unique_ptr<FrameStore> store = framesOf(options, shared);
  TrajectoryFile& file = store->file();
  const auto index = static_cast<std::size_t>(options.frame - 1);
  while (file.frames() <= index && !file.complete()) file.findMore(std::uint64_t{1} << 26);
  if (index >= file.frames())
    throw CLI::ValidationError("--frame", "the trajectory has " + std::to_string(file.frames()) + " frames");
  const auto positions = store->at(index);
  if (!positions) throw CommandError{positions.problem().text()};
  std::vector<Sphere> spheres = shared->spheres.copy();
  for (std::size_t i = 0; i < spheres.size(); ++i) spheres[i].centre_A = (**positions)[i];
  return shared->movedTo(std::move(spheres));
}

}  // namespace

std::vector<float> SceneOptions::fluctuation_A(const Molecule& molecule) const {
  if (trajectory.empty()) return {};
  const std::unique_ptr<FrameStore> store = framesOf(*this, std::make_shared<const Molecule>(molecule));
  store->file().findMore(~std::uint64_t{0} >> 1);
  auto survey = surveyTrajectory(*store, 0, store->file().frames(), kMaxSurveyed);
  if (!survey) throw CommandError{survey.problem().text()};
  return std::move(survey->fluctuation_A);
}

void SceneOptions::addMolecules(CLI::App& command) {
  command.add_option("--mark", mark, "Colours of selections: 'teal for residue 35, magenta for residue 52'");
  command.add_option("--distance", distance, "Distances between the centres of selections: 'atom 3 - atom 9'");
  command.add_option("--angle", angle, "Angles between three selections, or torsions between four");
  command.add_option("--highlight", highlight, "Selection of atoms in the colour of targets");
  command.add_option("--hydrogen-bonds", hydrogen_bonds,
                     "Hydrogen bonds with an end in the selection, as dashed lines");
  command.add_option(
      "--then", then,
      "A second structure of the molecule, toward which --state moves its atoms: '1ake', '1ake, superposed on "
      "chain A'");
  command.add_option("--state", state, "Position of the atoms between both structures: 40%")->capture_default_str();
  CLI::Option* frames = command.add_option(
      "--trajectory", trajectory,
      "A trajectory of the molecule, of which --frame moves its atoms: 'md.xtc', 'md.xtc, superposed on chain A', "
      "'md.xtc, not superposed'");
  command.add_option("--frame", frame, "Frame of the trajectory, counted from 1")
      ->needs(frames)
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
}

CLI::Option* SceneOptions::addPictures(CLI::App& command) {
  command.add_option(
      "--label", label,
      "Names in the picture: 'residue for ligand', '\"the cleft\" for residue 35 52'; the keywords are atom, "
      "residue and chain");
  command.add_option("--arrow", arrow, "Arrows with names: '\"iron\" for element Fe'");
  command.add_option("--captions", captions, "Captions below the two molecules of --beside: 'wool, silk'");
  command.add_option("--magnify", magnify, "Zoom in on a selection as a scene with the key 'magnify' does");
  command.add_option(
      "--in-hand", in_hand,
      "Selection of atoms that the hand holds as one rigid body: 'ligand'; --hip is the position of its centre");
  return command.add_option(
      "--view", view,
      "Viewpoint: 'front', 'back', 'left', 'right', 'top', 'bottom' or 'side', toward atoms ('facing residue 35'), "
      "or by angles ('turned 30 10 0'); after a comma, zoom in on atoms: 'front, zoom ligand'");
}

Molecule SceneOptions::atState(Molecule molecule, const MoleculeArgument& read) const {
  SceneSpec scene;
  scene.then = secondOf(*this, molecule);
  if (!trajectory.empty()) {
    if (!scene.then.molecule.empty())
      throw CLI::ValidationError("--trajectory", "--then moves the atoms too; leave one of them out");
    return atFrame(*this, std::move(molecule));
  }
  if (scene.then.molecule.empty()) return molecule;
  ReadOptions reading = read.named.reading;
  reading.beside.clear();
  const Expected<Molecule> other = openMolecule(scene.then.molecule, reading);
  if (!other) throw CommandError{other.problem().text()};
  const Expected<TwoStates> states = statesOf(scene, molecule, *other);
  if (!states) throw CommandError{states.problem().text()};
  return molecule.movedTo(states->at(scene.then.share));
}

SceneSpec SceneOptions::scene(const Molecule& molecule) const {
  SceneSpec scene;
  if (!view.empty()) {
    scene.view = valueOf("view", view).view;
    mustSelect("view", scene.view.facing, molecule);
    mustSelect("view", scene.view.zoom, molecule);
  }
  const auto take = [&](std::string_view key, const std::string& text, Selection& atoms) {
    if (text.empty()) return;
    atoms = valueOf(key, text).selection;
    mustSelect(key, atoms, molecule);
  };
  take("highlight", highlight, scene.highlight);
  take("magnify", magnify, scene.magnify);
  take("hydrogen-bonds", hydrogen_bonds, scene.hydrogen_bonds);
  take("in-hand", in_hand, scene.in_hand);
  if (!captions.empty()) {
    scene.captions = valueOf("captions", captions).words;
    if (molecule.beside_from == 0)
      throw CLI::ValidationError("--captions", "there is one molecule only: name the other by --beside");
    if (scene.captions.size() != 2)
      throw CLI::ValidationError("--captions", "there are two molecules to name; write two, as in 'wool, silk'");
  }
  scene.labels = marksOf("label", label, molecule);
  scene.arrows = marksOf("arrow", arrow, molecule);
  scene.marks = marksOf("mark", mark, molecule);
  for (const auto& [key, text] : {std::pair{"distance", &distance}, std::pair{"angle", &angle}}) {
    if (text->empty()) continue;
    for (PlacesSpec& measure : valueOf(key, *text).measures) {
      for (const Selection& place : measure.atoms) mustSelect(key, place, molecule);
      scene.measures.push_back(std::move(measure));
    }
  }
  return scene;
}

}  // namespace moltact
