// moltact render: draws a molecule, and a probe that is pushed against it, into a picture without a display.
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
#include "app/commands/outputs.h"
#include "app/commands/scene_options.h"
#include "app/commands/touch_options.h"
#include "app/commands/value_types.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/fonts/font_files.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/platform/offscreen_gl.h"
#include "engine/platform/terminal.h"
#include "engine/render/colour_legend.h"
#include "engine/render/label_painter.h"
#include "engine/render/loaded_atoms.h"
#include "engine/render/molecule_model.h"
#include "engine/render/renderer.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

constexpr double kRadian = std::numbers::pi / 180;

struct RenderArguments {
  MoleculeArgument molecule;
  std::string out, size = "1280x800", hip, show = "atoms,probe,force", theme = "dark", cut, zoom_to, orientation;
  LookOptions look;
  SceneOptions says;
  bool legend = false;
  TouchSetup touch;
  const CLI::Option* hand = nullptr;  // --hand
  double azimuth_deg = 0, elevation_deg = 0, zoom = 1, stiffness_N_per_A = 1;
  int samples = 3, time = 0;
  std::size_t max_single_atoms = kMaxSingleAtoms;
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
      glm::length(hip.A) > kMaxPosition_A)
    throw CLI::ValidationError("--hip", "'" + text + "' is not a place; write x,y,z in angstroms, as in 12.5,3,-8");
  return hip;
}

Quat orientationOf(const std::string& text) {
  if (text.empty()) return kNoRotation;
  Quat q;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf%c", &q.w, &q.x, &q.y, &q.z, &rest) != 4 || !rotates(q))
    throw CLI::ValidationError(
        "--orientation", "'" + text + "' is not a quaternion; write w,x,y,z, as in 0.9239,0,0,0.3827 for 45 degrees");
  return glm::normalize(q);
}

// What is felt where the hand is pushed to, and the reactions of the molecule's atoms.
struct Pushed {
  Response response;
  std::vector<AtomForce> reactions;
};

// The hand approaches from outside along the line of sight, as a person in front of this picture would push.
Pushed push(const std::shared_ptr<const Molecule>& molecule, const RenderArguments& arguments,
            const std::shared_ptr<const HeldBody>& body, const Camera& camera, const PoseA& hand) {
  std::vector<std::uint32_t> not_felt = arguments.look.left_out.notFelt(*molecule);
  if (body) not_felt = atomsOfEither(not_felt, body->atoms);
  const auto scene = std::make_shared<const SphereGrid>(molecule->spheres, not_felt);
  const TouchSetup touch = resolveInteraction(arguments.touch, body != nullptr);
  const auto felt = makeInteraction(interactionInput(touch, *molecule, scene, body));
  const Vec3 from_hip = camera.back();
  const double held_A = body ? body->reach_A : touch.probe_A;
  const double reach = glm::length(scene->high_A() - scene->low_A()) + 2 * held_A + 1;
  const double step = std::max(0.02, reach / 200000);
  const long ticks = std::lround(std::ceil(reach / step));
  Pushed out;
  for (long i = ticks; i >= 0; --i)
    out.response = felt->respond({{hand.place.A + from_hip * (step * double(i))}, hand.orientation});
  out.reactions.resize(felt->maxReactionCount());
  out.reactions.resize(felt->reactions(out.response, arguments.stiffness_N_per_A, 1.0, out.reactions));
  return out;
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

AtomsLook looksOf(const RenderArguments& arguments, const Molecule& molecule, const Camera& camera,
                  std::span<const std::uint32_t> held) {
  const std::vector<float> fluctuation_A =
      arguments.look.colour == "fluctuation" ? arguments.says.fluctuation_A(molecule) : std::vector<float>();
  AtomsLook look = arguments.look.look(
      molecule, {.dielectric = arguments.touch.dielectric, .held = held, .fluctuation_A = fluctuation_A});
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
    for (const std::uint32_t a : atoms) through += molecule.spheres[a].centre_A / double(atoms.size());
  }
  look.cut = CutPlane{camera.back(), glm::dot(camera.back(), through) + before_A};
  return look;
}

void render(const RenderArguments& arguments) {
  const auto [width, height] = sizeOf(arguments.size);
  ViewScene scene;
  scene.hip = hipOf(arguments.hip);
  const Quat orientation = orientationOf(arguments.orientation);
  const auto shown = parseViewParts(arguments.show);
  if (!shown) throw CLI::ValidationError("--show", shown.problem().text());
  scene.shown = *shown;
  scene.molecule =
      std::make_shared<const Molecule>(arguments.says.atState(arguments.molecule.load(), arguments.molecule));
  checkOutputs({{"--out", arguments.out}});
  scene.theme = arguments.theme == "light" ? lightTheme() : darkTheme();
  scene.colour_by = arguments.look.colourBy(*scene.molecule);
  scene.probe_A = arguments.touch.probe_A;
  scene.max_single_atoms = arguments.max_single_atoms;
  SceneSpec spec = arguments.says.scene(*scene.molecule);
  spec.molecule = arguments.molecule.named;
  spec.touch = arguments.touch;
  std::vector<std::uint32_t> removed = arguments.look.left_out.removed(*scene.molecule);
  if (!removed.empty()) spec.remove = *parseSelection(arguments.look.left_out.remove);
  removed = atomsOfEither(removed, heldAtoms(spec, *scene.molecule));
  const double aspect = double(width) / height;
  const auto comeClose = [&](const std::optional<Region>& part) {
    if (part) scene.camera.fit(part->centre, part->radius_A, aspect);
  };
  scene.camera.lookFrom(arguments.azimuth_deg * kRadian, arguments.elevation_deg * kRadian);
  scene.camera.fit(*scene.molecule, aspect, 0.08, 0.0, removed);
  if (!arguments.says.view.empty()) {
    faceView(scene.camera, *scene.molecule, spec.view, spec);
    scene.camera.fit(*scene.molecule, aspect, 0.08, 0.0, removed);
  }
  comeClose(magnifiedRegion(spec, *scene.molecule));
  comeClose(zoomedRegion(spec.view, spec, *scene.molecule, arguments.touch.probe_A));
  if (!arguments.zoom_to.empty())
    comeClose(regionAround(selectedAtoms("--zoom-to", arguments.zoom_to, *scene.molecule), *scene.molecule,
                           arguments.touch.probe_A));
  if (spec.highlight.given()) scene.highlighted = spec.highlight.select(*scene.molecule);
  const std::vector<std::uint32_t> held = heldAtoms(spec, *scene.molecule);
  scene.look = looksOf(arguments, *scene.molecule, scene.camera,
                       atomsOfEither(held, arguments.look.left_out.notFelt(*scene.molecule)));
  scene.look.marks = marksOf(spec, *scene.molecule);
  if (!held.empty()) {
    scene.body = heldBody(*scene.molecule, held);
    if (!scene.body) throw tooManyHeld(held.size());
    scene.look.hidden = std::make_shared<const std::vector<std::uint32_t>>(
        scene.look.hidden ? atomsOfEither(*scene.look.hidden, held) : held);
  }
  checkHand(arguments.touch, scene.body != nullptr, arguments.hand);
  if (!arguments.orientation.empty() && !scene.body)
    throw CLI::ValidationError("--orientation", "there is nothing in the hand to turn; add --in-hand");
  if (auto written = annotationsOf(spec, *scene.molecule)) scene.annotations.push_back(std::move(written));
  if (scene.hip) {
    const auto [answer, reactions] =
        push(scene.molecule, arguments, scene.body, scene.camera, {*scene.hip, orientation});
    const Vec3 force_N = answer.total(arguments.stiffness_N_per_A).force_N;
    scene.contact = answer.contact;
    if (answer.body_pose) {
      scene.body_place = answer.body_pose->place;
      scene.body_orientation = answer.body_pose->orientation;
    }
    if (scene.body) {
      scene.hand_orientation = orientation;
      scene.torque_N_A = answer.total(arguments.stiffness_N_per_A).torque_N_A;
      const LoadedAtoms loads = loadedAtoms(reactions);
      scene.body_stopped = loads.body;
      scene.stopped_by = loads.scene;
    }
    scene.force_N = glm::length(force_N);
    if (answer.field) scene.field_direction = force_N;
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
    const SphereGrid spheres(scene.molecule->spheres);
    written = paintLabels(picture, scene, &spheres, unit_px);
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
  if (const std::string notice = residueSpheresNotice(scene.molecule->atoms.size(), scene.max_single_atoms);
      !notice.empty())
    err() << "moltact: " << trf("note: {0}", notice) << '\n';
}

}  // namespace

void addRender(CLI::App& app) {
  auto* command = app.add_subcommand("render", "Draw a molecule with a probe pushed against it into a PNG file");
  const auto arguments = std::make_shared<RenderArguments>();
  RenderArguments& a = *arguments;
  a.molecule.addTo(*command);
  command->add_option("--out", a.out, "The PNG file to write")->type_name(kFileType)->required();
  command->add_option("--size", a.size, "Width x height in pixels")->capture_default_str();
  addProbeOption(*command, a.touch);
  command->add_option("--hip", a.hip,
                      "Position of the hand: x,y,z in angstroms; the hand approaches it along the line of sight");
  command->add_option("--orientation", a.orientation,
                      "With --in-hand, the hand's orientation relative to the file, as a quaternion: w,x,y,z");
  std::string shapes = "Parts of the picture, separated by commas; the groups are haptic, all and none:";
  for (const ViewPartInfo& s : viewParts()) shapes += "\n" + std::string(s.name) + ": " + std::string(s.sentence);
  command->add_option("--show", a.show, shapes)->capture_default_str();
  a.hand = addTouchOptions(*command, a.touch);
  command->add_option("--stiffness", a.stiffness_N_per_A, "Stiffness of the spring, in N per angstrom, for the arrow")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  CLI::Option* const view = a.says.addPictures(*command);
  command->add_option("--azimuth", a.azimuth_deg, "Turn the viewpoint by this many degrees to the right")
      ->check(numberFrom(-360.0, 360.0))
      ->excludes(view)
      ->capture_default_str();
  command->add_option("--elevation", a.elevation_deg, "Raise the viewpoint by this many degrees")
      ->check(numberFrom(-360.0, 360.0))
      ->excludes(view)
      ->capture_default_str();
  command->add_option("--zoom", a.zoom, "Magnification relative to a view of the whole molecule")
      ->check(numberFrom(0.01, 1000.0))
      ->capture_default_str();
  command->add_flag("--look-at-hip", a.look_at_hip, "Centre the picture on the contact");
  command->add_option("--theme", a.theme, "Colour theme of the picture")
      ->check(CLI::IsMember({"light", "dark"}))
      ->capture_default_str();
  a.look.addTo(*command);
  a.says.addMolecules(*command);
  command->add_flag("--legend", a.legend, "Draw a legend of the colours in the upper left corner");
  command
      ->add_option("--near", a.near_A,
                   "With other styles, also draw atoms within this distance of the probe as spheres (A)")
      ->check(numberFrom(0.0, 20.0))
      ->capture_default_str();
  command->add_option(
      "--cut", a.cut,
      "Cut the molecule open by a plane that faces the viewer: through its centre ('middle'), this many "
      "angstroms in front of it (3), or through the centre of a selection");
  command->add_option("--zoom-to", a.zoom_to, "Zoom in on a selection of atoms");
  command->add_option("--samples", a.samples, "Samples per pixel along each axis")
      ->check(CLI::Range(1, 4))
      ->capture_default_str();
  command
      ->add_option("--single-atoms", a.max_single_atoms,
                   "Draw one sphere per residue if the molecule has more atoms than this")
      ->check(CLI::Range(std::size_t(0), std::size_t(1'000'000'000)))
      ->capture_default_str();
  command->add_option("--time", a.time, "Also draw this many pictures and print the times as JSON")
      ->check(CLI::Range(0, 10000));
  command->callback([arguments] { render(*arguments); });
}

}  // namespace moltact
