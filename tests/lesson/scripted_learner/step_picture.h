// The picture of a step of one of the program's lessons, and the contact of a press at a place in it.
#pragma once

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>

#include "engine/haptics/sweep.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/render/camera.h"
#include "tests/lesson/shipped_lesson.h"

namespace moltact::test {

/// Reads each molecule once for all steps.
inline Expected<std::shared_ptr<const Molecule>> knownMolecule(const NamedMolecule& named) {
  static std::map<NamedMolecule, std::shared_ptr<const Molecule>> read;
  if (const auto known = read.find(named); known != read.end()) return known->second;
  auto molecule = shippedMolecule(named);
  if (!molecule) return molecule.problem();
  return read[named] = *molecule;
}

struct StepPicture {
  static constexpr int kSize_px = 800;

  explicit StepPicture(const Step& step)
      : scene(step.scene),
        molecule(*knownMolecule(scene.molecule)),
        spheres(molecule->spheres, untouchableAtoms(scene, *molecule)),
        part(zoomedRegion(scene.view, scene, *molecule, scene.touch.probe_A)) {
    if (!part) part = magnifiedRegion(scene, *molecule);
  }

  /// The camera at the start of the step, or with the molecule rotated as in the dark.
  const Camera& camera(const std::optional<Quat>& turned = std::nullopt) const {
    if (camera_ && of_ == turned) return *camera_;
    Camera c;
    if (!part || !turned) c.fit(*molecule, 1.0);
    if (turned)
      c.orientation = *turned;
    else
      face(c);
    if (part)
      c.fit(part->centre, part->radius_A, 1.0);
    else
      c.fit(*molecule, 1.0, 0.08, 1.5 * scene.touch.probe_A);
    of_ = turned;
    return camera_.emplace(c);
  }

  Vec3 middle(std::span<const std::uint32_t> atoms) const {
    Vec3 sum(0.0);
    for (const std::uint32_t a : atoms) sum += molecule->spheres[a].centre_A / double(atoms.size());
    return sum;
  }

  /// The place of these atoms' centre in the picture at the start of the step.
  glm::dvec2 seen(std::span<const std::uint32_t> atoms) const {
    const Vec3 at = camera().project({middle(atoms)}, kSize_px, kSize_px);
    return {at.x, at.y};
  }

  Hit press(const Camera& c, glm::dvec2 at_px, double probe_A, Vec3& scp_A) const {
    const Ray ray = c.rayThrough(at_px.x, at_px.y, kSize_px, kSize_px);
    const Vec3 end = ray.origin.A + ray.direction * (2.0 * c.distance_A);
    const Hit hit = sweep(spheres, probe_A, ray.origin.A, end);
    scp_A = ray.origin.A + (end - ray.origin.A) * hit.t;
    return hit;
  }

  SceneSpec scene;
  std::shared_ptr<const Molecule> molecule;
  SphereGrid spheres;
  std::optional<Region> part;  // the part that fills the view

 private:
  void face(Camera& c) const {
    constexpr double kQuarter = 0.5 * std::numbers::pi;
    const ViewSpec& view = scene.view;
    if (view.facing.given()) {
      const auto atoms = presentAtoms(view.facing, scene, *molecule);
      if (nearlyAllPresent(atoms, scene, *molecule)) {
        std::vector<Vec3> places_A;
        for (const std::uint32_t a : atoms) places_A.push_back(molecule->spheres[a].centre_A);
        c.lookAlongThinnest(places_A);
      } else if (!atoms.empty()) {
        c.face({middle(atoms)});
      }
    } else if (view.turned_deg) {
      c.lookFrom((*view.turned_deg)[0] / 90.0 * kQuarter, (*view.turned_deg)[1] / 90.0 * kQuarter);
      c.roll((*view.turned_deg)[2] / 90.0 * kQuarter);
    } else if (view.side == "side" && molecule->beside_from == 0) {
      c.lookSideOn(*molecule);
    } else {
      c.lookFrom(view.side == "back"    ? 2 * kQuarter
                 : view.side == "left"  ? -kQuarter
                 : view.side == "right" ? kQuarter
                                        : 0.0,
                 view.side == "top"      ? kQuarter
                 : view.side == "bottom" ? -kQuarter
                                         : 0.0);
    }
  }

  mutable std::optional<Camera> camera_;
  mutable std::optional<Quat> of_;
};

}  // namespace moltact::test
