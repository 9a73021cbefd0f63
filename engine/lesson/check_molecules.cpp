// Checks a lesson against its molecules.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_set>

#include "engine/dynamics/begin_simulation.h"
#include "engine/dynamics/elastic_network.h"
#include "engine/dynamics/normal_modes.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/lesson_texts.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/second_state.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/molecule/reader.h"
#include "engine/structure/interaction_input.h"

namespace moltact::checks {
namespace {

class Check {
 public:
  Check(const Lesson& lesson, const MoleculeByName& by_name, Findings& findings)
      : lesson_(lesson), by_name_(by_name), findings_(findings) {}

  void run() {
    for (std::size_t i = 0; i < lesson_.molecules.size(); ++i)
      find(asFirstScene(lesson_.molecules[i]), lesson_.molecule_places[i], {});
    for (const Step& step : lesson_.steps) {
      if (step.scene.molecule.name.empty()) continue;
      const ScenePlaces& places = step.scene.places;
      const Molecule* molecule = find(step.scene.molecule, places.molecule, places.reading);
      if (!molecule) continue;
      if (step.states_scene) {
        selects(step.scene.highlight, places.highlight, *molecule);
        const auto sees = [&](const ViewSpec& view) {
          selects(view.facing, view.facing_place, *molecule);
          hasDirection(view, step.scene, *molecule);
          selects(view.zoom, view.zoom_place, *molecule);
        };
        sees(step.scene.view);
        for (const NamedView& v : step.scene.views) sees(v.view);
        selects(step.scene.cut_at, places.cut, *molecule);
        second(step.scene, *molecule);
        selects(step.scene.magnify, places.magnify, *molecule);
        selects(step.scene.hide, places.hide, *molecule);
        selects(step.scene.untouchable, places.untouchable, *molecule);
        selects(step.scene.remove, places.remove, *molecule);
        selects(step.scene.in_hand, places.in_hand, *molecule);
        selects(step.scene.pulled, places.pull, *molecule, untouchableAtoms(step.scene, *molecule));
        holds(step.scene, *molecule);
        hasCharges(step.scene, *molecule);
        keepsUp(step.scene, *molecule);
        fitsInPage(step.scene, *molecule);
        yields(step.scene, *molecule);
        selects(step.scene.hydrogen_bonds, places.hydrogen_bonds, *molecule);
        for (const auto* list : {&step.scene.labels, &step.scene.arrows, &step.scene.marks})
          for (const MarkSpec& mark : *list) selects(mark.atoms, mark.place, *molecule);
        for (const PlacesSpec& m : step.scene.measures)
          for (std::size_t i = 0; i < m.atoms.size(); ++i) selects(m.atoms[i], m.places[i], *molecule);
        for (const StyleSpec& style : step.scene.styles) selects(style.atoms, style.place, *molecule);
      }
      forEachText(step, [&](const RichText& text) {
        for (const TextRun& run : text)
          if (const auto link = sceneLink(run.link); link && link->kind == SceneLink::Kind::Zoom)
            if (const auto atoms = parseSelection(link->of)) selects(*atoms, run.link_place, *molecule);
      });
      const std::vector<std::uint32_t> untouchable = untouchableAtoms(step.scene, *molecule);
      for (const TaskSpec& task : step.tasks) {
        const TaskKind* kind = findTaskKind(task.kind);
        const bool held = kind && kind->names_held;
        for (const auto& [key, value] : task.values) {
          if (value.selection.given()) selects(value.selection, selectionPlace(value), *molecule, untouchable);
          for (const SelectionRemark& remark : value.remarks) selects(remark.atoms, remark.place, *molecule);
          for (std::size_t i = 0; i < value.path.size(); ++i)
            selects(value.path[i], value.places[i], *molecule, held ? std::vector<std::uint32_t>() : untouchable);
        }
        std::vector<Problem> problems;
        if (kind && kind->check_molecule) kind->check_molecule(task, *molecule, untouchable, problems);
        if (kind && kind->check_body && problems.empty()) body(*kind, task, step.scene, *molecule, problems);
        if (kind && kind->check_forces && problems.empty()) forces(*kind, task, step.scene, problems);
        for (Problem& p : problems) findings_.error({p.line, p.column}, std::move(p.message), std::move(p.remedy));
      }
    }
  }

 private:
  /// The second structure must exist and be superposable on the first.
  void second(const SceneSpec& scene, const Molecule& molecule) {
    if (scene.then.molecule.empty()) return;
    const Place place = scene.places.then;
    const Molecule* other = find(secondMolecule(scene), place, {});
    if (!other) return;
    if (scene.then.superposed_on.given()) selects(scene.then.superposed_on, place, molecule);
    if (const auto states = statesOf(scene, molecule, *other); !states)
      findings_.error(place, states.problem().message, states.problem().remedy);
  }

  /// What the hand holds, in every structure of the scene.
  void body(const TaskKind& kind, const TaskSpec& task, const SceneSpec& scene, const Molecule& molecule,
            std::vector<Problem>& problems) {
    const std::shared_ptr<const HeldBody> held = heldBody(molecule, heldAtoms(scene, molecule));
    if (!held || findings_.enough()) return;
    const std::vector<std::uint32_t> untouchable = untouchableAtoms(scene, molecule);
    std::vector<SphereGrid> grids;
    grids.emplace_back(molecule.spheres, untouchable);
    if (!scene.then.molecule.empty())
      if (const auto& other = lookUp(secondMolecule(scene)))
        if (const auto states = statesOf(scene, molecule, **other)) grids.emplace_back(states->second, untouchable);
    std::vector<StructureChoice> structures;
    for (std::size_t k = 0; k < grids.size(); ++k) structures.push_back({double(k), &grids[k]});
    kind.check_body(task, held, structures, problems);
  }

  /// The forces between atoms in the scene.
  void forces(const TaskKind& kind, const TaskSpec& task, const SceneSpec& scene, std::vector<Problem>& problems) {
    const auto& molecule = lookUp(scene.molecule);
    if (!molecule || findings_.enough()) return;
    if (const auto felt = sceneForces(scene, *molecule, untouchableAtoms(scene, **molecule),
                                      heldBody(**molecule, heldAtoms(scene, **molecule))))
      kind.check_forces(task, *felt, problems);
  }

  /// A selection that is turned to the front must not be nearly the whole molecule.
  void hasDirection(const ViewSpec& view, const SceneSpec& scene, const Molecule& molecule) {
    if (!view.facing.given() || findings_.enough()) return;
    if (!nearlyAllPresent(presentAtoms(view.facing, scene, molecule), scene, molecule)) return;
    if (!undirected_.insert({view.facing_place.line, view.facing_place.column}).second) return;
    findings_.warning(
        view.facing_place,
        tr("nearly all atoms that the scene has left cannot be in front of the others; the molecule is seen "
           "along its thinnest axis"),
        tr("name the atoms that are to be in front, or write 'turned' and angles"));
  }

  /// The held body must not exceed the maximum, and something must be left to touch.
  void holds(const SceneSpec& scene, const Molecule& molecule) {
    const std::vector<std::uint32_t> held = heldAtoms(scene, molecule);
    if (held.size() > kMaxHeldAtoms)
      findings_.error(scene.places.in_hand,
                      trf("{0} atoms are more than a hand can hold; {1} are the most", held.size(), kMaxHeldAtoms),
                      tr("name fewer: a ligand, a side chain"));
    if (!held.empty() && untouchableAtoms(scene, molecule).size() == molecule.atoms.size())
      findings_.error(scene.places.in_hand, tr("the hand holds all there is, and nothing is left to feel"),
                      tr("name fewer atoms"));
  }

  // A large molecule moves more slowly than the scene's second says.
  void keepsUp(const SceneSpec& scene, const Molecule& molecule) {
    if (scene.simulation.empty() || simulationAddress(scene.simulation)) return;
    if (molecule.atoms.size() <= kMaxFluent || molecule.atoms.size() > kMaxSimulated) return;
    findings_.warning(
        scene.places.simulation,
        trf("a molecule of {0} atoms makes fewer than 1000 steps per second on two cores: its answer to the hand comes "
            "late",
            molecule.atoms.size()),
        trf("take a part of it, of at most {0} atoms, or measure on your computers: moltact simulate run", kMaxFluent));
  }

  // The desktop program simulates larger molecules than a page can.
  void fitsInPage(const SceneSpec& scene, const Molecule& molecule) {
    if (scene.simulation.empty() || simulationAddress(scene.simulation)) return;
    if (molecule.atoms.size() <= kMaxSimulatedInPage) return;
    findings_.warning(scene.places.simulation,
                      trf("a page in a browser simulates at most {0} atoms: it shows this molecule, of {1}, at rest",
                          kMaxSimulatedInPage, molecule.atoms.size()),
                      tr("take a part of it, or have students use the desktop program"));
  }

  /// The molecule must have an elastic network, and the motions that the scene names.
  void yields(const SceneSpec& scene, const Molecule& molecule) {
    if (!scene.elastic || findings_.enough()) return;
    const auto network = ElasticNetwork::make(molecule, ElasticNetwork::kCutOff_A, heldAtoms(scene, molecule));
    const Place place = network ? scene.places.modes : scene.places.elastic;
    if (!place.line || !reported_.insert({"elastic " + scene.molecule.name, place.line, place.column}).second) return;
    if (!network) return findings_.error(place, network.problem().message, network.problem().remedy);
    const std::size_t count = std::min(kElasticModes, 3 * network->nodes().size() - 6);
    if (scene.elastic_modes.empty() || scene.elastic_modes.back() < count) return;
    findings_.error(place,
                    trf("the molecule has {0} motions as an elastic network; there is no motion {1}", count,
                        scene.elastic_modes.back() + 1),
                    trf("write numbers from 1 to {0}, or leave 'modes' out", count));
  }

  /// The file must contain the charges that the scene uses.
  void hasCharges(const SceneSpec& scene, const Molecule& molecule) {
    if (scene.touch.charges == kFormalCharges && forceChoice(scene.touch.forces).feelsCharges() &&
        !findings_.enough() &&
        reported_.insert({"charges", scene.places.charges.line, scene.places.charges.column}).second)
      findings_.warning(scene.places.charges,
                        tr("formal charges replace the partial ones in the forces between atoms: only "
                           "charged side chains and phosphates act, not ligands, ions and hydrogen bonds"),
                        tr("take the line out, unless that is what students are to feel"));
    if (scene.touch.charges != kFileCharges || !molecule.charges_e.empty() || findings_.enough()) return;
    findings_.error(
        scene.places.charges, trf("the file of '{0}' has no partial charges", scene.molecule.name),
        trf("write 'charges: formal', or give the molecule as a file with charges ({0})", chargedEndingsText()));
  }

  /// A molecule in the front matter's list, with the reading options of the first scene that uses it, so that it is not
  /// read separately.
  NamedMolecule asFirstScene(const std::string& name) const {
    for (const Step& step : lesson_.steps) {
      if (step.scene.molecule.name == name) return step.scene.molecule;
      if (step.scene.then.molecule == name) return secondMolecule(step.scene);
      if (step.scene.molecule.reading.beside == name) return besideMolecule(step.scene);
    }
    return name;
  }

  const Expected<std::shared_ptr<const Molecule>>& lookUp(const NamedMolecule& named) {
    std::pair<std::string, std::string> key{named.name, readingText(named.reading)};
    const auto known = found_.find(key);
    return known != found_.end() ? known->second : found_.emplace(std::move(key), by_name_(named)).first->second;
  }

  /// The molecule, or nullptr with an error at each place that names it. If only the reading options are at fault, the
  /// error is at their place, if there is one.
  const Molecule* find(const NamedMolecule& named, Place place, Place reading_place) {
    if (findings_.enough()) return nullptr;
    const auto& found = lookUp(named);
    if (found) return found->get();
    const Problem& why = found.problem();
    if (named.reading != ReadOptions() && lookUp(named.name)) {
      if (!reading_place.line) return nullptr;
      place = reading_place;
    }
    // A scene that continues the previous one must not repeat its errors.
    if (reported_.insert({named.name, place.line, place.column}).second)
      findings_.error(place, why.message, why.remedy);
    return nullptr;
  }

  /// Adds an error if it selects nothing, or for a task nothing touchable.
  void selects(const Selection& selection, Place place, const Molecule& molecule,
               const std::vector<std::uint32_t>& untouchable = {}) {
    if (!selection.given() || findings_.enough()) return;
    // A scene that continues the previous one must not repeat its errors.
    if (!reported_.insert({selection.text(), place.line, place.column}).second) return;
    const auto at = [&](const Problem& p) { return Place{place.line, place.column + p.column - 1}; };
    const std::vector<std::uint32_t> atoms = selection.select(molecule);
    if (atoms.empty()) {
      Problem why = selection.whyEmpty(molecule);
      findings_.error(at(why), std::move(why.message), std::move(why.remedy));
      return;
    }
    if (std::includes(untouchable.begin(), untouchable.end(), atoms.begin(), atoms.end())) {
      findings_.error(place, tr("nothing of this can be touched: the scene takes it from the hand"),
                      tr("name other atoms, or change the scene's 'untouchable' or 'remove'"));
      return;
    }
    for (Problem& idle : selection.unmatchedNames(molecule))
      findings_.warning(at(idle), std::move(idle.message), std::move(idle.remedy));
  }

  const Lesson& lesson_;
  const MoleculeByName& by_name_;
  Findings& findings_;
  std::map<std::pair<std::string, std::string>, Expected<std::shared_ptr<const Molecule>>> found_;  // by name and
                                                                                                    // reading options
  std::set<std::pair<std::size_t, std::size_t>> undirected_;              // places of 'facing' with a warning so far
  std::set<std::tuple<std::string, std::size_t, std::size_t>> reported_;  // selections and names reported so far, with
                                                                          // their places
};

}  // namespace

void molecules(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings) {
  Check(lesson, molecule, findings).run();
}

void moleculeList(const Lesson& lesson, Findings& findings) {
  std::unordered_set<std::string_view> used, listed;
  for (const Step& s : lesson.steps)
    used.insert({s.scene.molecule.name, s.scene.then.molecule, s.scene.molecule.reading.beside});
  for (std::size_t i = 0; i < lesson.molecules.size(); ++i) {
    const std::string& name = lesson.molecules[i];
    if (!listed.insert(name).second)
      findings.error(lesson.molecule_places[i], trf("'{0}' is listed twice", name), tr("take one of the two out"));
    else if (!used.contains(name))
      findings.error(lesson.molecule_places[i], trf("no scene uses '{0}'", name),
                     trf("take it out, or add a scene with 'molecule: {0}'", name));
  }
}

}  // namespace moltact::checks
