// Students without touch before the tasks that judge a body in the hand: a looker, who puts the body down where the
// picture shows its place; a guesser, who leads it straight in, turned anyhow; and a jabber, who pushes it here and there
// and lets go. None passes 'dock' in the program's lessons, and only who holds the press passes 'contacts'.
#include "engine/core/even_directions.h"
#include "engine/core/random.h"
#include "engine/lesson/pose_search.h"
#include "tests/lesson/scripted_learner/unfeeling_students.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr int kTries = 100;

// Outside, on a line through the body's place in the file.
Vec3 outside(const HandPlanInput& view, int k) {
  const double far_A = glm::distance(view.spheres.low_A(), view.spheres.high_A()) + 2.0 * view.body->reach_A;
  return view.body->middle.A + evenDirection(k, kTries) * far_A;
}

bool passes(const Found& f, const auto& plan) {
  Alone student(f, 1);
  REQUIRE(student.learner.view().body);
  student.learner.follow(plan(student.learner.view()));
  return student.done();
}

}  // namespace

TEST_CASE(
    "a body that is put down in its place, led straight in from 100 sides in orientations drawn evenly, or jabbed at "
    "it for 0.3 s from 100 sides solves no 'dock' of the lessons, but for 3 of 100 leads where forces draw it in; put "
    "down or jabbed no 'contacts' either, which a press of 2 s solves") {
  std::vector<Found> found = tasksOfKind("dock");
  // An atom has no orientation: who leads it straight in does what the task asks (fair_forces_test.cpp has the others).
  std::erase_if(found, [](const Found& f) { return Alone(f, 1).learner.view().body->atoms.size() == 1; });
  REQUIRE(found.size() >= 3);
  const std::vector<Found> presses = tasksOfKind("contacts");
  REQUIRE_FALSE(presses.empty());
  Passes table;
  for (const Found& f : found) {
    CAPTURE(f.name());
    // The drug's flaps are opened, which is the easiest for all of them.
    const double open = f.step->scene.then.molecule.empty() ? -1.0 : 1.0;
    const auto opened = [&](HandPlan plan) {
      if (open >= 0.0) plan.insert(plan.begin() + 1, HandAct{.share = open});
      return plan;
    };
    const bool looker = passes(f, [&](const HandPlanInput& view) {
      return opened({{.to = PointA{outside(view, 0)}, .placed = true, .wait_s = 0.1},
                     {.turned_to = kNoRotation, .turn_deg_per_s = 360.0},
                     {.to = view.body->middle, .placed = true, .wait_s = 3.0}});
    });
    CHECK_FALSE(looker);
    int guessed = 0, jabbed = 0;
    std::uint64_t random = 20261125;
    for (int k = 0; k < kTries; ++k) {
      // The guesser knows the place, but not how the body lies in it.
      const Quat turned = randomOrientation(random);
      const auto straight = [&](double wait_s) {
        return [&, wait_s](const HandPlanInput& view) {
          return opened({{.to = PointA{outside(view, k)}, .placed = true, .wait_s = 0.05},
                         {.turned_to = turned, .turn_deg_per_s = 360.0},
                         {.to = view.body->middle, .speed_A_per_s = 60.0, .wait_s = wait_s},
                         {.to = PointA{outside(view, k)}, .speed_A_per_s = 120.0}});
        };
      };
      guessed += passes(f, straight(2.0));
      jabbed += passes(f, straight(0.3));
    }
    // Forces turn a small body into its well where the guess was nearly right; contact alone never does.
    CHECK(guessed <= (f.step->scene.touch.forces != "none" ? 3 : 0));
    CHECK(jabbed == 0);
    table.row(f, looker, double(guessed) / kTries, double(jabbed) / kTries, kNone);
  }
  // The same lead along the keyhole, with the key turned as it lies in the lock, docks it.
  const auto key = std::find_if(found.begin(), found.end(),
                                [](const Found& f) { return f.step->scene.molecule.name == "key-and-lock"; });
  REQUIRE(key != found.end());
  CHECK(passes(*key, [](const HandPlanInput& view) -> HandPlan {
    return {{.to = PointA{view.body->middle.A + Vec3(0, 0, 20)}, .placed = true, .wait_s = 0.1},
            {.turned_to = kNoRotation, .turn_deg_per_s = 360.0},
            {.to = view.body->middle, .speed_A_per_s = 60.0, .wait_s = 2.0}};
  }));
  for (const Found& f : presses) {
    CAPTURE(f.name());
    const bool looker = passes(f, [&](const HandPlanInput& view) -> HandPlan {
      return {{.to = PointA{outside(view, 0)}, .placed = true, .wait_s = 0.1},
              {.turned_to = kNoRotation, .turn_deg_per_s = 360.0},
              {.to = view.body->middle, .placed = true, .wait_s = 3.0}};
    });
    CHECK_FALSE(looker);
    int guessed = 0, jabbed = 0;
    std::uint64_t random = 7;
    for (int k = 0; k < kTries; ++k) {
      const Quat turned = randomOrientation(random);
      const auto straight = [&](double wait_s) {
        return [&, wait_s](const HandPlanInput& view) -> HandPlan {
          return {{.to = PointA{outside(view, k)}, .placed = true, .wait_s = 0.05},
                  {.turned_to = turned, .turn_deg_per_s = 360.0},
                  {.to = view.body->middle, .speed_A_per_s = 60.0, .wait_s = wait_s},
                  {.to = PointA{outside(view, k)}, .speed_A_per_s = 120.0}};
        };
      };
      guessed += passes(f, straight(2.0));
      jabbed += passes(f, straight(0.3));
    }
    CHECK(jabbed == 0);
    // Who leads the body there in any orientation and holds it for 2 s does what the task asks for.
    CHECK(guessed > 0);
    table.row(f, looker, double(guessed) / kTries, double(jabbed) / kTries, kNone);
  }
  table.print();
}
