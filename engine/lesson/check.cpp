#include "engine/lesson/check.h"

#include <map>
#include <optional>

#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

class Check {
 public:
  Check(const Lesson& lesson, const MoleculeByName& by_name) : lesson_(lesson), by_name_(by_name) {}

  std::vector<Problem> run() {
    for (const Step& step : lesson_.steps) {
      const Molecule* molecule = find(step.scene);
      if (!molecule) continue;
      if (step.states_scene) {
        selects(step.scene.highlight, step.scene.highlight_place, *molecule);
        selects(step.scene.facing, step.scene.view_place, *molecule);
      }
      for (const TaskSpec& task : step.tasks) {
        for (const auto& [key, value] : task.values) selects(value.selection, value.place, *molecule);
        if (task.kind == "cross") crosses(task, *molecule);
      }
    }
    return std::move(problems_);
  }

 private:
  const Molecule* find(const SceneSpec& scene) {
    const auto known = found_.find(scene.molecule);
    if (known != found_.end()) return known->second.get();
    auto molecule = by_name_(scene.molecule);
    if (!molecule) {
      const Problem& why = molecule.problem();
      add(scene.molecule_place, why.message, why.remedy);
      found_.emplace(scene.molecule, nullptr);
      return nullptr;
    }
    return found_.emplace(scene.molecule, *molecule).first->second.get();
  }

  void selects(const Selection& selection, Place place, const Molecule& molecule) {
    if (selection.given() && selection.select(molecule).empty())
      add(place, selection.whyEmpty(molecule), "name atoms that it has");
  }

  void crosses(const TaskSpec& task, const Molecule& molecule) {
    const AtomSet from(task.values["cross"].selection, molecule), to(task.values["to"].selection, molecule);
    for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
      const auto atom = static_cast<std::int32_t>(i);
      if (!from.has(atom) || !to.has(atom)) continue;
      add(task.values["to"].place, "the start and the end of the crossing have atoms in common", "choose atoms that are only in one");
      return;
    }
  }

  void add(Place place, std::string message, std::string remedy) {
    problems_.push_back({lesson_.file, place.line, place.column, std::move(message), std::move(remedy)});
  }

  const Lesson& lesson_;
  const MoleculeByName& by_name_;
  std::map<std::string, std::shared_ptr<const Molecule>> found_;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> checkAgainstMolecules(const Lesson& lesson, const MoleculeByName& molecule) {
  return Check(lesson, molecule).run();
}

}  // namespace moltact
