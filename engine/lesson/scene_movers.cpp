#include "engine/lesson/scene_movers.h"

#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kMovers{
    MoverKey{"then", N_("leave out 'then'"), false, &ScenePlaces::then,
             [](const SceneSpec& s) { return !s.then.molecule.empty(); }},
    MoverKey{"elastic", N_("write 'elastic: off'"), true, &ScenePlaces::elastic,
             [](const SceneSpec& s) { return s.elastic; }},
    MoverKey{"simulation", N_("write 'simulation: none'"), true, &ScenePlaces::simulation,
             [](const SceneSpec& s) { return !s.simulation.empty(); }},
    MoverKey{"trajectory", N_("write 'trajectory: none'"), true, &ScenePlaces::trajectory,
             [](const SceneSpec& s) { return !s.trajectory.file.empty(); }},
};

}  // namespace

std::span<const MoverKey> moverKeys() { return kMovers; }

std::vector<const MoverKey*> moversOf(const SceneSpec& scene) {
  std::vector<const MoverKey*> out;
  for (const MoverKey& mover : kMovers)
    if (mover.moves(scene)) out.push_back(&mover);
  return out;
}

}  // namespace moltact
