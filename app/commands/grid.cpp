// moltact grid MOLECULE: computes maps of its energies in AutoGrid's format.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>

#include "app/commands/atoms_option.h"
#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/value_types.h"
#include "engine/haptics/field/compute_grid.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/structure/amber/amber.h"
#include "engine/structure/amber/pair_atoms.h"
#include "engine/structure/map_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// The maps by AutoDock's names of atom types, each with the AMBER type whose parameters it has.
struct GridType {
  const char *name, *amber;
};
constexpr std::array kGridTypes{GridType{"C", "CT"}, GridType{"A", "CA"}, GridType{"N", "N"},
                                GridType{"OA", "O"}, GridType{"SA", "S"}, GridType{"HD", "H"}};

struct GridArguments {
  MoleculeArgument molecule;
  std::string around, like, out, dielectric{dielectricChoices().front().name};
  std::vector<double> box;
  std::vector<std::string> compared;  // files of maps
  double margin_A = 4.0, spacing_A = 0.375;
  int threads = 0;
};

Expected<GridBox> gridBoxOf(const GridArguments& a, const Molecule& molecule, std::vector<char>& excluded) {
  const std::string& like = a.compared.empty() ? a.like : a.compared.front();
  if (!like.empty()) {
    for (const std::uint32_t i : selectedAtoms("--around", a.around, molecule)) excluded[i] = 1;
    const auto map = readMapFile(like);
    if (!map) return map.problem();
    return map->box;
  }
  if (!a.box.empty()) {
    const Vec3 centre(a.box[0], a.box[1], a.box[2]), half = 0.5 * Vec3(a.box[3], a.box[4], a.box[5]);
    if (!(half.x >= 0 && half.y >= 0 && half.z >= 0))
      throw CLI::ValidationError("--box", "an edge is below 0; give the centre and the edges: X Y Z DX DY DZ");
    return mapBoxRound(centre - half, centre + half, a.spacing_A);
  }
  std::vector<std::uint32_t> atoms = selectedAtoms("--around", a.around, molecule);
  for (const std::uint32_t i : atoms) excluded[i] = 1;
  Vec3 low(1e300), high(-1e300);
  const auto include = [&](std::size_t i) {
    low = glm::min(low, molecule.spheres[i].centre_A);
    high = glm::max(high, molecule.spheres[i].centre_A);
  };
  for (const std::uint32_t i : atoms) include(i);
  if (atoms.empty())
    for (std::size_t i = 0; i < molecule.spheres.size(); ++i) include(i);
  return mapBoxRound(low - Vec3(a.margin_A), high + Vec3(a.margin_A), a.spacing_A);
}

// The maps of kGridTypes and the electrostatic one, by their names, on one box.
struct NamedMaps {
  GridBox box;
  std::vector<std::string> names;
  std::vector<std::span<const float>> values;
};

// Prints how well each map that another program computed follows ours, outside the walls.
void compareMaps(const std::vector<std::string>& files, const NamedMaps& ours) {
  for (const std::string& file : files) {
    const auto map = readMapFile(file);
    if (!map) throw CommandError{map.problem().text()};
    // OUT.TYPE.map
    const std::string type = fs::path(file).stem().extension().string();
    const auto name = std::find(ours.names.begin(), ours.names.end(), type.empty() ? type : type.substr(1));
    if (name == ours.names.end())
      throw CommandError{trf(
          "{0}: the file's name must end in the type of the map: .C.map, .A.map, .N.map, .OA.map, .SA.map, .HD.map or "
          ".e.map",
          file)};
    if (!(map->box == ours.box))
      throw CommandError{
          trf("{0}: the box differs from that of {1}; compare the files one by one", file, files.front())};
    const std::span<const float> carbon = ours.values.front();
    const MapAgreement found = mapAgreement(map->values, ours.values[std::size_t(name - ours.names.begin())],
                                            [&](std::size_t node) { return carbon[node] < 0.0f; });
    if (found.points == 0)
      throw CommandError{
          trf("{0}: no point of the box is outside the walls; does the map belong to this molecule?", file)};
    char text[160];
    std::snprintf(text, sizeof text, "%zu points, correlation %.4f, factor %.4f, rms difference %.3g, largest %.3g",
                  found.points, found.correlation, found.factor, found.rms, found.largest);
    out() << file << ": " << text << (*name == "e" ? " kcal/mol/e\n" : " kcal/mol\n");
  }
}

void writeGridFile(const fs::path& file, const std::string& text) {
  if (const auto problem = writeWhole(file, text)) throw CommandError{problem->text()};
}

void runGrid(const GridArguments& a) {
  const Molecule molecule = a.molecule.load();
  std::vector<char> excluded(molecule.atoms.size());
  const auto box = gridBoxOf(a, molecule, excluded);
  if (!box) throw CommandError{box.problem().text()};
  const fs::path stem = a.out;
  std::vector<std::string> names;
  for (const GridType& type : kGridTypes) names.push_back(type.name);
  names.push_back("e");
  const auto fileOf = [&](const std::string& ending) { return fs::path(stem.string() + ending); };
  if (a.out.empty() && a.compared.empty())
    throw CLI::RequiredError("--out OUT, where the maps go, or --compare FILE.map");
  std::vector<NamedOutput> outputs;
  for (const std::string& name : names) outputs.push_back({"--out", fileOf("." + name + ".map")});
  outputs.push_back({"--out", fileOf(".maps.fld")});
  outputs.push_back({"--out", fileOf(".maps.xyz")});
  if (!a.out.empty()) checkOutputs(outputs);

  const PairAtoms all = pairAtoms(molecule);
  std::vector<PairAtom> atoms;
  std::vector<Sphere> places;
  for (std::size_t i = 0; i < all.atoms.size(); ++i) {
    if (excluded[all.carrier[i]]) continue;
    atoms.push_back(all.atoms[i]);
    places.push_back({all.atoms[i].centre_A, 1.0});
  }
  if (atoms.empty()) throw CLI::ValidationError("--around", "it takes all atoms; none are left for the maps");
  PairModel model;
  const DielectricChoice& medium = dielectricChoice(a.dielectric);
  model.kind = medium.kind;
  model.dielectric = medium.dielectric;
  std::vector<float> sizes;
  for (const GridType& type : kGridTypes) sizes.push_back(amberType(type.amber)->half_minimum_A);
  const InterruptWatch interrupt;
  auto maps = computeGridMaps(SphereGrid(std::move(places)), atoms, *box, sizes, model, a.threads, [&](double share) {
    showStatus(trf("computing the maps: {0} %", int(100 * share)));
    return !interrupt.seen();
  });
  showStatus({});
  if (!maps) throw CommandError{tr("the calculation was cancelled; nothing is written"), 130};
  for (std::size_t k = 0; k < kGridTypes.size(); ++k) {
    const float root = std::sqrt(amberType(kGridTypes[k].amber)->depth_kcal_mol);
    for (float& value : maps->van_der_waals[k]) value *= root;
  }
  NamedMaps named{*box, names, {maps->van_der_waals.begin(), maps->van_der_waals.end()}};
  named.values.push_back(maps->electrostatic);
  compareMaps(a.compared, named);
  if (a.out.empty()) return;
  const std::string title = a.molecule.named.name, name = stem.filename().string();
  for (std::size_t k = 0; k < names.size(); ++k)
    writeGridFile(fileOf("." + names[k] + ".map"), mapText(*box, named.values[k], name, title));
  writeGridFile(fileOf(".maps.fld"), mapFieldText(*box, name, title, names));
  writeGridFile(fileOf(".maps.xyz"), mapCornersText(*box));
  out() << stem.string() << ".*.map: " << names.size() << " maps of " << box->nodes[0] << " x " << box->nodes[1]
        << " x " << box->nodes[2] << " points, " << box->spacing_A << " A apart, of " << atoms.size() << " atoms\n";
}

}  // namespace

void addGrid(CLI::App& app) {
  auto arguments = std::make_shared<GridArguments>();
  GridArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "grid", "Compute maps of a molecule's Lennard-Jones and electrostatic energies (AutoGrid's .map)");
  a.molecule.addTo(*command);
  command
      ->add_option("-o,--out", a.out,
                   "Where the maps go: OUT.C.map, OUT.e.map and so on, with OUT.maps.fld for viewers")
      ->type_name(kFileType);
  auto* around =
      command->add_option("--around", a.around,
                          "Selection of atoms: the maps lie round them and without them: 'ligand'. Default: all atoms");
  auto* box =
      command->add_option("--box", a.box, "The box instead: its centre and its edges in angstroms, X Y Z DX DY DZ")
          ->expected(6)
          ->check(numberFrom(-1e6, 1e6))
          ->excludes(around);
  auto* like = command->add_option("--like", a.like, "The box and the spacing of this .map instead")
                   ->type_name(kFileType)
                   ->excludes(around)
                   ->excludes(box);
  auto* compare =
      command
          ->add_option("--compare", a.compared,
                       "Maps NAME.TYPE.map of another program: print how well they follow ours on their box")
          ->type_name(kFileType)
          ->excludes(box)
          ->excludes(like);
  command->add_option("--margin", a.margin_A, "Distance from the atoms to the box's faces in angstroms")
      ->check(numberFrom(0.0, 100.0))
      ->capture_default_str()
      ->excludes(box)
      ->excludes(like)
      ->excludes(compare);
  command->add_option("--spacing", a.spacing_A, "Distance of the points in angstroms")
      ->check(numberFrom(kMinGridSpacing_A, kMaxGridSpacing_A))
      ->capture_default_str()
      ->excludes(like)
      ->excludes(compare);
  std::vector<std::string> media;
  for (const DielectricChoice& medium : dielectricChoices()) media.push_back(std::string(medium.name));
  command->add_option("--dielectric", a.dielectric, "The solvent between charges")
      ->check(CLI::IsMember(media))
      ->capture_default_str();
  command->add_option("--threads", a.threads, "Number of threads; 0: one per processor")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  command->callback([arguments] { runGrid(*arguments); });
}

}  // namespace moltact
