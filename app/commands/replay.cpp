// `moltact replay`: moves the probe or a body along a recorded path and writes for each tick what a hand would feel.
#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/commands/atoms_option.h"
#include "app/commands/command.h"
#include "app/commands/csv_numbers.h"
#include "app/commands/hip_path_file.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/print_json.h"
#include "app/commands/replay_body.h"
#include "app/commands/touch_options.h"
#include "app/commands/value_types.h"
#include "engine/core/quantile.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

struct ReplayOptions {
  MoleculeArgument molecule;
  std::string path, out, in_hand;
  std::vector<std::string> from_spheres;  // files of the scene and of the body, read in place of a molecule
  std::vector<std::string> spheres;       // files of the scene and of the body, written
  ExcludedAtoms left_out;
  TouchSetup touch;
  const CLI::Option* hand = nullptr;  // --hand
  double stiffness_N_per_A = 1.0, rotational_stiffness_N_A = 0.0;
  bool time = false;
};

std::string_view nameOf(Feature feature) {
  constexpr std::array<std::string_view, 4> names{"free", "sphere", "circle", "point"};
  return names[static_cast<std::size_t>(feature)];
}

void writeContacts(const ReplayOptions& options, const HipPath& path, const std::vector<Contact>& contacts,
                   const std::vector<Vec3>& forces_N) {
  const auto checked = [](const std::optional<Problem>& problem) {
    if (problem) throw CommandError{problem->text()};
  };
  Expected<Draft> out = Draft::begin(options.out);
  if (!out) throw CommandError{out.problem().text()};
  std::string row =
      "tick,hip_x,hip_y,hip_z,contact,scp_x,scp_y,scp_z,force_x,force_y,force_z,feature,atom1,atom2,atom3\n";
  checked(out->append(row));
  for (std::size_t k = 0; k < path.size(); ++k) {
    const Contact& c = contacts[k];
    row = std::to_string(k);
    appendNumbers(row, path.places[k].A);
    row += c.touching() ? ",1" : ",0";
    appendNumbers(row, c.scp.A);
    appendNumbers(row, forces_N[k]);
    row += ',';
    row += nameOf(c.feature);
    for (const std::int32_t atom : c.atoms) row += ',' + std::to_string(atom);
    row += '\n';
    checked(out->append(row));
  }
  checked(out->commit());
}

nlohmann::ordered_json summary(std::vector<double> ns) {
  nlohmann::ordered_json out;
  if (ns.empty()) return out;  // null: nothing was measured
  std::sort(ns.begin(), ns.end());
  double sum = 0;
  for (const double one : ns) sum += one;
  out["mean"] = sum / double(ns.size());
  out["p50"] = percentile(ns, 0.5);
  out["p99"] = percentile(ns, 0.99);
  out["p99.99"] = percentile(ns, 0.9999);
  out["max"] = ns.back();
  return out;
}

// Each tick's time is the shortest of three passes, which excludes interruptions by other processes. The cost of
// reading the clock is subtracted.
nlohmann::ordered_json timePath(const InteractionInput& input, const HipPath& path, const std::vector<char>& touches) {
  using Clock = std::chrono::steady_clock;
  const auto between = [](Clock::time_point a, Clock::time_point b) {
    return std::chrono::duration<double, std::nano>(b - a).count();
  };
  double clock_ns = 1e9;
  for (int k = 0; k < 10'000; ++k) {
    const auto a = Clock::now();
    clock_ns = std::min(clock_ns, between(a, Clock::now()));
  }
  std::vector<double> least(path.size(), 1e300);
  for (int pass = 0; pass < 3; ++pass) {
    const auto felt = makeInteraction(input);
    for (std::size_t k = 0; k < path.size(); ++k) {
      const auto a = Clock::now();
      [[maybe_unused]] const volatile bool touching = felt->respond(path.at(k)).contact.touching();
      least[k] = std::min(least[k], std::max(0.0, between(a, Clock::now()) - clock_ns));
    }
  }
  std::vector<double> free, contact;
  for (std::size_t k = 0; k < path.size(); ++k) (touches[k] ? contact : free).push_back(least[k]);
  nlohmann::ordered_json out;
  out["ticks"] = path.size();
  out["contact_ticks"] = contact.size();
  out["unit"] = "ns";
  out["measured"] = "each tick's least of three passes, less the clock's own cost";
  out["free"] = summary(free);
  out["contact"] = summary(contact);
  return out;
}

// Moves the probe along the path. Returns for each tick whether it touches.
std::vector<char> replayProbe(const InteractionInput& input, const HipPath& path, const ReplayOptions& options) {
  const auto felt = makeInteraction(input);
  std::vector<Contact> contacts;
  contacts.reserve(path.size());
  std::vector<Vec3> forces_N;
  forces_N.reserve(path.size());
  std::vector<char> touches;
  touches.reserve(path.size());
  std::size_t inside = 0, refused = 0;
  for (const PointA& hip : path.places) {
    const Response answer = felt->respond({hip});
    contacts.push_back(answer.contact);
    forces_N.push_back(answer.total(options.stiffness_N_per_A).force_N);
    touches.push_back(answer.contact.touching());
    inside += contacts.back().fault == Fault::StartedInside;
    refused += contacts.back().fault == Fault::NotFinite;
  }
  if (inside)
    err() << "moltact: the HIP starts inside the molecule: no force for the first " << inside
          << " ticks, until it has been outside\n";
  if (refused) err() << "moltact: " << refused << " places were not finite or beyond 1e9 A: no force there\n";
  if (!options.out.empty()) writeContacts(options, path, contacts, forces_N);
  return touches;
}

// The molecule and its held atoms, or the spheres of two files.
InteractionInput inputOf(const ReplayOptions& options) {
  InteractionInput input{.spheres = nullptr, .touch = options.touch};
  if (!options.from_spheres.empty()) {
    if (forceChoice(options.touch.forces).any())
      throw CommandError{
          "--forces: spheres have no chemistry: name a molecule instead of --from-spheres, or leave --forces out"};
    constexpr std::size_t kMaxSpheres = 25'000'000;
    input.spheres = std::make_shared<const SphereGrid>(readSpheres(options.from_spheres[0], kMaxSpheres));
    input.body = bodyOfSpheres(readSpheres(options.from_spheres[1], kMaxHeldAtoms));
  } else {
    const Molecule molecule = options.molecule.load();
    std::vector<std::uint32_t> not_felt = options.left_out.notFelt(molecule);
    std::shared_ptr<const HeldBody> body;
    if (!options.in_hand.empty()) {
      const std::vector<std::uint32_t> held = selectedAtoms("--in-hand", options.in_hand, molecule);
      body = heldBody(molecule, held);
      if (!body) throw tooManyHeld(held.size());
      not_felt = atomsOfEither(not_felt, held);
    }
    input = interactionInput(options.touch, molecule, std::make_shared<const SphereGrid>(molecule.spheres, not_felt),
                             std::move(body));
  }
  checkHand(options.touch, input.body != nullptr, options.hand);
  input.touch = resolveInteraction(input.touch, input.body != nullptr);
  // The response is divided by the stiffness, so it equals that of a spring of 1 N/A.
  if (options.stiffness_N_per_A > 0.0)
    input.rotational_stiffness_N_A = options.rotational_stiffness_N_A / options.stiffness_N_per_A;
  return input;
}

void run(const ReplayOptions& options) {
  const InteractionInput input = inputOf(options);
  const auto path = readHipPath(options.path);
  if (!path) throw CommandError{path.problem().text()};
  if (!path->orientations.empty() && !input.body)
    throw CommandError{options.path + ":1:7: " + tr("the probe has no orientation") + "; " +
                       tr("write the header x,y,z, or name what the hand holds with --in-hand")};
  std::vector<NamedOutput> outputs{{"--out", options.out}};
  for (const std::string& file : options.spheres) outputs.push_back({"--spheres", file});
  checkOutputs(outputs);
  if (!options.spheres.empty()) {
    writeSpheres(options.spheres[0], touchableSpheres(*input.spheres));
    writeSpheres(options.spheres[1], input.body->spheres);
  }
  const std::vector<char> touches = input.body ? replayBody(input, *path, options.stiffness_N_per_A, options.out)
                                               : replayProbe(input, *path, options);
  if (options.time) printDocument(timePath(input, *path, touches));
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("replay", "Move the HIP or a body along a recorded path and write the contacts and forces");
  auto options = std::make_shared<ReplayOptions>();
  CLI::Option* molecule = options->molecule.addTo(*command)->required(false);
  command
      ->add_option(
          "--path", options->path,
          "CSV with the header x,y,z (angstrom), one row per tick; for a body also x,y,z,qw,qx,qy,qz: the hand's "
          "position for the body's centre, and its orientation relative to that in the file")
      ->type_name(kFileType)
      ->required();
  command
      ->add_option(
          "--out", options->out,
          "Write each tick's HIP, SCP, force, feature and atoms to this file (CSV), or with a body the poses of hand "
          "and body, force and torque; optional with --time")
      ->type_name(kFileType);
  CLI::Option* in_hand = command->add_option("--in-hand", options->in_hand,
                                             "Selection of atoms that the hand holds as one rigid body: 'ligand'");
  command
      ->add_option("--spheres", options->spheres,
                   "Write the spheres that are felt to two CSV files with the header x,y,z,r (angstrom): those of the "
                   "scene, and those of the body in the hand, given from its centre")
      ->type_name("SCENE.csv BODY.csv")
      ->expected(2)
      ->needs(in_hand);
  CLI::Option* from_spheres =
      command
          ->add_option("--from-spheres", options->from_spheres,
                       "In place of MOLECULE: read the spheres of the scene and of the body from two such files")
          ->type_name("SCENE.csv BODY.csv")
          ->expected(2)
          ->excludes(molecule)
          ->excludes(in_hand);
  options->left_out.addTo(*command);
  for (const char* of_molecule : {"--untouchable", "--remove"}) from_spheres->excludes(of_molecule);
  options->hand = addTouchOptions(*command, options->touch);
  addProbeOption(*command, options->touch);
  command->add_option("--stiffness", options->stiffness_N_per_A, "Stiffness of the spring, in N per angstrom")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  command
      ->add_option("--rotational-stiffness", options->rotational_stiffness_N_A,
                   "Stiffness of the spring that turns a body, in N angstrom per radian; 0: by the body's size. For an "
                   "interaction whose body turns by itself")
      ->check(numberFrom(0.0, 1e9))
      ->capture_default_str();
  command->add_flag("--time", options->time,
                    "Print the time of the ticks as JSON (ns): the minimum of three passes for each tick");
  command->callback([options] {
    if (options->molecule.named.name.empty() && options->from_spheres.empty())
      throw CLI::RequiredError("MOLECULE (or --from-spheres)");
    if (options->out.empty() && !options->time) throw CLI::RequiredError("--out (or --time)");
    run(*options);
  });
}

}  // namespace moltact
