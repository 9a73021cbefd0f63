#include <algorithm>

#include "engine/render/glyphs.h"

namespace moltact {
namespace {

// An atom in the colour of the sphere that represents it.
LooseSphere looseAtom(const ViewScene& scene, const MoleculeModel& model, std::uint32_t atom) {
  const Sphere b = model.atomSphere(atom);
  const std::uint32_t sphere = model.sphereOf(atom);
  return {glm::vec3(scene.camera.toView({b.centre_A})), float(b.radius_A), model.colour[sphere],
          model.light.wide.empty() ? glm::vec4(0.0f) : model.light.wide[sphere]};
}

}  // namespace

void addNearSpheres(const ViewScene& scene, const MoleculeModel& model, std::vector<LooseSphere>& spheres) {
  if (!scene.hip || !(scene.look.spheres_near_A > 0) || !scene.shown.has(ViewPart::Atoms)) return;
  if (scene.look.allSpheres() && !model.byResidue()) return;
  constexpr std::size_t kMax = 400;
  const PointA place = *heldPlace(scene);
  const double held_A = scene.body ? scene.body->reach_A : scene.probe_A;
  const std::vector<std::uint32_t>* hidden = scene.look.hidden.get();
  for (const std::uint32_t a : nearestAtoms(model, place, held_A, scene.look.spheres_near_A, kMax)) {
    if (hidden && std::binary_search(hidden->begin(), hidden->end(), a)) continue;
    spheres.push_back(looseAtom(scene, model, a));
  }
}

void addTouchedSpheres(const ViewScene& scene, const MoleculeModel& model, std::vector<LooseSphere>& spheres) {
  if (!scene.touched_now || !scene.look.allSpheres() || !scene.shown.has(ViewPart::Atoms)) return;
  for (const std::uint32_t a : *scene.touched_now) {
    if (a >= model.atoms()) continue;
    LooseSphere sphere = looseAtom(scene, model, a);
    sphere.radius *= 1.004f;  // slightly in front of the atom that is already drawn
    sphere.colour = paintedColour(sphere.colour, scene.theme.touched);
    spheres.push_back(sphere);
  }
}

}  // namespace moltact
