// The program's lesson on zinc fingers: its molecules, its numbers of texts, and the hands that pass its groove.
#include <cmath>
#include <memory>
#include <optional>

#include "engine/core/random.h"
#include "engine/lesson/pose_search.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kAProteinReadsDnaLesson = "a-protein-reads-dna";

}  // namespace

TEST_CASE(
    "a-protein-reads-dna.md has 9 steps, a letter to dock, a way down the groove, a search and trials in the dark") {
  const Lesson lesson = shippedLesson(kAProteinReadsDnaLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 9);
  CHECK(tasksOf(lesson, "dock") == 1);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "find") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
}

TEST_CASE("the DNA without protein is that of the complex, atom by atom") {
  const ShippedScene bare("1a1f-dna"), complex("1a1f");
  const auto same = complex.select("chain B C");
  REQUIRE(same.size() == bare.spheres.size());
  for (std::size_t i = 0; i < same.size(); ++i)
    CHECK(glm::distance(bare.spheres[i].centre_A, complex.spheres[same[i]].centre_A) < 1e-9);
}

TEST_CASE("15 letters have fewer forms than human DNA has places, 18 letters more: six fingers") {
  SAYS(lineSaying(
      kAProteinReadsDnaLesson,
      "A text of 15 letters has about 1 thousand million forms, one of 18 letters about 69 thousand million"));
  SAYS(lineSaying(kAProteinReadsDnaLesson,
                  "With five, a text would be found by chance at about six places, three on each strand"));
  CHECK(std::pow(4.0, 15) == 1073741824.0);
  CHECK(std::pow(4.0, 18) == 68719476736.0);
  CHECK(3.2e9 / std::pow(4.0, 15) == doctest::Approx(3.0).epsilon(0.02));
  CHECK(3.2e9 > std::pow(4.0, 15));
  CHECK(6.4e9 < std::pow(4.0, 18));
}

TEST_CASE("the way down the groove is passed by a hand that slides, by none that jabs the same atoms or one of them") {
  const Lesson lesson = shippedLesson(kAProteinReadsDnaLesson);
  const ShippedScene bare("1a1f-dna");
  const TaskSpec& spec = taskOf(lesson, "take-the-fingers-away", "trace");
  std::vector<std::string> way;
  for (const char* edge : {"2 and name O6", "3 and name N4", "4 and name O6", "5 and name O4", "6 and name O6",
                           "7 and name O6", "8 and name O6"})
    way.push_back(std::string("residue ") + edge);
  // Each is touched from the side on which it lies most open, for the groove winds.
  const auto done = [&](const std::vector<std::string>& atoms, bool jabbing) {
    const std::unique_ptr<Task> task = makeTask(spec, *bare.molecule);
    Hand hand{*task};
    std::optional<Vec3> last_A;
    for (const std::string& name : atoms) {
      Vec3 open(0.0);
      for (const SurfacePlace& p : bare.places(name, 1.4, 600))
        if (openFromOutside(bare.spheres, p, 1.4)) open += p.outward;
      const std::vector<std::int32_t> atom{static_cast<std::int32_t>(bare.select(name).at(0))};
      const Vec3 place_A = restingOn(bare, name, glm::normalize(open), 1.4);
      if (jabbing)
        hand.away(0.5);
      else if (last_A)
        hand.slide(atom, *last_A, place_A);
      hand.touch(atom, 0.3, 0.5, place_A);
      last_A = place_A;
    }
    return task->done();
  };
  CHECK(done(way, false));
  CHECK_FALSE(done(way, true));
  CHECK_FALSE(done({way[2]}, false));
  CHECK_FALSE(done({way.rbegin(), way.rend()}, false));
}

TEST_CASE(
    "guanine fits opposite cytosine 56 and is led out by a free path; in the place of cytosine 56, with the nitrogen "
    "at "
    "the sugar within 0.5 A and the rings within 20 degrees of cytosine's direction, it overlaps in each of 200 000 "
    "poses, and cytosine does not") {
  SAYS(lineSaying(kAProteinReadsDnaLesson, "tried guanine in 200 000 poses in the place of cytosine 56"));
  const ShippedScene bare("1a1f-dna");
  // The scene without a whole letter, and its base as a body.
  struct Gap {
    Gap(const ShippedScene& s, const std::string& letter)
        : body(heldBody(s.molecule->spheres, s.select(letter + " and sidechain"))),
          grid(s.molecule->spheres, s.select(letter)),
          space(grid, *body) {}
    std::shared_ptr<const HeldBody> body;
    SphereGrid grid;
    PoseSpace space;
  };
  const std::string seven = "chain B and residue 7", partner = "chain C and residue 56";
  const Gap guanine(bare, seven), cytosine(bare, partner);
  CHECK(freePath(guanine.space, {guanine.body->middle}, {.max_tests = 50'000}).size() >= 2);
  REQUIRE(cytosine.space.isFree({cytosine.body->middle}));
  const PoseSpace wrong(cytosine.grid, *guanine.body);
  const auto placeOf = [&](const std::string& atom) { return bare.spheres[bare.select(atom).at(0)].centre_A; };
  const Vec3 at_sugar = placeOf(partner + " and name N1"),
             lever = placeOf(seven + " and name N9") - guanine.body->middle.A,
             inward = glm::normalize(cytosine.body->middle.A - at_sugar);
  std::uint64_t random = 1;
  int tried = 0, free = 0;
  while (tried < 200'000) {
    Vec3 off;
    do off = Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 2.0 - 1.0;
    while (glm::length(off) > 1.0);
    const Quat q = randomOrientation(random);
    if (glm::dot(glm::normalize(q * -lever), inward) < std::cos(glm::radians(20.0))) continue;
    ++tried;
    free += wrong.isFree({{at_sugar + 0.5 * off - q * lever}, q});
  }
  CHECK(free == 0);
}
