// The task kind fit: which places the search for the largest probe counts as reached. An atom in a cage of six, whose
// windows have a closed form.
#include <cmath>

#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

constexpr double kCage_A = 3.0, kRadius_A = 1.7;

// Atom 0 of 1 A in the middle of six of 1.7 A, 3 A away along the axes.
Molecule cage() {
  MoleculeByHand b;
  b.made.id = "cage";
  b.residue("A", "CAG", 1, ResidueKind::Ligand).atom("C", 6, Vec3(0.0), 1.0);
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0}) {
      Vec3 at(0.0);
      at[axis] = sign * kCage_A;
      b.atom("X", 6, at, kRadius_A);
    }
  return b.molecule();
}

const Keys kKeys{{"fit", "name C"}, {"least", "0.2 Å"}, {"most", "4 Å"}, {"attempts", "1"}};

// The limit as reported after the only guess was wrong.
std::string limitOf(Task& task) {
  constexpr double kProven_A = 0.3;
  task.answer({.number = kProven_A});
  TouchSample there;
  there.probe_A = kProven_A;
  there.contact.atoms[0] = 0;
  there.contact.feature = Feature::Sphere;
  there.contact.scp.A = Vec3(1.3) / std::sqrt(3.0);
  task.feed(there);
  task.answer({"this"});
  return task.sentence();
}

std::string fitReported(const std::vector<std::uint32_t>& untouchable) {
  std::vector<Problem> problems;
  const TaskSpec spec = specOf("fit", kKeys, problems);
  REQUIRE(problems.empty());
  findTaskKind("fit")->check_molecule(spec, cage(), untouchable, problems);
  return problems.empty() ? std::string() : problems.front().message;
}

}  // namespace

TEST_CASE(
    "through the window of three spheres of 1.7 A, 2.449 A from its middle, a probe of 0.749 A gets and no larger") {
  const double window_A = kCage_A * std::sqrt(2.0 / 3.0) - kRadius_A;
  REQUIRE(window_A == doctest::Approx(0.7495).epsilon(1e-3));
  const auto t = task("fit", kKeys, cage());
  CHECK(limitOf(*t) == "That was the last try. The tracker finds 0.7 Å as the limit.");
  CHECK(fitReported({}).empty());
}

TEST_CASE("atoms that the hand goes through keep no probe out: neither in the task nor for the author") {
  const std::vector<std::uint32_t> ways{1, 2, 3, 4, 5, 6};
  const auto t = task("fit", kKeys, cage());
  t->leaveOut(ways);
  CHECK(limitOf(*t) == "That was the last try. The tracker finds 4.0 Å as the limit.");
  CHECK(fitReported(ways) == "every probe up to 4.00 Å gets there");
}
