// A lesson against its molecules.
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <unordered_set>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact::checks {
namespace {

class Check {
 public:
  Check(const Lesson& lesson, const MoleculeByName& by_name, Findings& findings)
      : lesson_(lesson), by_name_(by_name), findings_(findings) {}

  void run() {
    for (std::size_t i = 0; i < lesson_.molecules.size(); ++i) find(lesson_.molecules[i], lesson_.molecule_places[i]);
    for (const Step& step : lesson_.steps) {
      if (step.scene.molecule.empty()) continue;
      const Molecule* molecule = find(step.scene.molecule, step.scene.molecule_place);
      if (!molecule) continue;
      if (step.states_scene) {
        selects(step.scene.highlight, step.scene.highlight_place, *molecule);
        selects(step.scene.facing, step.scene.view_place, *molecule);
        selects(step.scene.magnify, step.scene.magnify_place, *molecule);
      }
      for (const TaskSpec& task : step.tasks) {
        for (const auto& [key, value] : task.values) {
          if (value.selection.given()) selects(value.selection, selectionPlace(value), *molecule);
          for (std::size_t i = 0; i < value.path.size(); ++i) selects(value.path[i], value.places[i], *molecule);
        }
        if (task.kind == "cross") crosses(task, *molecule);
      }
    }
  }

 private:
  /// The molecule, or nullptr and an error at each place where it is named.
  const Molecule* find(const std::string& name, Place place) {
    if (findings_.enough()) return nullptr;
    auto known = found_.find(name);
    if (known == found_.end()) known = found_.emplace(name, by_name_(name)).first;
    if (known->second) return known->second->get();
    const Problem& why = known->second.problem();
    // A scene that goes on from the one before names nothing anew.
    if (told_.insert({name, place.line, place.column}).second) findings_.error(place, why.message, why.remedy);
    return nullptr;
  }

  void selects(const Selection& selection, Place place, const Molecule& molecule) {
    if (!selection.given() || findings_.enough()) return;
    const auto at = [&](const Problem& p) { return Place{place.line, place.column + p.column - 1}; };
    if (selection.select(molecule).empty()) {
      Problem why = selection.whyEmpty(molecule);
      findings_.error(at(why), std::move(why.message), std::move(why.remedy));
      return;
    }
    for (Problem& idle : selection.idleNames(molecule))
      findings_.warning(at(idle), std::move(idle.message), std::move(idle.remedy));
  }

  void crosses(const TaskSpec& task, const Molecule& molecule) {
    const Value &from_value = task.values["cross"], &to_value = task.values["to"];
    if (!from_value.selection.given() || !to_value.selection.given()) return;
    const AtomSet from(from_value.selection, molecule), to(to_value.selection, molecule);
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
      const auto atom = static_cast<std::int32_t>(i);
      if (!from.has(atom) || !to.has(atom)) continue;
      findings_.error(to_value.place, tr("the start and the end of the crossing have atoms in common"),
                      tr("choose atoms that are only in one"));
      return;
    }
  }

  const Lesson& lesson_;
  const MoleculeByName& by_name_;
  Findings& findings_;
  std::map<std::string, Expected<std::shared_ptr<const Molecule>>> found_;
  std::set<std::tuple<std::string, std::size_t, std::size_t>> told_;  // the places where a missing molecule was named
};

}  // namespace

void molecules(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings) {
  Check(lesson, molecule, findings).run();
}

void moleculeList(const Lesson& lesson, Findings& findings) {
  std::unordered_set<std::string_view> used, listed;
  for (const Step& s : lesson.steps) used.insert(s.scene.molecule);
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
