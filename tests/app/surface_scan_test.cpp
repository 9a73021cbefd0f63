// The scanning tip of a scene in the window: its picture grows, and its surface is touched instead of the atoms. Oracle:
// the closed form of the tip's height.
#include "app/ui/extensions/surface_scan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/ui/extensions/extensions.h"
#include "engine/haptics/height_field/height_field_tracker.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

std::string scanLesson(const std::string& keys) {
  return "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: pentacene, 1ubq\nauthor: A\nlicence: L\n---\n## One\n"
         "```scene\nmolecule: pentacene\nview: front\n" +
         keys +
         "```\n```touch\nreach: atom 1-36\nsay: Touch it.\n```\n\n> [!TIP]\n> Look.\n\n## Two\n```scene\nscan: 0 "
         "Å\n```\nText.\n";
}

// The tip's heights over a place of the scan's frame, on each atom that it can touch there.
std::vector<double> heightsOver(const Molecule& molecule, const HeightField& field, int column, int row) {
  std::vector<double> out;
  for (const Sphere& s : molecule.spheres) {
    const Vec3 c = field.frame.toScan(s.centre_A);
    const double d = std::hypot(field.spacing_A * column - c.x, field.spacing_A * row - c.y), reach = s.radius_A + 5;
    if (d < reach) out.push_back(c.z - 5 + std::sqrt(reach * reach - d * d));
  }
  return out;
}

// A second has 60 frames.
void passSeconds(ScriptedUser& user, double s) { user.frames(int(std::lround(60 * s))); }

}  // namespace

TEST_CASE(
    "a scan of 20 s grows line by line in the window; then the hand touches its surface and not the atoms, which does "
    "no "
    "task, and the next step ends it") {
  const Scratch scratch;
  const auto user = startWith(scratch.file("mine.md", scanLesson("scan: 5 Å\n")).string());
  Application& app = user->app();
  SurfaceScan& scan = app.extensions().surface_scan;
  REQUIRE(scan.on());
  CHECK(scan.running());
  passSeconds(*user, 10);
  const int half = scan.lines();
  CHECK(std::abs(half - scan.field().rows / 2) <= scan.field().rows / 10);
  scan.touch(true);
  CHECK_FALSE(scan.touching());  // it is not complete yet
  passSeconds(*user, 12);
  CHECK_FALSE(scan.running());
  CHECK(scan.lines() == scan.field().rows);
  const HeightField& field = scan.field();
  const Molecule& molecule = *app.scene.stage().molecule;
  double worst = 0.0, highest = 0.0;
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      double height = 0.0;
      for (const double h : heightsOver(molecule, field, column, row)) height = std::max(height, h);
      worst = std::max(worst, std::abs(height - field.at(column, row)));
      highest = std::max(highest, height);
    }
  CHECK(worst < 1e-9);

  user->click("view/scan/touch");
  user->frames(2);
  REQUIRE(scan.touching());
  const HeightFieldTracker surface(std::make_shared<const HeightField>(field));
  for (const double x : {0.5, 0.62}) {
    user->point("view", x, 0.5);
    user->frames(60);
    user->press();
    user->frames(120);
    const Contact& contact = app.scene.log().latest().contact;
    REQUIRE(contact.touching());
    const Vec3 local = field.frame.toScan(contact.scp.A);
    CHECK(std::abs(local.z - surface.heightAt(local.x, local.y)) < 1e-6);
    CHECK(glm::length(contact.displacement_A) > 0.02);
    user->release();
    user->frames(60);
  }
  CHECK_FALSE(app.lesson.session()->task(0).done);
  user->click("view/scan/touch");
  user->frames(2);
  CHECK_FALSE(scan.touching());
  app.lesson.next();
  user->frames(20);
  CHECK_FALSE(scan.on());
}

TEST_CASE(
    "a scan at 50 pN sinks 0.5 A into an atom that it touches alone, 1 A at 100 pN, nowhere more, and its surface is "
    "felt") {
  const Scratch scratch;
  const auto user = startWith(scratch.file("mine.md", scanLesson("scan: 5 Å, 50 pN\n")).string());
  Application& app = user->app();
  SurfaceScan& scan = app.extensions().surface_scan;
  REQUIRE(scan.on());
  CHECK(scan.setup().force_pN == 50.0);
  user->frames(2);
  CHECK(user->text("view/scan/words").starts_with("Scanning at 50 pN: "));
  passSeconds(*user, 21);
  CHECK_FALSE(scan.running());
  const HeightField& field = scan.field();
  const Molecule& molecule = *app.scene.stage().molecule;
  // Where one atom alone carries the tip it yields by F/k = 0.5 A; several carry it together, each by the depth of the
  // tip under its own height.
  int alone = 0;
  double worst_N_per_m = 0.0;
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const std::vector<double> heights = heightsOver(molecule, field, column, row);
      const double z = field.at(column, row);
      if (z <= 1e-9) continue;  // on the substrate
      double force_pN = 0.0;
      int carriers = 0;
      for (const double h : heights)
        if (h > z) force_pN += 100.0 * (h - z), ++carriers;
      alone += carriers == 1;
      worst_N_per_m = std::max(worst_N_per_m, std::abs(force_pN - 50.0));
    }
  CHECK(worst_N_per_m < 1e-6);
  CHECK(alone > 10);
  user->click("view/scan/touch");
  user->frames(2);
  REQUIRE(scan.touching());
  const HeightFieldTracker surface(std::make_shared<const HeightField>(field));
  user->point("view", 0.5, 0.5);
  user->frames(60);
  user->press();
  user->frames(120);
  const Contact& contact = app.scene.log().latest().contact;
  REQUIRE(contact.touching());
  const Vec3 local = field.frame.toScan(contact.scp.A);
  CHECK(std::abs(local.z - surface.heightAt(local.x, local.y)) < 1e-6);
}

TEST_CASE("a scan is no part of free exploration, and another molecule ends the touch of one") {
  const Scratch scratch;
  const auto user = startWith(scratch.file("mine.md", scanLesson("scan: 5 Å\n")).string());
  Application& app = user->app();
  SurfaceScan& scan = app.extensions().surface_scan;
  passSeconds(*user, 21);
  scan.touch(true);
  CHECK(scan.touching());
  app.open("1ubq");
  app.finishLoading();
  user->frames(5);
  CHECK_FALSE(scan.on());
  CHECK_FALSE(scan.touching());
  CHECK(app.scene.scanned().field() == nullptr);
}

}  // namespace moltact
