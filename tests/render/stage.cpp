#include "tests/render/stage.h"

#include <cstdlib>

#include "engine/platform/offscreen_gl.h"

namespace moltact::test {

Renderer& renderer() {
  static auto gl = OffscreenGl::create();
  if (!gl) FAIL(gl.problem().text());
  static auto made = Renderer::create();
  if (!made) FAIL(made.problem().text());
  return **made;
}

std::shared_ptr<const Molecule> molecule(const std::vector<PlacedAtom>& atoms) {
  Molecule m;
  m.setAtoms(atoms);
  return std::make_shared<const Molecule>(std::move(m));
}

PlacedAtom atom(Vec3 place_A, double radius_A, int atomic_number) {
  PlacedAtom a;
  a.position.A = place_A;
  a.radius_A = radius_A;
  a.atomic_number = std::uint8_t(atomic_number);
  return a;
}

Camera frontCamera(double distance_A) {
  Camera camera;
  camera.distance_A = distance_A;
  return camera;
}

Picture drawn(const ViewScene& scene, int width_px, int height_px, const RenderOptions& options) {
  Renderer& r = renderer();
  const auto problem = r.draw(scene, width_px, height_px, options);
  if (problem) FAIL(problem->text());
  return r.readPixels();
}

Difference compare(const Picture& a, const Picture& b, int level) {
  REQUIRE(a.width_px == b.width_px);
  REQUIRE(a.height_px == b.height_px);
  Difference d;
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    int most = 0;
    for (std::size_t k = i; k < i + 3; ++k) {
      const int off = std::abs(int(a.rgb[k]) - int(b.rgb[k]));
      most = std::max(most, off);
      sum += off;
    }
    d.largest = std::max(d.largest, most);
    d.pixels += most > level;
  }
  d.mean = sum / double(a.rgb.size());
  return d;
}

ViewScene rodInHand() {
  ViewScene scene;
  scene.molecule = molecule({atom(Vec3(0, -1.7, 0), 1.6, 18), atom(Vec3(-2, 6, 0), 1.4, 8), atom(Vec3(0, 6, 0), 1.4, 8),
                             atom(Vec3(2, 6, 0), 1.4, 8)});
  const std::uint32_t held[] = {1, 2, 3};
  scene.body = heldBody(scene.molecule->spheres, held);
  scene.look.hidden = std::make_shared<const std::vector<std::uint32_t>>(std::vector<std::uint32_t>{1, 2, 3});
  scene.camera = frontCamera(22);
  scene.contact.scp.A = Vec3(0.6, 1, 0);
  scene.contact.feature = Feature::Sphere;
  scene.contact.atoms = {0, -1, -1};
  scene.hip = PointA{Vec3(0.6, -1, 0)};
  stretchToScp(scene.contact, *scene.hip);
  scene.body_place = scene.contact.scp;
  scene.hand_orientation = glm::angleAxis(0.5, Vec3(0, 0, 1));
  scene.body_stopped = {{1, 1.0}};
  scene.stopped_by = {{0, 1.0}};
  scene.force_N = 1.0;
  scene.torque_N_A = Vec3(0, 0, -1.5);
  scene.shown = {ViewPart::Atoms, ViewPart::Probe, ViewPart::Force};
  return scene;
}

}  // namespace moltact::test
