// A contact that remains although the hand is in free space is released after a while. A contact with a reason remains:
// if the spheres have moved to the hand, or if a body touches with its rim.
#include <doctest/doctest.h>

#include <memory>

#include "app/ui/scene/haptic_session.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact {
namespace {

constexpr double kFrame_s = 1.0 / 60.0;

struct Touched {
  /// The hand holds a body of atoms there that are felt as large as a water molecule; none: the probe.
  explicit Touched(const std::vector<Vec3>& held = {}) : scene(ServoClock::Frames) {
    std::vector<PlacedAtom> placed;
    PlacedAtom atom;
    atom.radius_A = 1.6;
    placed.push_back(atom);
    std::vector<std::uint32_t> atoms;
    for (const Vec3& place : held) {
      atom.position.A = place;
      atom.radius_A = kWaterProbe_A + kBodyOverlap_A;
      atoms.push_back(std::uint32_t(placed.size()));
      placed.push_back(atom);
    }
    Molecule molecule;
    molecule.setAtoms(placed);
    auto made = makeTouchableModel(std::move(molecule), "ball.pdb");
    REQUIRE(made);
    scene.show(withUntouchable(*made, atoms, atoms), {"ball.pdb"}, [](Camera&, const Molecule&) {});
  }
  /// A second and a half of frames with the hand there.
  void hold(Vec3 place_A, double s = 1.5) {
    for (double t = 0.0; t < s; t += kFrame_s) {
      scene.servo().mouse().lead(scene.servo_settings.workspace.toDevice({place_A}));
      for (const FeltTick& tick : scene.advance(kFrame_s, now_s += kFrame_s, false).ticks) {
        touching += tick.sample.contact.touching();
        grid_spacing_A = std::max(grid_spacing_A, glm::distance(tick.exact.scp.A, tick.sample.contact.scp.A));
        differing += tick.exact.touching() != tick.sample.contact.touching();
      }
    }
  }
  /// Moves the only sphere to z within 30 ticks.
  void moveTo(double z_A) {
    const std::vector<Sphere> to{{{0, 0, z_A}, 1.6}};
    auto next = motion ? SphereMotion::after(*motion, to, 30)
                       : SphereMotion::make(std::vector<Sphere>{{{0, 0, 0}, 1.6}}, to, 30);
    REQUIRE(next);
    motion = *std::move(next);
    REQUIRE(scene.servo().setMotion(motion));
  }
  const ServoSample& now() const { return scene.log().latest(); }

  HapticSession scene;
  std::shared_ptr<const SphereMotion> motion;
  double now_s = 0.0, grid_spacing_A = 0.0;
  long touching = 0, differing = 0;
};

}  // namespace

TEST_CASE("the contact of a hand that has come out on a sphere's far side ends after 0.4 s") {
  Touched t;
  t.hold({0, 0, 5});
  t.hold({0, 0, 2.5}, 0.5);
  REQUIRE(t.scene.log().touching());
  t.hold({0, 0, -4}, 0.3);
  CHECK(t.scene.log().touching());
  t.hold({0, 0, -4}, 1.0);
  CHECK_FALSE(t.scene.log().touching());
}

TEST_CASE(
    "a sphere that has moved 3 A to a hand, who was in the open where it rested, stays felt for 1.5 s, and the exact "
    "contact beside it is the felt one to 1e-9 A; pulled through to its far side the hand is let go there too") {
  Touched t;
  t.hold({0, 0, 4.5});
  REQUIRE_FALSE(t.scene.log().touching());
  const std::uint32_t placed = t.now().discontinuities;
  t.moveTo(3.0);
  t.hold({0, 0, 4.5});
  CHECK(t.scene.log().touching());
  CHECK(t.now().contact.scp.A.z == doctest::Approx(6.0));
  CHECK(t.now().discontinuities == placed);
  CHECK(t.touching > 1400);
  CHECK(t.differing == 0);
  CHECK(t.grid_spacing_A < 1e-9);
  for (const double z : {2.5, 3.2, 2.8}) {  // and on, motion after motion
    t.moveTo(z);
    t.hold({0, 0, 4.5}, 0.2);
  }
  CHECK(t.grid_spacing_A < 1e-9);
  CHECK(t.now().contact.scp.A.z == doctest::Approx(5.8));
  t.hold({0, 0, -1}, 0.3);
  CHECK(t.scene.log().touching());
  t.hold({0, 0, -1}, 1.0);
  CHECK_FALSE(t.scene.log().touching());
}

TEST_CASE("a body whose one end presses on a sphere while its middle is in the open is not let go") {
  Touched t({{1.5, 0, 0}, {-1.5, 0, 0}});
  t.hold({4.8, 0, 0});
  REQUIRE_FALSE(t.scene.log().touching());
  const std::uint32_t placed = t.now().discontinuities;
  t.hold({4.0, 0, 0});  // an end 1.5 A nearer: 0.5 A inside the sphere of 1.6 A that its 1.4 A are felt by
  CHECK(t.scene.log().touching());
  CHECK(glm::length(t.now().contact.displacement_A) == doctest::Approx(0.5).epsilon(0.01));
  CHECK(t.now().discontinuities == placed);
  CHECK(t.scene.watch().tried().empty());  // and no error is recorded for any method
}

TEST_CASE(
    "a body of springs that was led straight through a sphere, and whose atoms wait on its far side, is let go once it "
    "is outside; the exact body comes round the sphere to the hand by itself") {
  for (const char* interaction : {"springs", "exact-body"}) {
    CAPTURE(interaction);
    Touched t({{0, 0, 1.5}, {0, 0, -1.5}});
    TouchSetup touch = t.scene.touch();
    touch.interaction = interaction;
    t.scene.setTouch(touch);
    REQUIRE(t.scene.touch().interaction == interaction);
    t.hold({0, 0, 8});
    REQUIRE_FALSE(t.scene.log().touching());
    t.hold({0, 0, 1}, 0.3);
    t.hold({0, 0, -2}, 1.0);  // one of its atoms is still inside
    CHECK(t.scene.log().touching());
    t.hold({0, 0, -6}, 0.3);
    CHECK(t.scene.log().touching() == (touch.interaction == "springs"));
    t.hold({0, 0, -6}, 1.0);
    CHECK_FALSE(t.scene.log().touching());
    CHECK(glm::distance(t.now().shownBody().place.A, Vec3(0, 0, -6)) < 0.01);
  }
}

}  // namespace moltact
