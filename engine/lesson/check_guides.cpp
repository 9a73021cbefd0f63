// Checks the guides of tasks.
#include <filesystem>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/guide_file.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/lesson/scene_movers.h"
#include "engine/lesson/tasks/guided.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact::checks {
namespace {

namespace fs = std::filesystem;

void recordedHand(const std::string& file, Place place, const Molecule& molecule, const std::string& lesson_file,
                  Findings& findings) {
  const fs::path named(file), whole = fs::path(lesson_file).parent_path() / named;
  std::error_code error;
  if (named.is_absolute() || (!named.empty() && *named.lexically_normal().begin() == ".."))
    findings.error(place, trf("'{0}' lies outside of the lesson's folder, so no pack can hold it", file),
                   tr("put the file beside the lesson and write its name"));
  else if (!fs::is_regular_file(whole, error))
    findings.error(place, trf("there is no file '{0}' beside the lesson", file),
                   tr("put a recorded hand there, or write 'guide-path: way'"));
  else if (const auto way = readGuidePath(whole, molecule); !way)
    findings.error(place, trf("'{0}' guides no hand: {1}", file, way.problem().message), way.problem().remedy);
}

void ownWay(const TaskSpec& task, const SceneSpec& scene, const Molecule& molecule, Findings& findings) {
  const TaskKind* kind = findTaskKind(task.kind);
  const std::vector<std::uint32_t> untouchable = untouchableAtoms(scene, molecule);
  const std::unique_ptr<Task> inner = kind ? kind->make(task, molecule) : nullptr;
  if (!inner) return;
  inner->leaveOut(untouchable);
  if (wayOfTask(*inner, SphereGrid(molecule.spheres, untouchable), scene.touch.probe_A).empty())
    findings.error(task.values["guide"].place, trf("the guide has no way: {0}", tr(inner->noPlan())),
                   tr("name other atoms, or a recorded hand in 'guide-path'"));
}

}  // namespace

void guides(const Lesson& lesson, const MoleculeByName& molecule, Findings& findings) {
  for (const Step& step : lesson.steps)
    for (const TaskSpec& task : step.tasks) {
      if (!hasGuide(task) || findings.enough()) continue;
      const Place place = task.values["guide"].place;
      if (const auto movers = moversOf(step.scene); !movers.empty())
        findings.error(place, trf("a guide's way is at rest, and '{0}' moves the atoms", movers.front()->key),
                       trf("write 'guide: none', or {0}", tr(movers.front()->without)));
      const auto found = molecule(step.scene.molecule);
      if (!found) continue;  // reported with the molecules
      if (const std::string file = guideFile(task); !file.empty())
        recordedHand(file, task.values["guide-path"].place, **found, lesson.file, findings);
      else
        ownWay(task, step.scene, **found, findings);
    }
}

}  // namespace moltact::checks
