#include "engine/lesson/guide_file.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/servo/hand_path.h"
#include "engine/servo/servo_recording.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

Expected<HandPath> readRecordedWay(const std::filesystem::path& file, const Molecule& molecule) {
  if (file.extension() != ".recording") return readHandPath(file);
  const Expected<ServoRecording> recording = readServoRecording(file);
  if (!recording) return recording.problem();
  if (recording->ticks.empty())
    return Problem{file.string(), 0, 0, tr("the recording holds no ticks"), tr("record it again")};
  const RecordedScene scene = recordedScene(recording->labels, molecule.spheres);
  const auto balls = recording->labels.find("balls");
  if (balls != recording->labels.end() && balls->second != fingerprint(*scene.spheres))
    return Problem{file.string(), 0, 0, tr("this hand was recorded with other atoms than those of the scene"),
                   tr("record it in this scene")};
  const std::unique_ptr<Interaction> felt =
      makeInteraction(interactionInput(touchOf(*recording), molecule, scene.spheres, scene.body));
  return handPathOf(*recording, file.stem().string(), felt.get());
}

}  // namespace

Expected<GuidePath> readGuidePath(const std::filesystem::path& file, const Molecule& molecule) {
  const auto fail = [&](std::string message, std::string remedy) {
    return Problem{file.string(), 0, 0, std::move(message), std::move(remedy)};
  };
  const Expected<HandPath> path = readRecordedWay(file, molecule);
  if (!path) return path.problem();
  if (!path->on_molecule)
    return fail(tr("the rows are places of a device in millimetres, and a guide needs places in the molecule"),
                tr("write '# unit: A' and places in angstrom, or use a recording of this program"));
  const auto first = std::find(path->touched.begin(), path->touched.end(), true);
  const auto after = std::find(path->touched.rbegin(), path->touched.rend(), true).base();
  const bool touches = first != path->touched.end();
  const std::size_t begin = touches ? std::size_t(first - path->touched.begin()) : 0,
                    end = touches ? std::size_t(after - path->touched.begin()) : path->places.size();
  std::vector<Vec3> way;
  for (std::size_t k = begin; k < end; ++k)
    if (way.empty() || glm::distance(way.back(), path->places[k]) >= kGuideSpacing_A) way.push_back(path->places[k]);
  if (way.size() < 2)
    return fail(tr("the hand stays at one place, which is no way"), tr("record a hand that goes the way"));
  if (way.size() > GuidePath::kMaxPoints)
    return fail(
        trf("the way has {0} points {1} Å apart; a guide has at most {2}", way.size(), "0.1", GuidePath::kMaxPoints),
        tr("record only the way that is to be shown"));
  return GuidePath({std::move(way)});
}

}  // namespace moltact
