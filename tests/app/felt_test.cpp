// Everything shown, written, spoken and played of a force comes from the servo loop. The test's method returns a force
// in another direction than from the HIP to the SCP, so that code that recomputes the force would fail.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/gtc/quaternion.hpp>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/render/glyphs.h"
#include "engine/results/attempt_file.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/haptics/fields.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = 3.14159265358979 / 180.0;

double angle(const Vec3& a, const Vec3& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

Vec3 straight(const ServoSample& s) { return s.contact.scp.A - s.hip.A; }

// A lesson under a hand that presses and slides, felt with shaded forces; every tick of it.
struct Felt {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> driver;
  std::vector<ServoSample> ticks;
  ServoSample shaded;  // one whose force leads aside by two degrees or more

  Felt() {
    ScriptedUser::Options options;
    options.application.attempts_folder = scratch.folder / "attempts";
    driver = startWith(MOLTACT_SOURCE_DIR "/tests/app/keyboard_lesson.md", options);
    ScriptedUser& d = *driver;
    useMethod(d.app().scene, "mesh960-smooth");
    d.point("view", 0.45, 0.55);
    frames(20);
    d.app().settings.sound = true;
    d.app().settings.sound_volume = 1.0;
    frames(1);  // at whose end the sound begins
    ticks.clear();
    frames(10);
    d.press();
    collect();
    frames(60);
    for (int k = 0; k < 60; ++k) {
      d.point("view", 0.45 + 0.001 * k, 0.55);
      collect();
      frames(1);
    }
    d.release();
    double most = 0.0;
    for (const ServoSample& s : ticks)
      if (s.contact.touching() && glm::length(s.force.N) > 0.2)
        if (const double aside = angle(s.contact.displacement_A, straight(s)); aside > most) most = aside, shaded = s;
    REQUIRE(most > 2.0 * kDegree);
  }
  void frames(int n) {
    for (int k = 0; k < n; ++k) {
      driver->frames(1);
      collect();
    }
  }
  /// The ticks of the last frame.
  void collect() {
    for (const ServoSample& s : driver->app().scene.servo().everyTick()) ticks.push_back(s);
  }
  /// The one sample, still, for as long as it is looked at.
  void hold() {
    driver->app().scene.playedHand().show(shaded);
    driver->frames(120);  // the state lines wait a moment before they change
  }
};

}  // namespace

TEST_CASE("the arrow, its label and the line of the state show the force of the servo loop, not SCP - HIP") {
  Felt felt;
  ScriptedUser& d = *felt.driver;
  const ServoSample& s = felt.shaded;
  // Seen from the side, where both ways differ most.
  Camera& camera = d.app().scene.camera;
  const Vec3 side = glm::normalize(glm::cross(s.contact.displacement_A, straight(s)));
  camera.orientation = glm::quatLookAt(-side, glm::normalize(s.contact.displacement_A));
  camera.target = s.contact.scp;
  camera.distance_A = 12.0;
  felt.hold();
  const ServoSample& shown = d.app().scene.log().latest();
  REQUIRE(shown.hip.A == s.hip.A);

  ViewScene scene = seenScene(d.app());
  CHECK(scene.force_N == glm::length(s.force.N));
  scene.shown = {ViewPart::Force};
  Glyphs glyphs;
  addGlyphs(scene, nullptr, glyphs);
  REQUIRE(glyphs.cones.size() >= 1);
  const Vec3 arrow = Vec3(glyphs.cones[0].b) - Vec3(glyphs.cones[0].a);
  const auto seen = [&](const Vec3& way) {
    return scene.camera.toView({scene.camera.target.A + way}) - scene.camera.toView(scene.camera.target);
  };
  CHECK(angle(arrow, seen(s.contact.displacement_A)) < 1e-3);
  CHECK(angle(arrow, seen(straight(s))) > 0.03);

  const WidgetRecord* label = widgets().find("view/force");
  REQUIRE(label);
  const Rectangle& view = d.app().layout().view;
  const glm::vec2 size = view.size();
  const auto place = [&](const Vec3& way) {
    const double arrow_A = camera.pixel_A(camera.distance_A, int(size.y)) * (70.0 * glm::length(s.force.N) + 26.0);
    const Vec3 at = camera.project({s.contact.scp.A + glm::normalize(way) * arrow_A}, int(size.x), int(size.y));
    return glm::vec2(view.low.x + float(at.x), view.low.y + float(at.y));
  };
  CHECK(glm::distance(label->centre(), place(s.contact.displacement_A)) < 0.6f);
  CHECK(glm::distance(label->centre(), place(straight(s))) > 1.0f);
  char newtons[24];
  std::snprintf(newtons, sizeof newtons, "%.1f\u00a0N", glm::length(s.force.N));
  CHECK(label->text == newtons);
  // The state line changes its force only by 0.1 N or more.
  const auto shown_N = [](const std::string& text) { return std::stod(text.substr(text.rfind(", ") + 2)); };
  CAPTURE(d.text("view/state"));
  CHECK(std::abs(shown_N(d.text("view/state")) - glm::length(s.force.N)) < 0.1 + 0.05);
  CHECK(std::abs(shown_N(d.app().extensions().state_text.line(d.app().scene)) - glm::length(s.force.N)) < 0.1 + 0.05);
}

TEST_CASE("in the dark the words and the meter show the force of the servo loop, not SCP - HIP") {
  Felt felt;
  ScriptedUser& d = *felt.driver;
  const ServoSample& s = felt.shaded;
  LessonSession& session = *d.app().lesson.session();
  for (std::size_t k = 0; k < session.lesson().steps.size() && session.step().title != "Find"; ++k)
    d.app().lesson.next();
  REQUIRE(session.step().title == "Find");
  d.frames(10);
  REQUIRE(d.app().extensions().task_stager.dark());
  felt.hold();
  // The first direction is reported as straight toward the viewer (below 15 degrees), the second as sideways.
  const Vec3 right = glm::normalize(s.contact.displacement_A), wrong = glm::normalize(straight(s)),
             axis = glm::normalize(glm::cross(wrong, right));
  const double back = 15.0 * kDegree - 0.5 * angle(right, wrong);
  const Vec3 toward = glm::angleAxis(back, axis) * right;
  const Vec3 up = glm::normalize(glm::cross(toward, axis));
  d.app().scene.camera.orientation = glm::quatLookAt(-toward, up);
  d.frames(2);
  CHECK(d.text("view/push") == "pushed toward you");
  CHECK(pushText(glm::conjugate(d.app().scene.camera.orientation) * wrong) != "pushed toward you");
  char newtons[24];
  std::snprintf(newtons, sizeof newtons, "%.1f\u00a0N", glm::length(s.force.N));
  CHECK(d.text("view/force meter") == newtons);
}

TEST_CASE("sound, the attempt's samples and `moltact replay` have the force that the servo gave in every tick") {
  Felt felt;
  ScriptedUser& d = *felt.driver;
  // As loud and as high as the force was, sample by sample.
  const std::vector<float>& heard = d.app().extensions().touch_sound.heard();
  const std::size_t a_tick = kSamples_per_s / 1000;
  CAPTURE(heard.size() / a_tick);
  CAPTURE(felt.ticks.size());
  REQUIRE(heard.size() >= felt.ticks.size() * a_tick);
  TouchSynth synth;
  std::vector<float> wanted(felt.ticks.size() * a_tick);
  for (std::size_t k = 0; k < felt.ticks.size(); ++k) {
    const ServoSample& s = felt.ticks[k];
    const bool slides = k > 0 && !s.contact_reset && s.contact.touching() && felt.ticks[k - 1].contact.touching();
    const double slide_A = slides ? glm::distance(s.contact.scp.A, felt.ticks[k - 1].contact.scp.A) : 0.0;
    synth.take({s.contact.feature, s.contact.atoms, glm::length(s.force.N), 1000.0 * slide_A});
    synth.render(std::span(wanted).subspan(k * a_tick, a_tick));
  }
  double off = 0.0, loudest = 0.0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    off = std::max(off, std::abs(double(heard[k] - wanted[k])));
    loudest = std::max(loudest, std::abs(double(wanted[k])));
  }
  CHECK(loudest > 0.05);
  CHECK(off < 1e-6);

  d.app().lesson.next();
  d.frames(10);
  REQUIRE(d.app().extensions().recorder.flush());
  const auto files = attemptFiles(felt.scratch.folder / "attempts");
  REQUIRE(files->size() == 1);
  const Expected<Attempt> attempt = readAttempt(files->front());
  REQUIRE(bool(attempt));
  std::size_t compared = 0, aside = 0;
  for (const AttemptEvent& e : attempt->events) {
    const auto* chunk = std::get_if<HipChunk>(&e.what);
    if (!chunk) continue;
    for (const HipSample& kept : chunk->samples) {
      if (kept.feature == Feature::Free) continue;
      const auto given = std::min_element(felt.ticks.begin(), felt.ticks.end(), [&](const auto& a, const auto& b) {
        return glm::distance(a.hip.A, kept.hip.A) + glm::distance(a.force.N, kept.force.N) <
               glm::distance(b.hip.A, kept.hip.A) + glm::distance(b.force.N, kept.force.N);
      });
      if (glm::distance(given->hip.A, kept.hip.A) > 1e-3)
        continue;  // of a tick before or after those that were counted
      ++compared;
      CHECK(glm::distance(given->force.N, kept.force.N) < 2e-3);
      CHECK(glm::distance(given->contact.displacement_A, kept.displacement_A) < 4e-3);
      aside += angle(kept.displacement_A, kept.scp.A - kept.hip.A) > 1.0 * kDegree;
    }
  }
  CHECK(compared > 20);
  CHECK(aside > 5);

  // The same path through the command.
  std::ostringstream path;
  path.precision(17);
  path << "x,y,z\n";
  for (const ServoSample& s : felt.ticks) path << s.hip.A.x << ',' << s.hip.A.y << ',' << s.hip.A.z << '\n';
  const fs::path hips = felt.scratch.file("hip.csv", path.str()), out = felt.scratch.folder / "out.csv";
  std::ostringstream command;
  command.precision(17);
  command << "'" << MOLTACT_BINARY << "' replay argon-pair --method mesh960-smooth --probe "
          << felt.ticks.front().probe_A << " --stiffness 1 --path '" << hips.string() << "' --out '" << out.string()
          << "'";
  REQUIRE(std::system(command.str().c_str()) == 0);
  std::ifstream rows(out);
  std::string line;
  std::getline(rows, line);
  std::size_t touched = 0, wrong = 0;
  for (const ServoSample& s : felt.ticks) {
    REQUIRE(bool(std::getline(rows, line)));
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    double tick, contact;
    Vec3 hip, scp, force;
    fields >> tick >> hip.x >> hip.y >> hip.z >> contact >> scp.x >> scp.y >> scp.z >> force.x >> force.y >> force.z;
    touched += s.contact.touching();
    wrong += glm::distance(force, s.contact.displacement_A) > 1e-9;
  }
  CHECK(touched > 100);
  CHECK(wrong == 0);
}

TEST_CASE(
    "a field is felt without touching: arrow, its label, the line of the state and the status bar "
    "show 0.4 N toward the atom, and nothing says that anything is touched; a press rests in its "
    "well within 0.05 A") {
  Scratch scratch;
  ScriptedUser::Options options;
  options.application.attempts_folder = scratch.folder / "attempts";
  const auto driver = startWith(MOLTACT_SOURCE_DIR "/tests/app/keyboard_lesson.md", options);
  ScriptedUser& d = *driver;
  d.point("view", 0.5, 0.5);
  d.frames(40);
  // A harmonic well whose middle lies 0.5 A to the right of the hovering hand, 1.5 N A deep: 0.8 N/A pull with 0.4 N.
  const Vec3 hand = d.app().scene.log().latest().hip.A;
  const Vec3 middle = hand + 0.5 * d.app().scene.camera.right();
  auto well = std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{0.8},
                                               std::vector<test::Harmonic::Atom>{{0, middle}});
  well->offset_N_A = -1.5;
  d.app().scene.servo().setInteraction(std::move(well));
  d.frames(120);
  const ServoSample& now = d.app().scene.log().latest();
  REQUIRE_FALSE(now.contact.touching());
  CHECK(now.felt());
  CHECK(glm::length(now.force.N) == doctest::Approx(0.4).epsilon(0.02));
  ViewScene scene = seenScene(d.app());
  CHECK(angle(scene.field_direction, middle - hand) < 1e-3);
  scene.shown = {ViewPart::Force};
  Glyphs glyphs;
  addGlyphs(scene, nullptr, glyphs);
  REQUIRE(glyphs.cones.size() >= 1);
  CHECK((glyphs.cones[0].b - glyphs.cones[0].a).x > 0.0f);
  CHECK(d.text("view/force") == "0.4\u00a0N");
  CHECK(d.text("view/state") == "not touching, a force of 0.4\u00a0N");
  CHECK(d.text("status/contact") == "a force is felt");
  CHECK(glm::distance(pushInView(d.app().scene), Vec3(1, 0, 0)) < 1e-3);
  d.press();
  d.frames(150);
  CHECK(glm::distance(now.hip.A, middle) < 0.05);
  CHECK_FALSE(now.contact.touching());
}

}  // namespace moltact
