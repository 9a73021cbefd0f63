// moltact modes MOLECULE: prints the softest motions of its elastic network.
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/print_json.h"
#include "engine/dynamics/normal_modes.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/second_state.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

struct ModesArguments {
  MoleculeArgument molecule;
  std::string toward;
  double cut_off_A = ElasticNetwork::kCutOff_A;
  int count = 10;
  bool json = false;
};

/// What is printed.
struct ModesFound {
  const Molecule* molecule = nullptr;
  ElasticNetwork network;
  NormalModes modes;
  double spring_kcal_mol_A2 = 0.0;  // 0: the file has no displacement factors
  double correlation = 0.0;
  std::size_t softest = 0, stiffest = 0;       // nodes
  double softest_A2 = 0.0, stiffest_A2 = 0.0;  // their mean compliance, for springs of stiffness 1
  std::vector<double> overlaps{};              // with the change toward another structure
  double change_A = 0.0;                       // root mean square over the nodes
};

std::string decimal(double value, int digits) { return quantityNumber(value, Dimension::None, decimals(digits)); }

// The displacement of each node toward another structure, after superposition.
std::vector<Vec3> changeToward(const ModesArguments& a, const Molecule& molecule, const ElasticNetwork& network) {
  Expected<SecondState> then = parseSecondState(a.toward);
  if (!then) throw CLI::ValidationError("--toward", then.problem().text());
  if (then->superposed_on.given() && then->superposed_on.select(molecule).empty())
    throw CLI::ValidationError("--toward", then->superposed_on.whyEmpty(molecule).text());
  ReadOptions reading = a.molecule.named.reading;
  reading.beside.clear();
  const Expected<Molecule> other = openMolecule(then->molecule, reading);
  if (!other) throw CommandError{other.problem().text()};
  SceneSpec scene;
  scene.then = *std::move(then);
  const Expected<TwoStates> states = statesOf(scene, molecule, *other);
  if (!states) throw CommandError{states.problem().text()};
  std::vector<Vec3> out;
  for (const std::uint32_t atom : network.nodes())
    out.push_back(states->second[atom].centre_A - states->first[atom].centre_A);
  return out;
}

ModesFound findModes(const ModesArguments& a, const Molecule& molecule) {
  auto network = ElasticNetwork::make(molecule, a.cut_off_A);
  if (!network) throw CommandError{network.problem().text()};
  auto modes = lowestModes(*network, std::size_t(a.count));
  if (!modes) throw CommandError{modes.problem().text()};
  const InterruptWatch interrupt;
  const std::vector<glm::dmat3> compliances = nodeCompliances(*network, [&](double share) {
    showStatus(trf("computing the compliances: {0} %", int(100 * share)));
    return !interrupt.seen();
  });
  showStatus({});
  if (compliances.empty()) throw CommandError{tr("the calculation was cancelled"), 130};
  ModesFound out{&molecule, *std::move(network), *std::move(modes)};
  out.spring_kcal_mol_A2 = springFromDisplacementFactors(out.network, molecule, compliances);
  out.correlation = correlationWithDisplacementFactors(out.network, molecule, compliances);
  std::vector<double> mean;
  for (const glm::dmat3& c : compliances) mean.push_back(fluctuation(c) / 3.0);
  out.softest = std::size_t(std::max_element(mean.begin(), mean.end()) - mean.begin());
  out.stiffest = std::size_t(std::min_element(mean.begin(), mean.end()) - mean.begin());
  out.softest_A2 = mean[out.softest];
  out.stiffest_A2 = mean[out.stiffest];
  if (a.toward.empty()) return out;
  const std::vector<Vec3> change = changeToward(a, molecule, out.network);
  for (const Vec3& d : change) out.change_A += glm::dot(d, d) / double(change.size());
  out.change_A = std::sqrt(out.change_A);
  out.overlaps = modeOverlaps(out.modes, change);
  return out;
}

void printModes(const ModesFound& m) {
  const bool assumed = !(m.spring_kcal_mol_A2 > 0.0);
  const double spring = assumed ? 1.0 : m.spring_kcal_mol_A2;
  const auto node = [&](std::size_t k) { return m.molecule->describe(m.network.nodes()[k]); };
  out() << "nodes     " << m.network.nodes().size() << '\n';
  out() << "springs   " << m.network.springs().size();
  if (assumed)
    out() << "; the file has no B factors: stiffnesses are those for springs of 1 kcal/mol/A^2\n";
  else
    out() << " of " << decimal(spring, 3) << " kcal/mol/A^2, which gives the mean B factor at 300 K (correlation of B "
          << "factors " << decimal(m.correlation, 2) << ")\n";
  out() << "softest   " << node(m.softest) << ", " << decimal(spring / m.softest_A2, 2) << " kcal/mol/A^2\n";
  out() << "stiffest  " << node(m.stiffest) << ", " << decimal(spring / m.stiffest_A2, 2) << " kcal/mol/A^2\n";
  if (!m.overlaps.empty()) out() << "change    " << decimal(m.change_A, 2) << " A (root mean square over the nodes)\n";
  out() << "mode  eigenvalue  kcal/mol at 1 A" << (m.overlaps.empty() ? "" : "  overlap  together") << '\n';
  double together = 0.0;
  for (std::size_t k = 0; k < m.modes.count(); ++k) {
    const double energy = 0.5 * m.modes.eigenvalues[k] * spring * double(m.modes.nodes);
    const auto column = [](const std::string& text, std::size_t width) {
      return std::string(width - std::min(width, text.size()), ' ') + text;
    };
    out() << column(std::to_string(k + 1), 4) << column(decimal(m.modes.eigenvalues[k], 4), 12)
          << column(decimal(energy, 2), 17);
    if (!m.overlaps.empty()) {
      together += m.overlaps[k] * m.overlaps[k];
      out() << column(decimal(m.overlaps[k], 3), 9) << column(decimal(std::sqrt(together), 3), 10);
    }
    out() << '\n';
  }
}

nlohmann::ordered_json modesJson(const ModesFound& m) {
  nlohmann::ordered_json json = {{"nodes", m.network.nodes().size()},
                                 {"springs", m.network.springs().size()},
                                 {"eigenvalues", m.modes.eigenvalues},
                                 {"correlation_with_b_factors", m.correlation},
                                 {"softest_atom", m.network.nodes()[m.softest]},
                                 {"softest_compliance_A2", m.softest_A2},
                                 {"stiffest_atom", m.network.nodes()[m.stiffest]},
                                 {"stiffest_compliance_A2", m.stiffest_A2}};
  if (m.spring_kcal_mol_A2 > 0.0) json["spring_kcal_mol_A2"] = m.spring_kcal_mol_A2;
  if (!m.overlaps.empty()) {
    json["change_A"] = m.change_A;
    json["overlaps"] = m.overlaps;
  }
  return json;
}

}  // namespace

void addModes(CLI::App& app) {
  auto arguments = std::make_shared<ModesArguments>();
  ModesArguments& a = *arguments;
  CLI::App* command = app.add_subcommand(
      "modes",
      "Compute the softest motions of a molecule's elastic network, and how well they lead to another structure");
  a.molecule.addTo(*command);
  command->add_option("--count", a.count, "Number of modes")->check(CLI::Range(1, 200))->capture_default_str();
  command->add_option("--cut-off", a.cut_off_A, "Springs join nodes that are nearer than this, in angstroms")
      ->check(numberFrom(ElasticNetwork::kMinCutOff_A, ElasticNetwork::kMaxCutOff_A))
      ->capture_default_str();
  command->add_option(
      "--toward", a.toward,
      "A second structure, to which the modes' overlap is printed: '1ake', '1ake, superposed on chain A'");
  command->add_flag("--json", a.json, "Print JSON; eigenvalues and compliances for springs of stiffness 1");
  command->callback([arguments] {
    const Molecule molecule = arguments->molecule.load();
    const ModesFound found = findModes(*arguments, molecule);
    if (arguments->json) return printDocument(modesJson(found));
    printModes(found);
  });
}

}  // namespace moltact
