// The program's lesson on the haem's pocket: the iron's place, and what can touch it, agree with the entry.
#include <algorithm>
#include <array>
#include <tuple>

#include "engine/lesson/passable.h"
#include "engine/lesson/tasks/touch_limits.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

/// Directions of 3000 from above in which a probe rests on the iron of a cut-open pocket.
std::size_t fromAbove(const ShippedScene& pocket, double probe_A) {
  const Vec3 up(0, std::sqrt(0.75), 0.5);
  const auto places = pocket.places("element Fe", probe_A);
  return static_cast<std::size_t>(
      std::count_if(places.begin(), places.end(), [&](const SurfacePlace& p) { return glm::dot(p.outward, up) > 0; }));
}

/// Whether a sphere comes from outside to the iron's distal side in the frozen molecule: space is filled on a grid of
/// 0.2 A from the rim of a box of 36 A round the iron inward.
bool probeReachesIron(const ShippedScene& whole, const std::string& chain, double sphere_A) {
  const bool alpha = chain == "A" || chain == "C";
  const auto at = [&](const std::string& text) { return whole.atom("chain " + chain + " and " + text).position.A; };
  const Vec3 iron = at("element Fe");
  const Vec3 distal =
      glm::normalize(iron - at(std::string("resname HIS and name NE2 and residue ") + (alpha ? "87" : "92")));
  constexpr double kCell_A = 0.2, kHalf_A = 18.0;
  constexpr int kCells = int(2 * kHalf_A / kCell_A) + 1;
  const Vec3 corner = iron - Vec3(kHalf_A);
  const auto index = [](int x, int y, int z) {
    return (std::size_t(x) * kCells + std::size_t(y)) * kCells + std::size_t(z);
  };
  enum : char { Free, Shut, Filled };
  std::vector<char> cells(std::size_t(kCells) * kCells * kCells, Free);
  const auto shut = [&](double radius_A, std::vector<char>& out) {
    for (const Sphere& a : whole.molecule->spheres) {
      const double grown = a.radius_A + radius_A;
      int low[3], high[3];
      for (int k = 0; k < 3; ++k) {
        low[k] = std::max(0, int(std::ceil((a.centre_A[k] - grown - corner[k]) / kCell_A)));
        high[k] = std::min(kCells - 1, int(std::floor((a.centre_A[k] + grown - corner[k]) / kCell_A)));
      }
      for (int x = low[0]; x <= high[0]; ++x)
        for (int y = low[1]; y <= high[1]; ++y)
          for (int z = low[2]; z <= high[2]; ++z)
            if (glm::distance(corner + Vec3(x, y, z) * kCell_A, a.centre_A) < grown) out[index(x, y, z)] = Shut;
    }
  };
  shut(sphere_A, cells);
  // Outside is where a sphere of 2.9 A fits at the rim of the box; no cavity of the protein is so large.
  std::vector<char> large(cells.size(), Free);
  shut(2.9, large);
  std::vector<std::array<int, 3>> open;
  const auto fill = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= kCells || y >= kCells || z >= kCells || cells[index(x, y, z)] != Free) return;
    cells[index(x, y, z)] = Filled;
    open.push_back({x, y, z});
  };
  const auto rim = [](int c) { return c == 0 || c == kCells - 1; };
  for (int x = 0; x < kCells; ++x)
    for (int y = 0; y < kCells; ++y)
      for (int z = 0; z < kCells; ++z)
        if ((rim(x) || rim(y) || rim(z)) && large[index(x, y, z)] == Free) fill(x, y, z);
  while (!open.empty()) {
    const auto [x, y, z] = open.back();
    open.pop_back();
    const Vec3 from_iron = corner + Vec3(x, y, z) * kCell_A - iron;
    if (glm::length(from_iron) < 2.44 + sphere_A + kCell_A && glm::dot(from_iron, distal) > 0.5) return true;
    for (const int step : {-1, 1}) {
      fill(x + step, y, z);
      fill(x, y + step, z);
      fill(x, y, z + step);
    }
  }
  return false;
}

}  // namespace

TEST_CASE(
    "the-haem-in-its-pocket.md has 5 steps and one extra step in the whole molecule and in two cut-open pockets, with "
    "a "
    "search in the dark and a largest probe") {
  for (const char* file : {"the-haem-in-its-pocket", "the-haem-in-its-pocket.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 1);
    CHECK(tasksOf(lesson, "fit") == 1);
    CHECK(tasksOf(lesson, "find") == 1);
    CHECK(lesson.molecules.size() == 3);
  }
}

TEST_CASE(
    "in the frozen molecule a sphere of 0.8 A comes from outside to the distal side of every iron, one of 1.3 A to "
    "none") {
  const std::string line =
      lineSaying("the-haem-in-its-pocket", "a ball of 0.8 Å comes from outside to the distal side of every iron");
  CAPTURE(line);
  const ShippedScene whole("2hhb");
  for (const char* chain : {"A", "B", "C", "D"}) {
    CAPTURE(chain);
    CHECK(probeReachesIron(whole, chain, 0.8));
    CHECK_FALSE(probeReachesIron(whole, chain, 1.3));
  }
  // By how much the chains differ.
  CHECK_FALSE(probeReachesIron(whole, "A", 1.0));
  CHECK(probeReachesIron(whole, "D", 1.05));
}

TEST_CASE("the valine over the iron is 4.1 A from it in the beta pocket and 5.2 A in the alpha pocket") {
  CHECK(ShippedScene("haem-alpha").between("element Fe", "residue 62 and name CG2") ==
        doctest::Approx(5.2).epsilon(0.01));
  CHECK(ShippedScene("haem-beta").between("element Fe", "residue 67 and name CG2") ==
        doctest::Approx(4.1).epsilon(0.01));
}

TEST_CASE(
    "the entry has a water 3.4 A from the irons of both alpha chains, and none within 7 A of those of the beta "
    "chains") {
  const auto molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/2hhb.pdb", {.waters = true});
  REQUIRE(molecule);
  for (const auto& [chain, least_A, most_A] : {std::tuple{"A", 3.35, 3.45}, std::tuple{"C", 3.35, 3.46},
                                               std::tuple{"B", 7.0, 20.0}, std::tuple{"D", 7.0, 20.0}}) {
    const auto iron = parseSelection(std::string("chain ") + chain + " and element Fe")->select(*molecule);
    REQUIRE(iron.size() == 1);
    double nearest_A = 1e9;
    for (const auto w : parseSelection("water")->select(*molecule))
      nearest_A =
          std::min(nearest_A, glm::distance(molecule->spheres[iron[0]].centre_A, molecule->spheres[w].centre_A));
    CAPTURE(chain);
    CHECK((nearest_A >= least_A && nearest_A <= most_A));
  }
}

TEST_CASE(
    "from above, the iron of the alpha pocket can be touched with 1.4 A; that of the beta pocket with 0.6 A and 0.9 A, "
    "but not with 1 A") {
  const ShippedScene alpha("haem-alpha"), beta("haem-beta");
  CHECK(fromAbove(alpha, 1.4) >= 10);
  CHECK(alpha.openPlaces("element Fe", 1.4) >= 5);
  CHECK(fromAbove(beta, 0.6) >= 15);
  CHECK(fromAbove(beta, 0.9) >= 1);
  CHECK(fromAbove(beta, 1.0) == 0);
  CHECK(beta.places("element Fe", 1.4).empty());
  // What the task finds: the limit on the side of the valine and the distal histidine.
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const TaskSpec& fit = taskOf(lesson, "a-smaller-visitor", "fit");
  const TouchLimits above(fit, "fit", *beta.molecule);
  const auto iron = beta.select(fit.values["fit"].selection.text());
  const auto limit = largestProbe(fit.values["least"].number, fit.values["most"].number, [&](double probe_A) {
    return !reachablePlaces(beta.spheres, iron, probe_A, true, [&](const SurfacePlace& p) {
              return above.allow(p.scp_A, probe_A);
            }).empty();
  });
  REQUIRE(limit);
  CHECK(*limit == doctest::Approx(1.0).epsilon(0.05));
  // From below nothing of 1.4 A comes to the iron.
  CHECK(alpha.places("element Fe", 1.4).size() == fromAbove(alpha, 1.4));
}

TEST_CASE(
    "the irons of deoxyhaemoglobin lie, toward the proximal histidine, 0.43 A to 0.56 A out of the plane of the ring's "
    "24 atoms, and 0.33 A to 0.45 A out of that of its nitrogens: 0.40 A and 0.36 A in the mean of alpha and of beta") {
  const std::string says = linesSaying(
      "the-haem-in-its-pocket", {"0.43 Å to 0.56 Å from the mean plane of the 24 atoms",
                                 "0.33 Å to 0.45 Å from that of its four nitrogens", "0.36 Å in the beta chains"});
  CAPTURE(says);
  const ShippedScene whole("2hhb");
  const std::string nitrogens = "\"N A\" \"N B\" \"N C\" \"N D\"";
  double alpha_A = 0.0, beta_A = 0.0, least_A = 1e9, most_A = 0.0;
  for (const char* chain : {"A", "B", "C", "D"}) {
    const std::string c = std::string("chain ") + chain + " and ";
    const bool alpha = chain[0] == 'A' || chain[0] == 'C';
    const auto at = [&](const char* name) {
      return whole.atom(c + "resname HEM and name \"" + name + "\"").position.A;
    };
    const Vec3 proximal = whole.atom(c + "resname HIS and name NE2 and residue " + (alpha ? "87" : "92")).position.A;
    const auto ironOut = [&](const std::string& names, std::size_t count) {
      const auto core = whole.select(c + "resname HEM and (name " + names + ")");
      REQUIRE(core.size() == count);
      Vec3 middle(0.0);
      for (const auto i : core) middle += whole.molecule->spheres[i].centre_A / double(count);
      // From the normal of the four nitrogens down to the least squares.
      Vec3 normal = glm::normalize(glm::cross(at("N A") - at("N C"), at("N B") - at("N D")));
      for (int k = 0; k < 500; ++k) {
        Vec3 pull(0.0);
        for (const auto i : core) {
          const Vec3 q = whole.molecule->spheres[i].centre_A - middle;
          pull += q * glm::dot(q, normal);
        }
        normal = glm::normalize(normal - 0.002 * pull);
      }
      if (glm::dot(proximal - middle, normal) < 0) normal = -normal;
      return glm::dot(at("FE") - middle, normal);
    };
    CAPTURE(chain);
    const double from_ring = ironOut(nitrogens +
                                         " CHA CHB CHC CHD C1A C2A C3A C4A C1B C2B C3B C4B C1C C2C C3C C4C C1D C2D C3D "
                                         "C4D",
                                     24);
    CHECK((from_ring > 0.42 && from_ring < 0.57));
    const double from_four = ironOut(nitrogens, 4);
    least_A = std::min(least_A, from_four);
    most_A = std::max(most_A, from_four);
    (alpha ? alpha_A : beta_A) += 0.5 * from_four;
  }
  CHECK(least_A == doctest::Approx(0.33).epsilon(0.015));
  CHECK(most_A == doctest::Approx(0.45).epsilon(0.011));
  CHECK(alpha_A == doctest::Approx(0.40).epsilon(0.012));
  CHECK(beta_A == doctest::Approx(0.36).epsilon(0.014));
}

TEST_CASE(
    "the iron of the beta pocket can be touched from below with 0.6 A as well; the task that asks for it from above "
    "begins on atoms that meet the iron above the ring only") {
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const auto at = lesson.find("a-smaller-visitor");
  REQUIRE(at);
  const TaskSpec& task = lesson.steps[*at].tasks.at(0);
  REQUIRE(task.kind == "cross");
  const std::string line = "the-haem-in-its-pocket.md:" + std::to_string(task.values["cross"].place.line);
  CAPTURE(line);
  const ShippedScene beta("haem-beta");
  const Vec3 up(0, std::sqrt(0.75), 0.5);
  const auto from = beta.select(task.values["cross"].selection.text()),
             iron = beta.select(task.values["to"].selection.text());
  REQUIRE(iron.size() == 1);
  const auto is = [](const std::vector<std::uint32_t>& atoms, std::int32_t a) {
    return std::find(atoms.begin(), atoms.end(), static_cast<std::uint32_t>(a)) != atoms.end();
  };
  // Were it enough to touch the iron, most of the ways to it would be the wrong ones.
  CHECK(beta.places("element Fe", 0.6).size() > 2 * fromAbove(beta, 0.6));
  // The hand touches the iron alone only after it has touched the iron and a residue at once.
  std::vector<std::uint32_t> both = from;
  both.push_back(iron[0]);
  int above = 0;
  for (const SurfacePlace& p : creasePlaces(beta.spheres, both, 0.6, 0.02)) {
    if (!is(iron, p.atoms[0]) && !is(iron, p.atoms[1])) continue;
    CHECK(glm::dot(p.scp_A - beta.spheres[iron[0]].centre_A, up) > 1.0);
    ++above;
  }
  CHECK(above > 10);
  // The faces of the iron above and below the ring are separate: no slide on the iron alone connects them.
  for (const SurfacePlace& p : beta.places("element Fe", 0.6, 20'000)) CHECK(std::abs(glm::dot(p.outward, up)) > 0.2);
}

TEST_CASE(
    "the iron of the alpha pocket is met with 1.4 A between the distal histidine and the valine, from above only") {
  const ShippedScene alpha("haem-alpha");
  CHECK(alpha.places("element Fe", 1.4, 20'000).size() > 50);
  for (const SurfacePlace& p : alpha.places("element Fe", 1.4, 20'000))
    CHECK(glm::dot(p.outward, Vec3(0, std::sqrt(0.75), 0.5)) > 0);
}

TEST_CASE(
    "the haem to be found in the dark does not lie in the middle of the view, and 1 in 20 places on the side that the "
    "student sees counts as found, or fewer") {
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const auto at = lesson.find("find-a-haem-in-the-dark");
  REQUIRE(at);
  const Step& step = lesson.steps[*at];
  const TaskSpec& task = step.tasks.at(0);
  REQUIRE(task.kind == "find");
  CHECK_FALSE(step.scene.highlight.given());
  const ShippedScene whole("2hhb");
  Vec3 middle(0.0), ahead(0.0);
  for (const Sphere& a : whole.molecule->spheres) middle += a.centre_A / double(whole.molecule->atoms.size());
  const auto faced = step.scene.view.facing.select(*whole.molecule);
  for (const auto i : faced) ahead += whole.molecule->spheres[i].centre_A / double(faced.size());
  const Vec3 to_eye = glm::normalize(ahead - middle);
  const auto target = whole.select(task.values["find"].selection.text());
  const double within_A = task.values["within"].number;
  const double probe_A = step.scene.touch.probe_A;
  int seen = 0, right = 0;
  double nearest_A = 1e9;
  for (const SurfacePlace& p : whole.places("all", probe_A, 40)) {
    if (glm::dot(p.outward, to_eye) < 0.3 ||
        !openFromOutside(whole.spheres, {p.scp_A, to_eye, p.atoms, p.feature}, probe_A))
      continue;
    ++seen;
    if (std::none_of(target.begin(), target.end(), [&](std::uint32_t i) {
          return glm::distance(p.scp_A, whole.spheres[i].centre_A) - whole.spheres[i].radius_A - probe_A <= within_A;
        }))
      continue;
    ++right;
    const Vec3 off = p.scp_A - middle;
    nearest_A = std::min(nearest_A, glm::length(off - to_eye * glm::dot(off, to_eye)));
  }
  CAPTURE(seen);
  CAPTURE(right);
  CHECK(right > 5);
  CHECK(right * 20 < seen);
  CHECK(nearest_A > 5.0);
}
