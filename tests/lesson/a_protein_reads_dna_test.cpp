// The program's lesson on zinc fingers: its molecules, its numbers of texts, and the hands that pass its groove.
#include <cmath>
#include <memory>
#include <optional>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kLesson = "a-protein-reads-dna";

}  // namespace

TEST_CASE("a-protein-reads-dna.md has 8 steps, a way down the groove, a search and trials in the dark") {
  const Lesson lesson = shippedLesson(kLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
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
  CAPTURE(lineSaying(
      kLesson, "A text of 15 letters has about 1 thousand million forms, one of 18 letters about 69 thousand million"));
  CAPTURE(lineSaying(kLesson, "With five, a text would be found by chance at about three places"));
  CHECK(std::pow(4.0, 15) == 1073741824.0);
  CHECK(std::pow(4.0, 18) == 68719476736.0);
  CHECK(3.2e9 / std::pow(4.0, 15) == doctest::Approx(3.0).epsilon(0.02));
  CHECK(3.2e9 > std::pow(4.0, 15));
  CHECK(6.4e9 < std::pow(4.0, 18));
}

TEST_CASE("the way down the groove is passed by a hand that slides, by none that jabs the same atoms or one of them") {
  const Lesson lesson = shippedLesson(kLesson);
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
