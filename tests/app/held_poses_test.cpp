// The poses of a held body in forces between atoms: the list, the minimum, saved poses and the way back. Ticks run on the
// frames' clock.
#include "app/ui/extensions/held_poses.h"

#include <algorithm>
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "engine/bench/energies/double_sum.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/molecule/reader.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

const std::string kDrugScene = "```scene\nmolecule: 1hpv\nin-hand: ligand\nforces: all\n```\n";

struct PoseWindow {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;

  explicit PoseWindow(const std::string& steps) {
    const std::string head =
        "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - 1hpv\nauthor: A\nlicence: L\n---\n";
    d = startWith(scratch.file("mine.md", head + steps).string());
    d->app().panels.tabs.open("touch");
    d->frames(5);
  }
  HapticSession& scene() { return d->app().scene; }
  HeldPoses& poses() { return d->app().extensions().held_poses; }
  /// Presses at this place of the view until the body is at rest.
  void pressAt(double x, double y, int frames) {
    d->point("view", x, y);
    d->frames(10);
    d->press();
    d->frames(frames);
    d->release();
    d->frames(10);
  }
  bench::DoubleSum sum() {
    const PairField& f = *scene().forces().field();
    REQUIRE(f.model.kind == Dielectric::MehlerSolmajer);
    return bench::DoubleSum(f.places, f.atoms, f.held, f.model.cutoff_A, false);
  }
};

}  // namespace

TEST_CASE(
    "each listed pose of amprenavir has the energy of the sum in double precision, at least 0.1 kcal/mol below the "
    "pose "
    "before, and its distance from the file's pose; no more than 12 are listed") {
  PoseWindow w("## One\n" + kDrugScene + "Text.\n");
  REQUIRE(w.poses().on());
  for (const double y : {0.5, 0.6, 0.4}) w.pressAt(0.5, y, 240);
  const std::vector<HeldPose>& list = w.poses().list();
  REQUIRE(list.size() >= 2);
  CHECK(list.size() <= HeldPoses::kMaxPoses);
  bench::DoubleSum sum = w.sum();
  const HeldBody& body = *w.scene().stage().body;
  const PoseGoal file(w.scene().stage().body, PoseA{body.middle});
  double before = 0.0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    CAPTURE(k);
    const double energy = list[k].energy.total_kcal_mol();
    CHECK(energy == doctest::Approx(sum.at(list[k].pose).energy.total_kcal_mol()).epsilon(2e-5).scale(10.0));
    CHECK(energy <= before - HeldPoses::kGain_kcal_mol);
    before = energy;
    CHECK(w.poses().offKnown_A(list[k]) == doctest::Approx(file.rmsd_A(list[k].pose)).epsilon(1e-9));
    REQUIRE(w.d->shows("pose/" + std::to_string(k)));
  }
}

TEST_CASE(
    "a minimum's energy is not above that of the hand's pose and the force there vanishes; the body does not move "
    "meanwhile; the minimum is listed as computed and cannot be taken") {
  PoseWindow w("## One\n" + kDrugScene + "Text.\n");
  w.pressAt(0.5, 0.5, 240);
  const PoseA before = w.scene().log().latest().shownBody();
  REQUIRE(w.d->click("poses/minimise"));
  for (int k = 0; k < 120 && !w.poses().minimum()->done; ++k) w.d->frames(1);
  const HeldPoses::Minimum found = *w.poses().minimum();
  REQUIRE(found.done);
  CHECK(found.steps <= HeldPoses::kMaxSteps);
  bench::DoubleSum sum = w.sum();
  const PairEnergy from = sum.at(found.from.pose), to = sum.at(found.to.pose);
  CHECK(to.energy.total_kcal_mol() < from.energy.total_kcal_mol());
  CHECK(found.to.energy.total_kcal_mol() == doctest::Approx(to.energy.total_kcal_mol()).epsilon(2e-5).scale(10.0));
  CHECK(rmsdBetween_A(*w.scene().stage().body, before, found.from.pose) < 0.1);
  CHECK(seenScene(w.d->app()).marked_place == std::optional(found.to.pose.place));
  REQUIRE(w.d->click("poses/add"));
  w.d->frames(2);
  REQUIRE(w.poses().selected());
  CHECK(w.poses().list()[*w.poses().selected()].minimised);
  CHECK_FALSE(w.poses().canTake());
  CHECK_FALSE(w.d->shows("poses/take"));
}

TEST_CASE(
    "a saved pose is read back with every atom within 0.0006 A of its place, so with an RMSD of less than 0.001 A, and "
    "says its energy") {
  PoseWindow w("## One\n" + kDrugScene + "Text.\n");
  w.pressAt(0.5, 0.5, 240);
  REQUIRE_FALSE(w.poses().list().empty());
  const std::size_t last = w.poses().list().size() - 1;
  REQUIRE(w.d->click("pose/" + std::to_string(last)));
  w.d->frames(3);
  REQUIRE(w.poses().selected() == last);
  const HeldPose pose = w.poses().list()[last];
  CHECK(seenScene(w.d->app()).marked_place == std::optional(pose.pose.place));
  REQUIRE(w.d->click("poses/save"));
  w.d->frames(3);
  REQUIRE(w.d->app().file_dialog.open());
  w.d->app().file_dialog.close();
  const Expected<std::string> text = w.poses().pdb();
  REQUIRE(text);
  const auto file = w.scratch.file("pose.pdb", *text);
  const Expected<Molecule> read = readMolecule(file);
  REQUIRE(read);
  const HeldBody& body = *w.scene().stage().body;
  REQUIRE(read->atoms.size() == body.atoms.size());
  const Molecule& whole = *w.scene().stage().molecule;
  double sum = 0.0;
  for (std::size_t k = 0; k < body.atoms.size(); ++k) {
    const Vec3 place = pose.pose.place.A + pose.pose.orientation * body.spheres[k].centre_A;
    const Vec3 off = read->spheres[k].centre_A - place;
    for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(off[axis]) <= 0.0006);
    sum += glm::dot(off, off);
    CHECK(read->atoms[k].nameText() == whole.atoms[body.atoms[k]].nameText());
    CHECK(read->atoms[k].atomic_number == whole.atoms[body.atoms[k]].atomic_number);
  }
  CHECK(std::sqrt(sum / double(body.atoms.size())) < 0.001);
  const std::size_t says = text->find("ENERGY WITH 1HPV: ");
  REQUIRE(says != std::string::npos);
  CHECK(std::stod(text->substr(says + 18)) == doctest::Approx(pose.energy.total_kcal_mol()).epsilon(0.0006));
  std::size_t line = 0;
  for (std::size_t at = 0; at < text->size(); at = line + 1) {
    line = text->find('\n', at);
    CHECK(line - at <= 80);
  }
}

TEST_CASE("a body that is taken back begins within 1e-9 A of the pose, and the force rises from zero") {
  PoseWindow w("## One\n" + kDrugScene + "Text.\n");
  w.pressAt(0.5, 0.5, 240);
  REQUIRE_FALSE(w.poses().list().empty());
  const PoseA pose = w.poses().list().back().pose;
  w.pressAt(0.5, 0.3, 120);  // elsewhere
  REQUIRE(rmsdBetween_A(*w.scene().stage().body, w.scene().log().latest().shownBody(), pose) > 1.0);
  const auto at = std::find_if(w.poses().list().begin(), w.poses().list().end(),
                               [&](const HeldPose& p) { return p.pose.place == pose.place; });
  REQUIRE(at != w.poses().list().end());
  w.poses().select(std::size_t(at - w.poses().list().begin()));
  w.d->frames(2);
  REQUIRE(w.d->shows("poses/take"));
  w.poses().take();
  w.d->frames(1);
  const std::vector<ServoSample> ticks = w.scene().servo().everyTick();
  const auto first = std::find_if(ticks.begin(), ticks.end(), [](const ServoSample& s) { return s.contact_reset; });
  REQUIRE(first != ticks.end());
  CHECK(first->contact.fault == Fault::None);
  CHECK(rmsdBetween_A(*w.scene().stage().body, first->shownBody(), pose) < 1e-9);
  CHECK(glm::length(first->force.N) < 0.02);
  const double energy = first->molecular_energy->felt_kcal_mol;
  w.d->frames(60);
  const ServoSample& now = w.scene().log().latest();
  REQUIRE(now.molecular_energy);
  CHECK(now.contact.fault == Fault::None);
  CHECK(now.molecular_energy->felt_kcal_mol <= energy + 3e-3);
  CHECK(rmsdBetween_A(*w.scene().stage().body, now.shownBody(), pose) < 1.5);
}

TEST_CASE(
    "while a task of the step is open no pose is shown, computed or taken; a body that was taken back to a pose is put "
    "down elsewhere when a task opens that asks for this pose, and the task is not passed") {
  const std::string one = "## One\n" + kDrugScene + "Text.\n";
  PoseA goal;
  {
    PoseWindow w(one);
    w.pressAt(0.5, 0.62, 240);
    REQUIRE_FALSE(w.poses().list().empty());
    goal = w.poses().list().back().pose;
  }
  char written[256];
  std::snprintf(written, sizeof written, "dock: %.4f, %.4f, %.4f, %.5f, %.5f, %.5f, %.5f\n", goal.place.A.x,
                goal.place.A.y, goal.place.A.z, goal.orientation.w, goal.orientation.x, goal.orientation.y,
                goal.orientation.z);
  PoseWindow w(one + "## Two\n" + kDrugScene + "```touch\n" + written +
               "within: 1 Å\nturned: 40\naway: 2 Å\nfor: 0.3 s\nturn: none\ngoal: 1\nsay: Lead it there.\n```\n");
  w.pressAt(0.5, 0.62, 240);
  REQUIRE(w.d->shows("pose/0"));
  REQUIRE(w.d->click("pose/" + std::to_string(w.poses().list().size() - 1)));
  w.d->frames(2);
  REQUIRE(w.d->click("poses/take"));
  w.d->frames(5);
  REQUIRE(rmsdBetween_A(*w.scene().stage().body, w.scene().log().latest().shownBody(), goal) < 1.0);
  w.d->app().lesson.next();
  w.d->frames(10);
  REQUIRE(w.poses().taskOpen());
  CHECK(rmsdBetween_A(*w.scene().stage().body, w.scene().log().latest().shownBody(), goal) > 2.0);
  for (const char* widget : {"pose/0", "poses/minimise", "poses/save", "poses/take", "poses"})
    CHECK_FALSE(w.d->shows(widget));
  w.poses().select(0);
  CHECK_FALSE(w.poses().canTake());
  w.poses().take();
  w.poses().minimise();
  w.d->frames(60);
  CHECK_FALSE(w.poses().minimum());
  CHECK_FALSE(seenScene(w.d->app()).marked_place);
  CHECK_FALSE(w.d->app().lesson.session()->taskDone(1, 0));
}

}  // namespace moltact
