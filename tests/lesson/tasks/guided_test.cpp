// Tasks with a guide: how it fades, what counts, what a hand that only yields reaches, and what the reader says.
#include "engine/lesson/tasks/guided.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <random>

#include "engine/lesson/check.h"
#include "engine/lesson/guide_file.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scripted_learner/scripted_learner.h"
#include "tests/lesson/task_hand.h"

using namespace moltact;

namespace {

// Five spheres in a row, 2 A apart: a ridge along x.
Molecule ridgeForGuide() {
  MoleculeByHand b;
  b.made.id = "ridge";
  for (int k = 0; k < 5; ++k) b.atom("C", 6, {2.0 * k, 0, 0});
  return b.molecule();
}

Keys guidedKeys(Keys more = {}) {
  Keys keys{{"trace", "atom 0 then atom 1 then atom 2 then atom 3 then atom 4"}, {"guide", "tube"}};
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

// One slide over the ridge from atom 0 to atom 4, 1.7 + 1.4 A above the line of the centres.
void slideOver(Hand& hand) {
  for (int k = 0; k < 4; ++k) hand.slide({k}, Vec3(2.0 * k, 0, 3.1), Vec3(2.0 * (k + 1), 0, 3.1));
  hand.touch({4}, 0.2, 0.5, Vec3(8, 0, 3.1));
}

std::string lessonWithGuide(const std::string& keys) {
  return "---\ntitle: Guided\ngoals:\n  - Follow a way\nmolecules:\n  - ridge\nauthor: A\nlicence: CC-BY-4.0\n---\n\n"
         "## A ridge\n\nFollow the ridge.\n\n```scene\nmolecule: ridge\nprobe: 1.4 Å\n```\n\n"
         "```touch\ntrace: atom 0 then atom 1 then atom 2 then atom 3 then atom 4\n" +
         keys + "say: Slide along the ridge.\npraise: Done.\n```\n";
}

Expected<std::shared_ptr<const Molecule>> ridgeByName(const NamedMolecule&) {
  static const auto ridge = std::make_shared<const Molecule>(ridgeForGuide());
  return ridge;
}

std::string firstFault(const std::string& keys, const std::string& file = "guided.md") {
  const LessonCheck check = checkLesson(file, lessonWithGuide(keys), ridgeByName);
  return check.errors.empty() ? std::string() : check.errors.front().text();
}

std::filesystem::path folderOfGuides() {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "moltact-guide-test";
  std::filesystem::create_directories(folder);
  return folder;
}

void writeRows(const std::filesystem::path& file, const std::string& text) { std::ofstream(file) << text; }

}  // namespace

TEST_CASE(
    "with guide-fade 3 the strength is 1, 2/3, 1/3 and then none; the fourth slide counts, and progress rises by "
    "quarters") {
  const auto guided = task("trace", guidedKeys(), ridgeForGuide());
  Hand hand{*guided};
  CHECK_FALSE(guided->guide());
  hand.away(0.01);
  for (int k = 0; k < 3; ++k) {
    REQUIRE(guided->guide());
    CHECK(guided->guide()->strength == doctest::Approx(1.0 - k / 3.0));
    CHECK(guided->guide()->felt(0.25).stiffness_N_per_A == doctest::Approx((1.0 - k / 3.0) * 0.1 / 0.25));
    CHECK(guided->guide()->felt(0.25).max_N == doctest::Approx((1.0 - k / 3.0) * 0.8));
    slideOver(hand);
    CHECK_FALSE(guided->done());
    CHECK(guided->progress() == doctest::Approx((k + 1) / 4.0));
    hand.away(0.5);
  }
  CHECK_FALSE(guided->guide());
  slideOver(hand);
  CHECK(guided->solved());
  CHECK(figure(*guided, "guided tries") == 3.0);
  CHECK(figure(*guided, "coverage") == doctest::Approx(90.0).epsilon(0.01));
  CHECK(guided->sentence().find("The last try was without it") != std::string::npos);
  guided->reset();
  CHECK_FALSE(guided->done());
  hand.away(0.01);
  CHECK(guided->guide()->strength == 1.0);
}

TEST_CASE(
    "the way of a ridge of five atoms is 8 A long and lies on its surface, 3.1 A from the nearest centre, to 0.2 A") {
  const Molecule ridge = ridgeForGuide();
  const auto guided = task("trace", guidedKeys(), ridge);
  Hand{*guided}.touch({}, 0.01, 0.0, Vec3(4, 0, 20));
  REQUIRE(guided->guide());
  const GuidePath& path = *guided->guide()->path;
  CHECK(path.length_A() > 7.9);
  CHECK(path.length_A() < 11.0);
  for (double at_A = 0.0; at_A <= path.length_A(); at_A += 0.1) {
    double nearest_A = 1e9;
    for (const Sphere& s : ridge.spheres) nearest_A = std::min(nearest_A, glm::distance(s.centre_A, path.at(at_A)));
    CHECK(nearest_A == doctest::Approx(3.1).epsilon(0.07));
  }
}

TEST_CASE(
    "the way lies on the side of the hand: on average 2 A and more above the ridge for a hand above it, below for one "
    "below") {
  for (const double side : {1.0, -1.0}) {
    const auto guided = task("trace", guidedKeys(), ridgeForGuide());
    TouchSample s;
    s.time_s = 0.001;
    s.hip.A = {4, 0, 20 * side};
    guided->feed(s);
    REQUIRE(guided->guide());
    const GuidePath& path = *guided->guide()->path;
    double mean_A = 0.0;
    for (int k = 0; k <= 20; ++k) mean_A += path.at(path.length_A() * k / 20).z * side / 21.0;
    CHECK(mean_A > 2.0);
  }
}

TEST_CASE(
    "the ghost waits at the start, goes 2 A ahead of the hand, and with direction either leads from the end where the "
    "hand begins") {
  const auto guided = task("trace", guidedKeys({{"direction", "either"}}), ridgeForGuide());
  Hand hand{*guided};
  hand.touch({}, 0.01, 0.0, Vec3(4, 0, 20));
  const auto path = guided->guide()->path;
  const auto along = [&] { return path->nearest(guided->guide()->ghost.A).along_A; };
  // At the end that is nearer to the hand.
  CHECK(std::min(along(), path->length_A() - along()) == doctest::Approx(0.0));
  // Along the way itself, which begins on the outer side of the first sphere.
  const auto go = [&](double from_A, double to_A) {
    const int pieces = int(std::abs(to_A - from_A) * 10.0);
    for (int k = 0; k < pieces; ++k) {
      const Vec3 here = path->at(from_A + (to_A - from_A) * k / pieces);
      hand.slide({std::int32_t(std::clamp(std::lround(0.5 * here.x), 0l, 4l))}, here,
                 path->at(from_A + (to_A - from_A) * (k + 1) / pieces));
    }
  };
  go(0.0, 4.0);
  REQUIRE(guided->progress() > 0.0);
  CHECK(along() == doctest::Approx(6.0).epsilon(0.02));
  guided->reset();
  hand.away(0.5);
  go(path->length_A(), path->length_A() - 4.0);
  REQUIRE(guided->progress() > 0.0);
  CHECK(along() == doctest::Approx(path->length_A() - 6.0).epsilon(0.02));
}

TEST_CASE(
    "a sample that still carries the guide's force does not count in the judged try; the share off the way and the "
    "mean force are those of the tries with it") {
  const auto guided = task("trace", guidedKeys({{"guide-fade", "1"}}), ridgeForGuide());
  Hand hand{*guided};
  hand.away(0.01);
  slideOver(hand);
  REQUIRE_FALSE(guided->guide());
  // The same slide, with a guide's force in each sample.
  TouchSample s;
  for (int k = 0; k <= 8000; ++k) {
    s.time_s = hand.time_s += 0.001;
    s.field_N = 0.1;
    s.contact.scp = {Vec3(k * 0.001, 0, 3.1)};
    s.contact.atoms[0] = k / 2000;
    s.contact.feature = Feature::Sphere;
    s.hip.A = s.contact.scp.A - Vec3(0, 0, 0.5);
    guided->feed(s);
  }
  CHECK(guided->progress() == doctest::Approx(0.5));
  hand.away(0.5);
  slideOver(hand);
  CHECK(guided->solved());
}

TEST_CASE("a quarter of a guided slide 2 A off the way, led with 0.2 N, is told as 25 % and 0.2 N on average") {
  const auto guided = task("trace", guidedKeys({{"guide-fade", "1"}, {"within", "50 Å"}}), ridgeForGuide());
  Hand hand{*guided};
  hand.away(0.01);
  const auto path = guided->guide()->path;
  TouchSample s;
  for (int k = 0; k < 4000; ++k) {
    s.time_s = hand.time_s += 0.001;
    s.field_N = 0.2;
    s.contact.atoms[0] = 0;
    s.contact.feature = Feature::Sphere;
    const Vec3 at = path->at(0.5);
    s.contact.scp = {k % 4 == 0 ? at + 2.0 * glm::normalize(at - Vec3(0.5, 0, 0)) : at};
    s.hip = s.contact.scp;
    guided->feed(s);
  }
  CHECK(figure(*guided, "off the guided way") == doctest::Approx(25.0).epsilon(0.01));
  CHECK(figure(*guided, "mean force of the guide") == doctest::Approx(0.2));
}

TEST_CASE(
    "a limp hand never passes: yielding to spring or tube for 60 s from 12 places it finishes no try with the guide, "
    "and the scripted learner passes the same task") {
  const std::uint32_t seed = 29;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> aside(-6.0, 6.0), along(-3.0, 11.0);
  for (const std::string kind : {"spring", "tube"}) {
    CAPTURE(kind);
    LessonReading read = readLessonText("guided.md", lessonWithGuide("guide: " + kind + "\nguide-fade: 1\n"));
    REQUIRE(read.lesson);
    const auto lesson = std::make_shared<const Lesson>(*std::move(read.lesson));
    const auto ridge = *ridgeByName({});
    for (int place = 0; place < 12; ++place) {
      LessonSession session(lesson);
      session.setMolecule(ridge);
      VirtualTouch touch;
      touch.begin(ridge, session.scene());
      // Outside, at a random side.
      Vec3 hand_A(along(random), aside(random), aside(random));
      while (hand_A.y * hand_A.y + hand_A.z * hand_A.z < 16.0) hand_A *= 1.3;
      touch.place({{hand_A}});
      const Workspace workspace = touch.workspace();
      double nearest_A = 1e9;
      for (int k = 0; k < 60'000; ++k) {
        touch.setGuide(session.taskGuide());
        const TouchSample s = touch.tick({{hand_A}});
        session.feed(s);
        // A hand without will and weight, in a grip of 5 N s/m.
        const Vec3 speed_mm_per_s = s.force.N / 5.0 * 1e3;
        hand_A += workspace.rotation * speed_mm_per_s * kTick_s * workspace.A_per_mm;
        if (const auto guide = session.taskGuide())
          nearest_A = std::min(nearest_A, guide->path->nearest(hand_A).distance_A);
      }
      CHECK(nearest_A < 1.5);
      CHECK_FALSE(session.taskDone(0, 0));
      // It came to the way and rests there: at most one place of it is touched.
      CHECK(session.task(0).progress < 0.3);
    }
    ScriptedLearner learner(lesson, ridgeByName, [](const LearnerEvent&) {});
    CHECK(learner.demonstrate());
    CHECK(learner.session().taskSolved(0, 0));
  }
}

TEST_CASE(
    "a recorded hand guides: rows in angstrom give a way of 8 A, thinned to 0.1 A; the part between the first and the "
    "last touch counts") {
  const std::filesystem::path file = folderOfGuides() / "hand.txt";
  std::string rows = "# unit: A\n# columns: x y z\n";
  for (int k = 0; k <= 8000; ++k) rows += std::to_string(k * 0.001) + " 0 3.1\n";
  writeRows(file, rows);
  const auto way = readGuidePath(file, ridgeForGuide());
  REQUIRE(way);
  CHECK(way->length_A() == doctest::Approx(8.0).epsilon(0.02));
  CHECK(way->at(4.0).x == doctest::Approx(4.0).epsilon(0.001));
  std::string touching = "# unit: A\n# columns: x y z fx fy fz\n";
  for (int k = 0; k <= 8000; ++k)
    touching += std::to_string(k * 0.001) + " 0 3.1 0 0 " + (k >= 2000 && k <= 5000 ? "0.5\n" : "0\n");
  writeRows(file, touching);
  const auto part = readGuidePath(file, ridgeForGuide());
  REQUIRE(part);
  CHECK(part->length_A() == doctest::Approx(3.0).epsilon(0.05));
  CHECK(part->at(0.0).x == doctest::Approx(2.0).epsilon(0.05));
}

TEST_CASE(
    "bad input of a guide gets its place and a remedy: keys without a guide, a missing file, millimetres, one place, "
    "an endless way, a file outside, atoms that move") {
  CHECK(firstFault("guide: tube\n").empty());
  CHECK(firstFault("guide: spring\nguide-fade: 9\nguide-ghost: always\nguide-width: 2 Å\n").empty());
  CHECK(firstFault("guide-fade: 2\n").find("'guide-fade' needs a guide") != std::string::npos);
  CHECK(firstFault("guide: rope\n").find("guide") != std::string::npos);
  CHECK(firstFault("guide: tube\nguide-fade: 0\n").find("1") != std::string::npos);
  CHECK(firstFault("guide: tube\nguide-width: 0 Å\n").find("0.1") != std::string::npos);
  const std::string lesson = (folderOfGuides() / "guided.md").string();
  const auto fault = [&](const std::string& rows) {
    writeRows(folderOfGuides() / "way.txt", rows);
    return firstFault("guide: tube\nguide-path: way.txt\n", lesson);
  };
  CHECK(
      firstFault("guide: tube\nguide-path: none.txt\n", lesson).find("there is no file 'none.txt' beside the lesson") !=
      std::string::npos);
  CHECK(firstFault("guide: tube\nguide-path: ../way.txt\n", lesson).find("outside of the lesson's folder") !=
        std::string::npos);
  CHECK(fault("# unit: mm\n0 0 0\n1 0 0\n").find("millimetres") != std::string::npos);
  CHECK(fault("# unit: A\n0 0 0\n0 0 0.01\n").find("stays at one place") != std::string::npos);
  CHECK(fault("# unit: A\n0 0 x\n").find("guides no hand") != std::string::npos);
  std::string endless = "# unit: A\n";
  for (int k = 0; k < 5000; ++k) endless += std::to_string(k) + " 0 0\n";
  CHECK(fault(endless).find("5000 points") != std::string::npos);
  CHECK(fault("# unit: A\n0 0 3.1\n8 0 3.1\n").empty());
}

TEST_CASE("each try with a guide adds a quarter of the task's time: 105 s with 3 tries instead of 60 s for trace") {
  std::vector<Problem> problems;
  const Keys plain{{"trace", "atom 0 then atom 1"}};
  CHECK(taskTime_s(specOf("trace", plain, problems)) == doctest::Approx(60.0));
  CHECK(taskTime_s(specOf("trace", guidedKeys(), problems)) == doctest::Approx(105.0));
  CHECK(problems.empty());
}
