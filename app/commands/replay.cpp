// `moltact replay`: moves the HIP along a recorded path and writes for each tick what a hand would feel.
#include <algorithm>
#include <charconv>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/commands/atoms_option.h"
#include "app/commands/command.h"
#include "app/commands/hip_path_file.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/print_json.h"
#include "app/commands/touch_options.h"
#include "app/commands/value_types.h"
#include "engine/core/quantile.h"
#include "engine/haptics/interactions.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/structure/atom_charges.h"

namespace moltact {
namespace {

struct ReplayOptions {
  MoleculeArgument molecule;
  std::string path, out;
  LeftOutAtoms left_out;
  TouchSetup touch;
  double stiffness_N_per_A = 1.0;
  bool time = false;
};

std::string_view nameOf(Feature feature) {
  constexpr std::array<std::string_view, 4> names{"free", "sphere", "circle", "point"};
  return names[static_cast<std::size_t>(feature)];
}

void append(std::string& row, double value) {
  char digits[40];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17).ptr;
  row.append(digits, end);
}

void append(std::string& row, const Vec3& v) {
  for (int k = 0; k < 3; ++k) {
    row += ',';
    append(row, v[k]);
  }
}

void writeContacts(const ReplayOptions& options, const std::vector<PointA>& path, const std::vector<Contact>& contacts,
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
    append(row, path[k].A);
    row += c.touching() ? ",1" : ",0";
    append(row, c.scp.A);
    append(row, forces_N[k]);
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
nlohmann::ordered_json timePath(const InteractionInput& input, const std::vector<PointA>& path,
                                const std::vector<Contact>& contacts) {
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
      [[maybe_unused]] const volatile bool touching = felt->respond({path[k]}).contact.touching();
      least[k] = std::min(least[k], std::max(0.0, between(a, Clock::now()) - clock_ns));
    }
  }
  std::vector<double> free, contact;
  for (std::size_t k = 0; k < path.size(); ++k) (contacts[k].touching() ? contact : free).push_back(least[k]);
  nlohmann::ordered_json out;
  out["ticks"] = path.size();
  out["contact_ticks"] = contact.size();
  out["unit"] = "ns";
  out["measured"] = "each tick's least of three passes, less the clock's own cost";
  out["free"] = summary(free);
  out["contact"] = summary(contact);
  return out;
}

void run(const ReplayOptions& options) {
  const Molecule molecule = options.molecule.load();
  const auto path = readHipPath(options.path);
  if (!path) throw CommandError{path.problem().text()};
  checkOutputs({{"--out", options.out}});
  const InteractionInput input{std::make_shared<const SphereGrid>(molecule.spheres, options.left_out.notFelt(molecule)),
                               options.touch, nullptr, chemistryFor(options.touch, molecule)};
  const auto felt = makeInteraction(input);
  std::vector<Contact> contacts;
  contacts.reserve(path->size());
  std::vector<Vec3> forces_N;
  forces_N.reserve(path->size());
  std::size_t inside = 0, refused = 0;
  for (const PointA& hip : *path) {
    const Response answer = felt->respond({hip});
    contacts.push_back(answer.contact);
    forces_N.push_back(answer.total(options.stiffness_N_per_A).force_N);
    inside += contacts.back().fault == Fault::StartedInside;
    refused += contacts.back().fault == Fault::NotFinite;
  }
  if (inside)
    err() << "moltact: the HIP starts inside the molecule: no force for the first " << inside
          << " ticks, until it has been outside\n";
  if (refused) err() << "moltact: " << refused << " places were not finite or beyond 1e9 A: no force there\n";
  if (!options.out.empty()) writeContacts(options, *path, contacts, forces_N);
  if (options.time) printDocument(timePath(input, *path, contacts));
}

}  // namespace

void addReplay(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("replay", "Move the HIP along a recorded path and write the contacts and forces");
  auto options = std::make_shared<ReplayOptions>();
  options->molecule.addTo(*command);
  command->add_option("--path", options->path, "CSV with the header x,y,z (angstrom), one row per tick")
      ->type_name(kFileType)
      ->required();
  command
      ->add_option("--out", options->out,
                   "Write each tick's HIP, SCP, force, feature and atoms to this file (CSV); optional with --time")
      ->type_name(kFileType);
  options->left_out.addTo(*command);
  addTouchOptions(*command, options->touch);
  addProbeOption(*command, options->touch);
  command->add_option("--stiffness", options->stiffness_N_per_A, "Stiffness of the spring, in N per angstrom")
      ->check(numberFrom(0.0, 1e6))
      ->capture_default_str();
  command->add_flag("--time", options->time,
                    "Print the time of the ticks as JSON (ns): the minimum of three passes for each tick");
  command->callback([options] {
    if (options->out.empty() && !options->time) throw CLI::RequiredError("--out (or --time)");
    run(*options);
  });
}

}  // namespace moltact
