// The program's lesson on HIV protease: how far the drug moves in its tunnel,.
#include <algorithm>

#include "engine/haptics/body/held_body.h"
#include "engine/lesson/passable.h"
#include "engine/lesson/pose_search.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kDrug = "a-drug-in-its-tunnel";

}  // namespace

TEST_CASE(
    "a-drug-in-its-tunnel.md has 9 steps, a drug to dock, a place to find in the dark, a drug to miss in the dark, a "
    "place to hold in "
    "the "
    "tunnel and a key to trace") {
  const Lesson lesson = shippedLesson(kDrug);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 9);
  CHECK(taskOf(lesson, "in-or-out", "same").values["remove"].selection.text() == "ligand");
  CHECK(taskOf(lesson, "in-the-dark", "find").values["by"].text == "hold");
  CHECK(tasksOf(lesson, "hold") == 1);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "dock") == 1);
}

TEST_CASE("the empty tunnel and the drug are atoms of 1hpv in their places, and together all of it") {
  const ShippedScene whole("1hpv"), empty("1hpv-empty"), drug("amprenavir");
  REQUIRE(whole.molecule->atoms.size() == empty.molecule->atoms.size() + drug.molecule->atoms.size());
  for (std::size_t i = 0; i < whole.molecule->atoms.size(); ++i) {
    const std::size_t protein = empty.molecule->atoms.size();
    const Sphere& part = i < protein ? empty.molecule->spheres[i] : drug.molecule->spheres[i - protein];
    CHECK(whole.molecule->spheres[i].centre_A == part.centre_A);
  }
}

TEST_CASE(
    "held as a body 0.5 A smaller, amprenavir touches nothing in its own place; with the flaps shut four searches of "
    "410 000 poses each find no way out, with the flaps turned open by 24 degrees each finds one within 20 000") {
  const std::string says =
      linesSaying(kDrug, {"is felt 0.5 Å smaller", "in three searches of 400 000 poses each", "within 20 000 poses"});
  CAPTURE(says);
  const ShippedScene shut("1hpv"), open("1hpv-open");
  const std::vector<std::uint32_t> held = shut.select("ligand");
  REQUIRE(open.select("ligand") == held);
  const auto body = heldBody(shut.molecule->spheres, held);
  REQUIRE(body);
  const SphereGrid shut_grid(shut.molecule->spheres, held), open_grid(open.molecule->spheres, held);
  const PoseSpace closed(shut_grid, *body), opened(open_grid, *body);
  const PoseA home{body->middle, kNoRotation};
  REQUIRE(closed.isFree(home));
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CAPTURE(seed);
    CHECK(freePath(closed, home, {.seed = seed, .max_tests = 410'000}).empty());
    CHECK(freePath(opened, home, {.seed = seed, .max_tests = 20'000}).size() >= 2);
  }
}

TEST_CASE(
    "in the dark a hand that rests on the rim of the tunnel does not find Asp 25; one that rests on its oxygen does; "
    "the key is not passed by jabs") {
  const Lesson lesson = shippedLesson(kDrug);
  const ShippedScene empty("1hpv-empty"), drug("amprenavir");
  const TaskSpec& dark = taskOf(lesson, "in-the-dark", "find");
  const auto rests = [&](const std::string& atom) {
    const std::unique_ptr<Task> task = makeTask(dark, *empty.molecule);
    Hand hand{*task};
    hand.touch({static_cast<std::int32_t>(empty.select(atom).at(0))}, 3.0, 0.5, restingOn(empty, atom, {0, 0, 1}, 1.4));
    return task->done();
  };
  CHECK(rests("chain A and residue 25 and name OD2"));
  CHECK_FALSE(rests("chain B and residue 29 and name OD2"));
  CHECK_FALSE(rests("chain B and residue 81 and name CB"));
  const TaskSpec& key = taskOf(lesson, "the-key", "trace");
  const std::vector<std::string> along{"name C1", "name O1", "name O3", "name O4", "name C19"};
  CHECK(passes(key, drug, along, {0, 1, 0}, false));
  CHECK_FALSE(passes(key, drug, along, {0, 1, 0}, true));
}

TEST_CASE(
    "the three places of the wall are touched from the tunnel's side: a probe that rests on them takes the drug's "
    "room, "
    "always on Ile 84 and Ile 50, mostly on Val 82") {
  const std::string line = lineSaying(
      kDrug, "of: (residue 82 and name CG2) then (residue 84 and name CG2 CD1) then (residue 50 and name CB");
  CAPTURE(line);
  const ShippedScene with("1hpv"), empty("1hpv-empty");
  const auto drug = with.select("ligand");
  for (const auto& [place, share] :
       {std::pair{"residue 82 and name CG2", 0.5}, std::pair{"residue 84 and name CG2 CD1", 0.99},
        std::pair{"residue 50 and name CB CG2 CD1", 0.99}}) {
    const std::string named = place;
    CAPTURE(named);
    const auto rests = empty.places(named, 1.4);
    REQUIRE(rests.size() > 20);
    const auto inside = std::count_if(rests.begin(), rests.end(), [&](const SurfacePlace& p) {
      return std::any_of(drug.begin(), drug.end(),
                         [&](std::uint32_t i) { return glm::distance(p.scp_A, with.spheres[i].centre_A) < 4.0; });
    });
    CHECK(double(inside) > share * double(rests.size()));
  }
}
