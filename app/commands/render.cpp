// moltact render: a picture of a molecule, and of a probe pushed against it, without a display.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/commands/atoms_option.h"
#include "app/commands/command.h"
#include "app/commands/look_options.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/touch_options.h"
#include "app/commands/value_types.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/fonts/font_files.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/keys.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/second_state.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/offscreen_gl.h"
#include "engine/platform/terminal.h"
#include "engine/render/colour_legend.h"
#include "engine/render/label_painter.h"
#include "engine/render/molecule_model.h"
#include "engine/render/renderer.h"

namespace moltact {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

struct RenderArguments {
  MoleculeArgument molecule;
  std::string out, size = "1280x800", hip, show = "atoms,probe,force", theme = "dark", cut, zoom_to;
  LookOptions look;
  std::string label, arrow, mark, distance, angle, hydrogen_bonds, captions;
  std::string view, highlight, magnify, then, state = "0%";
  bool legend = false;
  TouchSetup touch;
  double azimuth_deg = 0, elevation_deg = 0, zoom = 1, stiffness_N_per_A = 1;
  int samples = 3, time = 0;
  double near_A = 4.0;
  bool look_at_hip = false;
};

std::pair<int, int> sizeOf(const std::string& text) {
  int width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 16 || height < 16 || width > 8192 ||
      height > 8192)
    throw CLI::ValidationError(
        "--size", "'" + text + "' is not a size; write WIDTHxHEIGHT, 16 to 8192 pixels each, as in 1280x800");
  return {width, height};
}

std::optional<PointA> hipOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  PointA hip;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf%c", &hip.A.x, &hip.A.y, &hip.A.z, &rest) != 3 || !finite(hip.A) ||
      glm::length(hip.A) > kFarthest_A)
    throw CLI::ValidationError("--hip", "'" + text + "' is not a place; write x,y,z in angstroms, as in 12.5,3,-8");
  return hip;
}

// The hand comes from outside along the line of sight, as a person at this picture would push.
Contact push(const std::shared_ptr<const Molecule>& molecule, const RenderArguments& arguments, const Camera& camera,
             PointA hip) {
  const auto scene = std::make_shared<const BallScene>(molecule->balls(), arguments.look.left_out.notFelt(*molecule));
  const auto felt = makeInteraction({scene, arguments.touch});
  const Vec3 from_hip = camera.back();
  const double reach = glm::length(scene->high_A() - scene->low_A()) + 2 * arguments.touch.probe_A + 1;
  const double step = std::max(0.02, reach / 200000);
  const long ticks = std::lround(std::ceil(reach / step));
  Contact contact;
  for (long i = ticks; i >= 0; --i) contact = felt->respond({{hip.A + from_hip * (step * double(i))}}).contact;
  return contact;
}

void printTimes(Renderer& renderer, const ViewScene& scene, int width, int height, const RenderArguments& arguments) {
  const auto run = [&](bool turn) {
    std::vector<double> ms;
    ViewScene moving = scene;
    for (int i = 0; i < arguments.time; ++i) {
      if (turn) moving.camera.orbit(2 * kRadian, 0);
      if (moving.hip && !turn) moving.hip->A.x += 1e-4;
      const auto begin = std::chrono::steady_clock::now();
      if (!turn && !moving.hip) moving.arrow_A_per_N += 1e-6;
      if (const auto problem = renderer.draw(moving, width, height, {.samples = arguments.samples}))
        throw CommandError{problem->text()};
      renderer.finish();
      ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
    }
    std::sort(ms.begin(), ms.end());
    return ms;
  };
  const auto turning = run(true), touching = run(false);
  char text[400];
  std::snprintf(text, sizeof text,
                "{\"atoms\": %zu, \"atoms_drawn\": %zu, \"turning_ms_p50\": %.2f, \"turning_ms_max\": %.2f, "
                "\"touching_ms_p50\": %.2f, \"touching_ms_max\": %.2f}",
                renderer.count().atoms, renderer.count().atoms_drawn, turning[turning.size() / 2], turning.back(),
                touching[touching.size() / 2], touching.back());
  out() << text << '\n';
}

AtomsLook looksOf(const RenderArguments& arguments, const Molecule& molecule, const Camera& camera) {
  AtomsLook look = arguments.look.look(molecule);
  look.spheres_near_A = arguments.near_A;
  if (arguments.cut.empty()) return look;
  Vec3 through = camera.target.A;
  double before_A = 0.0;
  if (arguments.cut == "middle") {
  } else if (const auto distance = parseNumber(arguments.cut)) {
    before_A = *distance;
  } else {
    through = Vec3(0.0);
    const std::vector<std::uint32_t> atoms = selectedAtoms("--cut", arguments.cut, molecule);
    for (const std::uint32_t a : atoms) through += molecule.atoms[a].position.A / double(atoms.size());
  }
  look.cut = CutPlane{camera.back(), glm::dot(camera.back(), through) + before_A};
  return look;
}

// What a scene of a lesson would say, from options of the same names.
class SceneOptions {
 public:
  SceneOptions(const RenderArguments& arguments, const Molecule& molecule)
      : arguments_(arguments), molecule_(molecule) {}

  /// The second structure of --then, and how far the molecule goes there.
  SecondState second() const {
    if (arguments_.then.empty()) {
      if (arguments_.state != "0%")
        throw CLI::ValidationError("--state", "there is one state only: name the other by --then");
      return {};
    }
    Expected<SecondState> read = parseSecondState(arguments_.then);
    if (!read) throw CLI::ValidationError("--then", read.problem().text());
    SceneSpec scene;
    scene.then = *read;
    listOf("then", read->superposed_on);
    const std::optional<double> share = stateNamed(scene, arguments_.state);
    if (!share)
      throw CLI::ValidationError("--state",
                                 "'" + arguments_.state + "' is no share of the way; write one from 0% to 100%");
    read->share = *share;
    return *std::move(read);
  }

  /// All else: view, names, arrows, marks and measures, and atoms that a scene selects.
  SceneSpec scene() const {
    SceneSpec scene;
    scene.molecule = arguments_.molecule.named;
    scene.touch = arguments_.touch;
    if (!arguments_.view.empty()) {
      scene.view = value("view", arguments_.view).view;
      listOf("view", scene.view.facing);
      listOf("view", scene.view.zoom);
    }
    const auto take = [&](std::string_view key, const std::string& text, Selection& atoms) {
      if (text.empty()) return;
      atoms = value(key, text).selection;
      listOf(key, atoms);
    };
    take("highlight", arguments_.highlight, scene.highlight);
    take("magnify", arguments_.magnify, scene.magnify);
    take("remove", arguments_.look.left_out.remove, scene.remove);
    if (!arguments_.captions.empty()) {
      scene.captions = value("captions", arguments_.captions).words;
      if (molecule_.beside_from == 0)
        throw CLI::ValidationError("--captions", "there is one molecule only: name the other by --beside");
      if (scene.captions.size() != 2)
        throw CLI::ValidationError("--captions", "there are two molecules to name; write two, as in 'wool, silk'");
    }
    scene.labels = marksOf("label", arguments_.label);
    scene.arrows = marksOf("arrow", arguments_.arrow);
    scene.marks = marksOf("mark", arguments_.mark);
    for (const auto& [key, text] :
         {std::pair{"distance", &arguments_.distance}, std::pair{"angle", &arguments_.angle}}) {
      if (text->empty()) continue;
      for (PlacesSpec& measure : value(key, *text).measures) {
        for (const Selection& place : measure.atoms) listOf(key, place);
        scene.measures.push_back(std::move(measure));
      }
    }
    if (!arguments_.hydrogen_bonds.empty()) {
      scene.hydrogen_bonds = value("hydrogen-bonds", arguments_.hydrogen_bonds).selection;
      listOf("hydrogen-bonds", scene.hydrogen_bonds);
    }
    return scene;
  }

 private:
  static Value value(std::string_view key, const std::string& text) {
    const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
    const auto spec = std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == key; });
    Expected<Value> read = parseValue(*spec, text);
    if (!read) throw CLI::ValidationError("--" + std::string(key), read.problem().text());
    return *std::move(read);
  }
  AtomList listOf(std::string_view key, const Selection& atoms) const {
    if (!atoms.given()) return nullptr;
    auto selected = atoms.select(molecule_);
    if (selected.empty()) throw CLI::ValidationError("--" + std::string(key), atoms.whyEmpty(molecule_).text());
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(selected));
  }
  std::vector<MarkSpec> marksOf(std::string_view key, const std::string& text) const {
    if (text.empty()) return {};
    std::vector<MarkSpec> marks = value(key, text).marks;
    for (const MarkSpec& mark : marks) listOf(key, mark.atoms);
    return marks;
  }

  const RenderArguments& arguments_;
  const Molecule& molecule_;
};

// The molecule on its way to the second structure.
Molecule between(const Molecule& molecule, const RenderArguments& arguments, const SecondState& then) {
  ReadOptions reading = arguments.molecule.named.reading;
  reading.beside.clear();
  const Expected<Molecule> other = openMolecule(then.molecule, reading);
  if (!other) throw CommandError{other.problem().text()};
  SceneSpec scene;
  scene.then = then;
  const Expected<TwoStates> states = statesOf(scene, molecule, *other);
  if (!states) throw CommandError{states.problem().text()};
  return movedTo(molecule, states->at(then.share));
}

void render(const RenderArguments& arguments) {
  const auto [width, height] = sizeOf(arguments.size);
  ViewScene scene;
  scene.hip = hipOf(arguments.hip);
  const auto shown = parseViewParts(arguments.show);
  if (!shown) throw CLI::ValidationError("--show", shown.problem().text());
  scene.shown = *shown;
  scene.molecule = std::make_shared<const Molecule>(arguments.molecule.load());
  scene.theme = arguments.theme == "light" ? lightTheme() : darkTheme();
  scene.colour_by = arguments.look.colourBy(*scene.molecule);
  scene.probe_A = arguments.touch.probe_A;
  const std::shared_ptr<const Molecule> read = scene.molecule;
  const SceneOptions options(arguments, *read);
  if (const SecondState then = options.second(); !then.molecule.empty())
    scene.molecule = std::make_shared<const Molecule>(between(*scene.molecule, arguments, then));
  const SceneSpec spec = options.scene();
  const double aspect = double(width) / height;
  const std::vector<std::uint32_t> removed = arguments.look.left_out.removed(*scene.molecule);
  const auto comeClose = [&](const std::optional<Region>& part) {
    if (part) scene.camera.fit(part->centre, part->radius_A, aspect);
  };
  scene.camera.lookFrom(arguments.azimuth_deg * kRadian, arguments.elevation_deg * kRadian);
  scene.camera.fit(*scene.molecule, aspect, 0.08, 0.0, removed);
  if (!arguments.view.empty()) {
    faceView(scene.camera, *scene.molecule, spec.view, spec);
    scene.camera.fit(*scene.molecule, aspect, 0.08, 0.0, removed);
  }
  comeClose(magnifiedRegion(spec, *scene.molecule));
  comeClose(zoomedRegion(spec.view, spec, *scene.molecule, arguments.touch.probe_A));
  if (!arguments.zoom_to.empty())
    comeClose(regionAround(selectedAtoms("--zoom-to", arguments.zoom_to, *scene.molecule), *scene.molecule,
                           arguments.touch.probe_A));
  if (spec.highlight.given()) scene.highlighted = spec.highlight.select(*scene.molecule);
  scene.look = looksOf(arguments, *scene.molecule, scene.camera);
  scene.look.marks = marksOf(spec, *scene.molecule);
  if (auto written = annotationsOf(spec, *scene.molecule)) scene.annotations.push_back(std::move(written));
  if (scene.hip) {
    scene.contact = push(scene.molecule, arguments, scene.camera, *scene.hip);
    scene.force_N = arguments.stiffness_N_per_A * glm::length(scene.contact.displacement_A);
    if (arguments.look_at_hip) scene.camera.target = scene.contact.scp;
  }
  scene.camera.zoom(arguments.zoom);

  auto gl = OffscreenGl::create();
  if (!gl) throw CommandError{gl.problem().text()};
  auto renderer = Renderer::create();
  if (!renderer) throw CommandError{renderer.problem().text()};
  if (arguments.time > 0) printTimes(**renderer, scene, width, height, arguments);
  if (const auto problem = (*renderer)->draw(scene, width, height, {.samples = arguments.samples}))
    throw CommandError{problem->text()};
  Picture picture = (*renderer)->readPixels();
  const double unit_px = std::max(1.0, height / 800.0);
  bool written = true;
  if (!scene.annotations.empty()) {
    const BallScene balls(scene.molecule->balls());
    written = paintLabels(picture, scene, &balls, unit_px);
  }
  if (arguments.legend && written) {
    std::vector<LegendEntry> entries = legendOf(*scene.molecule, scene.colour_by, scene.elements, scene.look);
    if (!scene.highlighted.empty() && scene.shown.has(ViewPart::Target))
      entries.push_back({scene.theme.target, tr("marked")});
    written = paintLegend(picture, entries, scene.theme, unit_px);
  }
  if (!written)
    throw CommandError{"names cannot be written: there is no font " + interFile("Inter-Regular.otf").string()};
  if (const auto problem = writePng(arguments.out, picture)) throw CommandError{problem->text()};
}

}  // namespace

void addRender(CLI::App& app) {
  auto* command = app.add_subcommand("render", "Draw a molecule, and a probe pushed against it, into a PNG file");
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& a = *arguments;
  a.molecule.addTo(*command);
  command->add_option("--out", a.out, "The PNG file to write")->type_name(kFileType)->required();
  command->add_option("--size", a.size, "Width x height in pixels")->capture_default_str();
  addProbeOption(*command, a.touch);
  command->add_option("--hip", a.hip, "Where the hand is: x,y,z in angstroms; it comes there along the line of sight");
  std::string shapes = "What is drawn, parted by commas; the groups are haptic, all and none:";
  for (const ViewPartInfo& s : viewParts()) shapes += "\n" + std::string(s.name) + ": " + std::string(s.sentence);
  command->add_option("--show", a.show, shapes)->capture_default_str();
  addTouchOptions(*command, a.touch);
  command->add_option("--stiffness", a.stiffness_N_per_A, "Of the spring, in N per angstrom, for the arrow")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  CLI::Option* const view =
      command->add_option("--view", a.view,
                          "Look from 'front', 'back', 'left', 'right', 'top', 'bottom' or 'side', at atoms ('facing "
                          "residue 35'), or turned by "
                          "angles ('turned 30 10 0'); behind a comma come close to atoms: 'front, zoom ligand'");
  command->add_option("--azimuth", a.azimuth_deg, "Look from so many degrees to the right")
      ->check(numberFrom(-360.0, 360.0))
      ->excludes(view)
      ->capture_default_str();
  command->add_option("--elevation", a.elevation_deg, "Look from so many degrees above")
      ->check(numberFrom(-360.0, 360.0))
      ->excludes(view)
      ->capture_default_str();
  command->add_option("--zoom", a.zoom, "Times nearer than the whole molecule")
      ->check(numberFrom(0.01, 1000.0))
      ->capture_default_str();
  command->add_flag("--look-at-hip", a.look_at_hip, "Put the contact in the middle of the picture");
  command->add_option("--theme", a.theme, "Colours")->check(CLI::IsMember({"light", "dark"}))->capture_default_str();
  a.look.addTo(*command);
  command->add_option(
      "--label", a.label,
      "Names over the picture: 'residue for ligand', '\"the cleft\" for residue 35 52'; the words are atom, "
      "residue and chain");
  command->add_option("--arrow", a.arrow, "Arrows with names: '\"iron\" for element Fe'");
  command->add_option("--mark", a.mark, "Atoms in colours of their own: 'teal for residue 35, magenta for residue 52'");
  command->add_option("--distance", a.distance, "Lengths between the middles of selections: 'atom 3 - atom 9'");
  command->add_option("--angle", a.angle, "Angles between three selections, torsions between four");
  command->add_option("--captions", a.captions, "What stands below the two molecules of --beside: 'wool, silk'");
  command->add_option("--highlight", a.highlight, "Atoms in the colour of targets, as a selection");
  command->add_option("--magnify", a.magnify,
                      "Come close to atoms as a scene does that magnifies them, as a selection");
  command->add_option(
      "--then", a.then,
      "A second structure of the molecule, to which --state leads its atoms: '1ake', '1ake, superposed on "
      "chain A'");
  command->add_option("--state", a.state, "How far the atoms are on their way to it: 40%")->capture_default_str();
  command->add_flag("--legend", a.legend, "Write what the colours mean into the upper left corner");
  command->add_option("--hydrogen-bonds", a.hydrogen_bonds,
                      "Hydrogen bonds with an end in the selection, as dashed lines");
  command->add_option("--near", a.near_A, "Beside other styles, atoms so near to the probe are drawn as spheres (A)")
      ->check(numberFrom(0.0, 20.0))
      ->capture_default_str();
  command->add_option("--cut", a.cut,
                      "Cut the molecule open by a plane that faces the viewer: 'middle' through its middle, so many "
                      "angstroms before it (3), or through the middle of atoms, as a selection");
  command->add_option("--zoom-to", a.zoom_to, "Come close to atoms, as a selection");
  command->add_option("--samples", a.samples, "Samples along each pixel's edge")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command->add_option("--time", a.time, "Also draws so many pictures and prints the times as JSON")
      ->check(CLI::Range(0, 10000));
  command->callback([arguments] { render(*arguments); });
}

}  // namespace moltact
