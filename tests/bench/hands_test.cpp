// Recorded hands: their files, what a hand could perceive along their paths, and the program's own recordings.
#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "engine/bench/felt.h"
#include "engine/bench/hand_replay.h"
#include "engine/bench/scenes.h"
#include "engine/bench/touch_thresholds.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/servo/hand_path.h"

using namespace moltact;
using namespace moltact::bench;
namespace fs = std::filesystem;

namespace {

struct TextFile {
  fs::path path = fs::temp_directory_path() / ("moltact-hands-" + std::to_string(::getpid()) + ".txt");
  explicit TextFile(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }
  ~TextFile() { fs::remove(path); }
};

HandPath read(const std::string& text) {
  const auto path = readHandPath(TextFile(text).path);
  REQUIRE_MESSAGE(path, (path ? "" : path.problem().text()));
  return *path;
}

Problem refused(const std::string& text) {
  const auto path = readHandPath(TextFile(text).path);
  REQUIRE_FALSE(path);
  return path.problem();
}

std::shared_ptr<const SphereGrid> oneSphere() {
  return std::make_shared<const SphereGrid>(scenes::oneSphere().spheres);
}

// exact with the force turned by an angle and scaled.
struct Wrong {
  static inline double turn_deg = 0, scale = 1;
  class T final : public Tracker {
   public:
    T(std::shared_ptr<const SphereGrid> scene, double probe_A) : exact_(std::move(scene), probe_A) {}
    Contact step(PointA hip) noexcept override {
      Contact c = exact_.step(hip);
      const Vec3 pull = c.scp.A - hip.A, across = glm::cross(pull, Vec3(0.3, 0.5, 0.8));
      if (!c.touching() || glm::length(across) == 0) return c;
      const double a = turn_deg * 3.141592653589793 / 180;
      c.displacement_A = glm::length(pull) * scale *
                         glm::normalize(glm::normalize(pull) * std::cos(a) + glm::normalize(across) * std::sin(a));
      c.scp.A = hip.A + pull * scale;
      return c;
    }
    void reset() noexcept override { exact_.reset(); }
    void setProbe(double probe_A) noexcept override { exact_.setProbe(probe_A); }
    double probe_A() const noexcept override { return exact_.probe_A(); }
    MemoryUsage memoryUsage() const noexcept override { return {}; }

   private:
    ExactTracker exact_;
  };
  static std::unique_ptr<Tracker> make(std::shared_ptr<const SphereGrid> scene, double probe_A) {
    return std::make_unique<T>(std::move(scene), probe_A);
  }
};

FeltErrors handsFeltWith(double turn_deg, double scale) {
  static constexpr Method kWrong{"wrong", "", &Wrong::make};
  Wrong::turn_deg = turn_deg, Wrong::scale = scale;
  StrokePlan plan;
  plan.strokes = 4, plan.ticks = 500;
  const auto scene = std::make_shared<const SphereGrid>(scenes::cluster(20, 3).spheres);
  return feltOn("here", kWrong, scene, 1.4, contactStrokes(scene, 1.4, plan));
}

std::string contents(const fs::path& file) {
  std::stringstream out;
  out << std::ifstream(file).rdbuf();
  return out.str();
}

}  // namespace

TEST_CASE(
    "three numbers in a row are x y z in mm at 1 kHz; blanks, tabs, commas and semicolons part them; "
    "comments and a head of words are passed over") {
  const HandPath path = read("some head\nx, y; z\n# a comment\n1 2 3\n\n4,5\t6 \n% 9 9 9\n+7;8;9e0\n");
  CHECK(path.places == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});
  CHECK_FALSE(path.on_molecule);
  CHECK(path.passed_over == 2);
  CHECK(path.touched.empty());
}

TEST_CASE(
    "seven numbers are t x y z fx fy fz: rows 4 ms apart give a tick each ms on the straight way between "
    "them, touched where there is a force") {
  const HandPath path = read("0.000 0 0 0 0 0 0\n0.004 8 0 0 0 0 1\n0.008 8 4 0 0 0 0\n");
  REQUIRE(path.places.size() == 9);
  CHECK(path.places[1].x == doctest::Approx(2));
  CHECK(path.places[4].x == doctest::Approx(8));
  CHECK(path.places[6].y == doctest::Approx(2));
  CHECK_FALSE(path.touched[1]);
  CHECK(path.touched[4]);
}

TEST_CASE("labels name columns, units and times: 0.1 m a column further is 100 mm, 2 ms is 2 ticks") {
  const HandPath path = read(
      "# columns: index t z y x\n# unit: m\n# time_unit: ms\n# molecule: 1ubq\n# probe_A: 0.7\n1 10 0.1 0.2 "
      "0.3\n2 12 0.1 0.2 0.5\n");
  REQUIRE(path.places.size() == 3);
  CHECK(path.places[0].x == doctest::Approx(300));
  CHECK(path.places[1].x == doctest::Approx(400));
  CHECK(path.places[2].z == doctest::Approx(100));
  CHECK(path.label("molecule") == "1ubq");
  CHECK(path.probe_A == 0.7);
}

TEST_CASE(
    "a broken row is reported with its line: too few numbers, a word, a time that does not continue, "
    "six numbers of unknown meaning, an unknown unit, no row") {
  CHECK(refused("1 2 3\n4 5\n").line == 2);
  CHECK(refused("1 2 3\n4 five 6\n").message.find("\"five\"") != std::string::npos);
  CHECK(refused("1 2 3\n4 nan 6\n").line == 2);
  CHECK(refused("0 1 2 3\n0.1 1 2 3\n0.1 1 2 3\n").line == 3);
  CHECK(refused("1 2 3 4 5 6\n").remedy.find("columns") != std::string::npos);
  CHECK(refused("# columns: t x y\n1 2 3\n").line == 1);
  CHECK(refused("# unit: inch\n1 2 3\n").message.find("inch") != std::string::npos);
  CHECK(refused("# tick_s: 0\n1 2 3\n").message.find("tick_s") != std::string::npos);
  CHECK(refused("0 1 2 3\n25000 1 2 3\n").message.find("25 000 s") != std::string::npos);
  CHECK(refused("0 1 2 3\n1e300 1 2 3\n").message.find("25 000 s") != std::string::npos);
  CHECK(refused("-1e308 1 2 3\n1e308 1 2 3\n").message.find("25 000 s") != std::string::npos);
  CHECK(refused("only words\n").message.find("no row") != std::string::npos);
  CHECK_FALSE(readHandPath("/nowhere/at-all.txt"));
}

TEST_CASE(
    "what would take much memory or lead nowhere is refused with its line: places beyond 1e9 mm, a line of 65 KiB, "
    "1001 "
    "labels; 1e9 mm and 1000 labels are read") {
  CHECK(read("1 2 3\n1 -1e9 3\n").places.size() == 2);
  CHECK(refused("1 2 3\n1 -1.1e9 3\n").line == 2);
  CHECK(refused("# unit: m\n1 2 3\n1 1.7e308 3\n").line == 3);
  CHECK(refused("1 2 3\n1 2 3" + std::string(65 << 10, ' ') + "4\n").line == 2);
  std::string labels;
  for (int k = 0; k < 1000; ++k) labels += "# k" + std::to_string(k) + ": v\n";
  CHECK(read(labels + "1 2 3\n").labels.size() == 1000);
  CHECK(refused(labels + "1 2 3\n# one: more\n").line == 1002);
}

TEST_CASE("a line of separators alone is passed over like a blank one, before the rows and among them") {
  CHECK(read(",\n1 2 3\n;, \t;\n4 5 6\n,").places == std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}});
  CHECK(refused(",\n").message.find("no row") != std::string::npos);
}

TEST_CASE("a way of 10 rows a second is written a row a tick, and read back it lasts as long") {
  const HandPath path = read("# tick_s: 0.1\n# time_unit: s\n1 2 3\n2 2 3\n");
  REQUIRE(path.places.size() == 101);
  CHECK(read(textOf(path)).places.size() == 101);
}

TEST_CASE(
    "of a recording whose hand is first no place, then at 1 A, then NaN, 1e300 A and at 2 A, the way is 1, 1, 1, 2 A, "
    "and reads back") {
  ServoRecording recording;
  for (const double x : {std::nan(""), 1.0, std::nan(""), 1e300, 2.0}) {
    RecordedTick tick;
    tick.settings.workspace.A_per_mm = 1.0;
    tick.settings.probe_A = 1e5;
    tick.pose.position.mm = {x, 0, 0};
    recording.ticks.push_back(tick);
  }
  const HandPath path = handPathOf(recording, "odd", nullptr);
  REQUIRE(path.places.size() == 4);
  CHECK(path.touched.size() == 4);
  for (const std::size_t k : {0u, 1u, 2u}) CHECK(path.places[k].x == doctest::Approx(1.0));
  CHECK(path.places[3].x == doctest::Approx(2.0));
  CHECK(path.probe_A == 20.0);
  CHECK(read(textOf(path)).places == path.places);
}

TEST_CASE("a way that was written is read back the same to 0.001 A, with its labels") {
  HandPath path;
  path.labels = {{"molecule", "1ubq"}, {"hand", "a test"}};
  path.probe_A = 1.2;
  for (int k = 0; k < 50; ++k) path.places.push_back({0.1234567 * k, -40.5, 1e3 + 0.01 * k});
  const HandPath back = read(textOf(path));
  CHECK(back.on_molecule);
  CHECK(back.labels.at("hand") == "a test");
  CHECK(back.probe_A == 1.2);
  REQUIRE(back.places.size() == 50);
  for (int k = 0; k < 50; ++k) CHECK(glm::distance(back.places[std::size_t(k)], path.places[std::size_t(k)]) < 0.001);
}

TEST_CASE(
    "a device's way laid on one carbon at 0.25 A/mm has the middle of what it touched on the pole, 3.1 A "
    "from the centre, and keeps its shape") {
  HandPath path;
  path.on_molecule = false;
  path.places = {{100, 0, 0}, {104, 0, 0}, {104, 8, 0}, {300, 0, 0}};
  path.touched = {true, true, true, false};
  const HandPath laid = mappedTo(path, *oneSphere(), 0.25);
  CHECK(laid.on_molecule);
  CHECK(glm::distance(laid.places[1], laid.places[2]) == doctest::Approx(2));
  const Vec3 middle = 0.5 * (laid.places[0] + laid.places[2]);
  CHECK(glm::distance(middle, Vec3(0, 0, 3.1)) < 1e-5);
  CHECK(mappedTo(laid, *oneSphere(), 0.25).places == laid.places);
}

TEST_CASE(
    "the way of a recording is the place that its workspace gives in each tick, and touched where the "
    "tracker touches") {
  ServoRecording recording;
  recording.labels = {{"molecule", "argon"}};
  for (int k = 0; k < 200; ++k) {
    RecordedTick tick;
    tick.settings.workspace.centre_A = {0, 0, 2};
    tick.settings.probe_A = 1.4;
    tick.pose.position = {{0.5, 0, 20 - 0.1 * k}};
    tick.pose.connected = true;
    recording.ticks.push_back(tick);
  }
  ExactTracker exact(oneSphere(), 1.4);
  const HandPath path = handPathOf(recording, "hand", &exact);
  REQUIRE(path.places.size() == 200);
  for (std::size_t k = 0; k < 200; ++k) {
    CHECK(glm::distance(path.places[k], Vec3(0.125, 0, 2 + 0.25 * (20 - 0.1 * double(k)))) < 1e-9);
    CHECK(path.touched[k] == (glm::length(path.places[k]) < 3.1));
  }
}

TEST_CASE(
    "a force turned by 22 degrees is noticed beside the picture and not in the dark; one 8 % too "
    "large passes 7 % and not 10 %; neither steps") {
  const FeltErrors turned = handsFeltWith(22, 1);
  CHECK(turned.ticks == 2000);
  CHECK(turned.direction_deg.p50 == doctest::Approx(22).epsilon(1e-6));
  CHECK(turned.direction_seen == 1);
  CHECK(turned.direction_blind == 0);
  CHECK(turned.size == 0);
  const FeltErrors larger = handsFeltWith(0, 1.08);
  CHECK(larger.direction_deg.max < 1e-4);
  CHECK(larger.size > 0.9);  // less where the force is under 0.3 N or cut at 3.3 N
  CHECK(larger.size_wide == 0);
  CHECK(larger.steps == 0);
  const FeltErrors right = handsFeltWith(0, 1);
  CHECK(right.size + right.off + right.lost + right.steps == 0);
}

TEST_CASE("two parts of 2000 and 1000 ticks count by their ticks") {
  FeltErrors a, b;
  a.ticks = 2000, a.size = 0.3, b.ticks = 1000, b.size = 0;
  CHECK(together("both", {a, b}).size == doctest::Approx(0.2));
  CHECK(together("both", {a, b}).ticks == 3000);
}

TEST_CASE(
    "the program comes with five strokes of a driven mouse and five of the simulated stylus, each 2 to 5 s, "
    "all different, and none is said to be a person's") {
  int mouse = 0, stylus = 0;
  std::vector<std::string> strokes;
  for (const auto& entry : fs::directory_iterator(MOLTACT_SOURCE_DIR "/assets/hands")) {
    if (entry.path().extension() != ".hand") continue;
    const auto path = readHandPath(entry.path());
    REQUIRE(path);
    CAPTURE(path->name);
    mouse += path->label("device") == "Mouse";
    stylus += path->label("device") == "Simulated stylus";
    CHECK(path->label("hand").find("script") != std::string::npos);
    CHECK(std::find(strokes.begin(), strokes.end(), path->name + path->label("stroke")) == strokes.end());
    strokes.push_back(path->name + path->label("stroke"));
    CHECK(path->on_molecule);
    CHECK(path->places.size() >= 2000);
    CHECK(path->places.size() <= 5000);
    // At 1 kHz no hand moves an angstrom in a tick.
    for (std::size_t k = 1; k < path->places.size(); ++k)
      CHECK(glm::distance(path->places[k], path->places[k - 1]) < 1);
  }
  CHECK(mouse == 5);
  CHECK(stylus == 5);
}

TEST_CASE(
    "the page on hands names the thresholds that are used: 18.4, 25.6 and 31.9 degrees, 7 and 10 %, 0.05 A "
    "and 0.05 N") {
  const std::string page = contents(MOLTACT_SOURCE_DIR "/docs/hands.md");
  for (const double value : {kDirectionSeen_deg, kDirectionBlind_deg, kDirectionMisled_deg, 100 * kForceWeber,
                             100 * kForceWeberWide, kPlaceFelt_A, kStepFelt_N}) {
    char text[20];
    std::snprintf(text, sizeof text, "%g", value);
    CHECK_MESSAGE(page.find(text) != std::string::npos, text);
  }
  // A press of the usual depth, 0.3 N/mm at 0.25 A/mm: the step is 7 % of it, the place 8 %.
  const double press_N = kUsualDepth_A * 0.3 / 0.25;
  CHECK(kStepFelt_N == doctest::Approx(kForceWeber * press_N).epsilon(0.01));
  CHECK(kPlaceFelt_A / kUsualDepth_A == doctest::Approx(0.083).epsilon(0.01));
}
