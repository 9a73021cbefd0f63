// An attempt made in one window is played in another. Oracle: the attempt's own trace.
#include <algorithm>

#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "app/ui/panels/view_overlays.h"
#include "tests/app/small_window.h"
#include "tests/haptics/fields.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

const std::string kPlaybackLesson = MOLTACT_SOURCE_DIR "/lessons/first-touch.md";

// Touches the first lesson's atom, continues a step; gives the file.
fs::path recorded(const fs::path& folder) {
  const auto driver = startWith(kPlaybackLesson, smallWindow(folder));
  driver->point("view", 0.5, 0.5);
  driver->press();
  driver->frames(60);
  driver->release();
  driver->frames(30);
  driver->app().lesson.next();
  driver->frames(30);
  REQUIRE(driver->app().extensions().recorder.flush());
  return driver->app().extensions().recorder.file();
}

TEST_CASE("an attempt opened as a file moves the probe as the hand did, says what was touched, and feeds no lesson") {
  const ScratchFolder scratch;
  const fs::path file = recorded(scratch.path);
  const std::string bytes = bytesOf(file);
  const Timeline line(*readAttempt(file));
  const auto driver = startWith(file.string(), smallWindow(scratch.path / "other"));
  Application& app = driver->app();
  Playback& playback = app.extensions().playback;
  REQUIRE(playback.on());
  CHECK(app.scene.playedHand().on());
  CHECK(app.scene.molecule().file.filename().string() == line.stage(0.1)->file);
  playback.setRunning(false);
  std::size_t touched = 0;
  for (int k = 1; k < 40; ++k) {
    playback.seek(line.length_s() * k / 40.0);
    driver->frames(2);
    const auto hand = line.hand(playback.at_s());
    REQUIRE(hand.has_value());
    if (app.scene.molecule().file.filename() != line.stage(playback.at_s())->file) continue;
    CHECK(glm::distance(app.scene.log().latest().hip.A, hand->hip.A) < 1e-9);
    CHECK(app.scene.log().touching() == (hand->feature != Feature::Free));
    if (hand->feature == Feature::Free) continue;
    ++touched;
    CHECK(contains(driver->text("status/contact"), "touching"));
  }
  CHECK(touched >= 3);
  CHECK(contains(driver->text("playback/told"), "First touch"));

  // Plays by itself, twice as fast, to its end.
  playback.seek(0.0);
  playback.skips_rests = false;
  playback.speed = 2.0;
  CHECK(driver->click("playback/play"));
  const double before_s = playback.at_s();
  driver->frames(30);
  CHECK(playback.at_s() - before_s == doctest::Approx(1.0).epsilon(0.05));
  driver->frames(int(line.length_s() * 30.0) + 60);
  CHECK_FALSE(playback.running());
  CHECK(driver->text("playback/play") == "Play");
  CHECK(driver->tap("Left"));
  CHECK(playback.at_s() == doctest::Approx(std::max(0.0, line.length_s() - 5.0)).epsilon(0.2));

  CHECK(driver->click("playback/close"));
  driver->frames(5);
  CHECK_FALSE(app.scene.playedHand().on());
  CHECK_FALSE(driver->shows("playback/bar"));
  CHECK(bytesOf(file) == bytes);
  CHECK_FALSE(fs::exists(scratch.path / "other"));
}

TEST_CASE(
    "a playback sounds while its hand touched, with a scrape no louder than its limit, and is silent while paused") {
  const ScratchFolder scratch;
  const fs::path file = recorded(scratch.path);
  const auto driver = startWith(file.string(), smallWindow(scratch.path / "other"));
  Application& app = driver->app();
  Playback& playback = app.extensions().playback;
  REQUIRE(playback.on());
  app.settings.sound = true;
  playback.skips_rests = false;
  playback.setRunning(false);
  driver->frames(30);
  const std::vector<float>& heard = app.extensions().touch_sound.heard();
  const auto loudest = [&](std::size_t from) {
    float out = 0.0f;
    for (std::size_t k = from; k < heard.size(); ++k) out = std::max(out, std::abs(heard[k]));
    return out / float(app.settings.sound_volume);
  };
  CHECK(loudest(0) == 0.0f);
  // The touch is pressed for a second: its samples are those of a tone.
  double pressed_s = -1.0;
  for (double t_s = 0.0; t_s < playback.timeline().length_s() && pressed_s < 0.0; t_s += 0.02)
    if (const auto hand = playback.timeline().hand(t_s); hand && hand->feature != Feature::Free) pressed_s = t_s;
  REQUIRE(pressed_s >= 0.0);
  playback.seek(pressed_s);
  playback.setRunning(true);
  std::size_t before = heard.size();
  driver->frames(30);
  CHECK(heard.size() - before == doctest::Approx(0.5 * kSamples_per_s).epsilon(0.05));
  CHECK(loudest(before) > 0.05f);
  CHECK(loudest(before) < 0.99f);
  playback.setRunning(false);
  driver->frames(60);
  before = heard.size();
  driver->frames(30);
  CHECK(heard.size() > before);
  CHECK(loudest(before) == 0.0f);
}

TEST_CASE(
    "a harmonic well to the right of a hovering hand is heard and recorded without a contact, and its playback has the "
    "same force of 0.4 N and draws it toward the well") {
  const ScratchFolder scratch;
  fs::path file;
  Vec3 middle(0.0);
  const auto loudest = [](ScriptedUser& d) {
    float out = 0.0f;
    for (const float sample : d.app().extensions().touch_sound.heard()) out = std::max(out, std::abs(sample));
    return out;
  };
  {
    const auto driver = startWith(kPlaybackLesson, smallWindow(scratch.path));
    Application& app = driver->app();
    app.settings.sound = true;
    driver->point("view", 0.5, 0.5);
    driver->frames(40);
    CHECK(loudest(*driver) == 0.0f);
    middle = app.scene.log().latest().hip.A + 0.5 * app.scene.camera.right();
    app.scene.servo().setInteraction(std::make_unique<test::Harmonic>(
        std::make_unique<test::OpenSpace>(), test::HarmonicPair{0.8}, std::vector<test::Harmonic::Atom>{{0, middle}}));
    driver->frames(180);
    REQUIRE_FALSE(app.scene.log().touching());
    REQUIRE(app.scene.log().force_N() == doctest::Approx(0.4).epsilon(0.02));
    CHECK(loudest(*driver) > 0.03f);
    app.lesson.next();
    driver->frames(30);
    REQUIRE(app.extensions().recorder.flush());
    file = app.extensions().recorder.file();
  }
  const auto driver = startWith(file.string(), smallWindow(scratch.path / "other"));
  Application& app = driver->app();
  Playback& playback = app.extensions().playback;
  REQUIRE(playback.on());
  playback.setRunning(false);
  double at_s = 0.0;
  for (double t_s = 0.0; t_s < playback.timeline().length_s(); t_s += 0.05)
    if (const auto hand = playback.timeline().hand(t_s); hand && hand->wanted_N) at_s = t_s;
  playback.seek(at_s);
  driver->frames(60);
  const ServoSample& now = app.scene.log().latest();
  REQUIRE_FALSE(now.contact.touching());
  CHECK(now.felt());
  CHECK(glm::length(now.force.N) == doctest::Approx(0.4).epsilon(0.02));
  CHECK(glm::distance(glm::normalize(now.forceDirection()), glm::normalize(middle - now.hip.A)) < 0.02);
  CHECK(driver->text("view/force") == "0.4\u00a0N");
}

TEST_CASE(
    "an attempt at 'dock' keeps the body's pose from its turned start on, and its playback draws the body there, out "
    "of the molecule; "
    "closed "
    "again, the molecule is whole") {
  const ScratchFolder scratch;
  const fs::path lesson = scratch.path / "mine.md";
  writeFile(lesson,
            "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: 1hpv\nauthor: A\nlicence: L\n---\n"
            "## One\n```scene\nmolecule: 1hpv\nin-hand: ligand\n```\n"
            "```touch\ndock: file\nsay: Put it back.\n```\n"
            "## Two\n```scene\nin-hand: none\n```\nText.\n");
  fs::path file;
  std::vector<std::uint32_t> held;
  {
    const auto driver = startWith(lesson.string(), smallWindow(scratch.path));
    held = driver->app().scene.stage().body->atoms;
    driver->point("view", 0.5, 0.5);
    driver->frames(30);
    driver->hold("Ctrl");
    driver->drag("view", 150, 40, 1);
    driver->letGo("Ctrl");
    driver->frames(30);
    driver->press();
    driver->frames(60);
    driver->release();
    driver->frames(30);
    driver->app().lesson.next();
    driver->frames(30);
    driver->press();
    driver->frames(60);
    driver->release();
    driver->frames(30);
    REQUIRE(driver->app().extensions().recorder.flush());
    file = driver->app().extensions().recorder.file();
  }
  const Timeline line(*readAttempt(file));
  REQUIRE(line.stage(0.1) != nullptr);
  CHECK(line.stage(0.1)->held == held);
  // The task's hand begins turned by 60 degrees or more.
  REQUIRE(line.hand(0.3));
  REQUIRE(line.hand(0.3)->held);
  CHECK(glm::length(rotationBetween(kNoRotation, line.hand(0.3)->held->body.orientation)) > glm::radians(59.0));
  CHECK(line.stage(line.length_s())->held.empty());

  const auto driver = startWith("1hpv", smallWindow(scratch.path / "other"));
  Application& app = driver->app();
  const AtomList hidden_before = app.scene.look.atoms.hidden;
  app.open(file);
  driver->app().finishLoading();
  Playback& playback = app.extensions().playback;
  REQUIRE(playback.on());
  playback.setRunning(false);
  std::size_t with = 0, without = 0, turned = 0, touched = 0;
  for (int k = 1; k < 40; ++k) {
    playback.seek(line.length_s() * k / 40.0);
    driver->frames(3);
    const auto hand = line.hand(playback.at_s());
    REQUIRE(hand.has_value());
    const ViewScene scene = seenScene(app);
    if (!hand->held) {
      ++without;
      CHECK_FALSE(scene.body);
      continue;
    }
    ++with;
    REQUIRE(scene.body);
    REQUIRE(scene.body_place);
    CHECK(scene.body->atoms == held);
    CHECK(glm::distance(scene.body_place->A, hand->held->body.place.A) < 1e-9);
    CHECK(glm::length(rotationBetween(scene.body_orientation, hand->held->body.orientation)) < 1e-9);
    REQUIRE(scene.look.hidden);
    CHECK(*scene.look.hidden == held);
    turned += glm::length(rotationBetween(kNoRotation, hand->held->orientation)) > 0.5;
    touched += hand->feature != Feature::Free;
  }
  CHECK(with >= 5);
  CHECK(without >= 3);
  CHECK(turned >= 3);
  CHECK(touched >= 2);
  playback.seek(0.5);
  driver->frames(3);
  CHECK(driver->click("playback/close"));
  app.finishLoading();
  driver->frames(5);
  CHECK_FALSE(app.scene.stage().body);
  CHECK_FALSE(app.scene.stage().spheres->hasUntouchable());
  CHECK(app.scene.look.atoms.hidden == hidden_before);
}

TEST_CASE("a lesson that was open continues after the playback as if nothing had been touched meanwhile") {
  const ScratchFolder scratch;
  const fs::path file = recorded(scratch.path);
  const auto driver = startWith(kPlaybackLesson, smallWindow(scratch.path / "own"));
  driver->app().open(file);
  driver->frames(200);
  CHECK_FALSE(driver->shows("lesson/title"));
  CHECK_FALSE(driver->app().lesson.session()->taskDone(0, 0));
  CHECK(driver->click("playback/close"));
  driver->app().finishLoading();
  driver->frames(20);
  CHECK(driver->shows("lesson/title"));
  CHECK(driver->app().lesson.onStage());
  driver->point("view", 0.5, 0.5);
  driver->press();
  driver->frames(40);
  driver->release();
  CHECK(driver->app().lesson.session()->taskDone(0, 0));
}

TEST_CASE(
    "an attempt keeps where the slider between two structures was, and its playback moves the atoms there, also that "
    "of a former version's lines") {
  const ScratchFolder scratch;
  const auto bend = [](double lifted_A) {
    std::string out;
    for (int k = 0; k < 6; ++k) {
      char line[96];
      std::snprintf(line, sizeof line, "ATOM  %5d  CA  GLY A%4d    %8.3f%8.3f%8.3f  1.00  0.00           C  \n", k + 1,
                    k + 1, 3.0 * k, k % 2 ? 1.5 : 0.0,
                    k == 5   ? lifted_A
                    : k == 2 ? 2.0
                             : 0.0);
      out += line;
    }
    return out + "END\n";
  };
  writeFile(scratch.path / "open.pdb", bend(0.0));
  writeFile(scratch.path / "shut.pdb", bend(4.0));
  writeFile(
      scratch.path / "mine.md",
      "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: open.pdb, shut.pdb\nauthor: A\nlicence: L\n---\n## One\n"
      "```scene\nmolecule: open.pdb\nthen: shut.pdb, superposed on residue 1-5\n```\nText.\n\n> [!TIP]\n> Look.\n");
  const auto last_z = [](ScriptedUser& d) { return d.app().scene.atoms().seen()->spheres[5].centre_A.z; };
  fs::path file;
  double first_z = 0.0;
  {
    const auto driver = startWith((scratch.path / "mine.md").string(), smallWindow(scratch.path));
    Application& app = driver->app();
    driver->frames(10);
    REQUIRE(app.extensions().movers.get<MovingStates>().ready());
    first_z = last_z(*driver);
    app.lesson.session()->openHints(1);  // of an attempt at nothing no file is kept
    driver->frames(5);
    app.extensions().movers.get<MovingStates>().goTo(0.5);
    driver->frames(240);
    CHECK(last_z(*driver) == doctest::Approx(first_z + 2.0).epsilon(0.01));
    REQUIRE(app.extensions().recorder.flush());
    file = app.extensions().recorder.file();
  }
  REQUIRE(!file.empty());
  const Expected<Attempt> attempt = readAttempt(file);
  REQUIRE(bool(attempt));
  double share = -1.0;
  std::size_t lines = 0;
  for (const AttemptEvent& e : attempt->events)
    if (const auto* moved = std::get_if<AtomsMoved>(&e.what)) {
      CHECK(moved->by == "states");
      CHECK(moved->file == "shut.pdb");
      CHECK(moved->detail == "residue 1-5");
      CHECK(moved->position > share);
      share = moved->position;
      ++lines;
    }
  CHECK(share == 0.5);
  CHECK(lines > 3);
  // The same lines as former versions wrote them.
  std::string former = bytesOf(file);
  for (const auto& [now, then] : {std::pair{R"("kind":"moved")", R"("kind":"state")"},
                                  {R"("by":"states",)", ""},
                                  {R"("detail":)", R"("superposed_on":)"},
                                  {R"("position":)", R"("share":)"}})
    for (std::size_t at = 0; (at = former.find(now, at)) != std::string::npos;)
      former.replace(at, std::string_view(now).size(), then);
  REQUIRE(contains(former, R"("file":"shut.pdb","superposed_on":"residue 1-5","share":0.5})"));
  writeFile(file.parent_path() / "former.jsonl", former);
  for (const fs::path& played : {file, file.parent_path() / "former.jsonl"}) {
    const auto driver = startWith("1ubq", smallWindow());
    driver->app().open(played);
    driver->app().finishLoading();
    driver->frames(5);
    auto& playback = driver->app().extensions().playback;
    playback.setRunning(false);
    playback.seek(playback.timeline().length_s());
    driver->app().finishLoading();
    driver->frames(5);
    CHECK(last_z(*driver) == doctest::Approx(first_z + 2.0).epsilon(0.01));
    // The playback owns the atoms, so the slider does not move them.
    driver->app().extensions().movers.get<MovingStates>().goTo(1.0);
    driver->frames(60);
    CHECK(last_z(*driver) == doctest::Approx(first_z + 2.0).epsilon(0.01));
    playback.seek(0.1);
    driver->frames(5);
    CHECK(last_z(*driver) == doctest::Approx(first_z).epsilon(0.01));
  }
}

TEST_CASE(
    "files that are no attempts, and a molecule that is not there, are reported and leave the window "
    "as it was") {
  const ScratchFolder scratch;
  const auto driver = startWith(kPlaybackLesson, smallWindow());
  writeFile(scratch.path / "no.jsonl", "{\"a\":1}\n");
  driver->app().open(scratch.path / "no.jsonl");
  driver->frames(3);
  CHECK_FALSE(driver->app().extensions().playback.on());
  CHECK(contains(driver->text("message/0"), "it is no attempt at a lesson"));
  AttemptHeader header = sampleHeader();
  std::vector<AttemptEvent> events = sampleEvents();
  std::get<StageChanged>(events[1].what).file = "nowhere.pdb";
  std::string bytes = lineOf(header);
  for (const AttemptEvent& e : events) bytes += lineOf(e);
  writeFile(scratch.path / "lost.jsonl", bytes);
  driver->app().open(scratch.path / "lost.jsonl");
  driver->frames(10);
  CHECK(driver->app().extensions().playback.on());
  CHECK(contains(driver->text("message/0"), "nowhere.pdb, is not on this computer"));
}

TEST_CASE(
    "an attempt with a force of 1e37 N, a year's gap and a view from 1e9 A away plays, and once it is closed the "
    "molecule is seen as before") {
  const ScratchFolder scratch;
  const fs::path file = scratch.path / "far.jsonl";
  StageChanged stage = std::get<StageChanged>(sampleEvents()[1].what);
  std::string bytes = lineOf(sampleHeader()) + lineOf({0.0, stage});
  HipChunk chunk;
  for (int k = 0; k < 5; ++k) {
    HipSample s;
    s.t_s = 0.1 * k;
    s.hip.A = s.scp.A = {k == 3 ? 2e9 : 30.0, 29.0, k == 4 ? -2e9 : 14.0};
    s.force.N = {1000.0, -1000.0, 1000.0};
    s.feature = k ? Feature::Sphere : Feature::Free;
    s.atoms = {k == 2 ? 2147483647 : 5, -1, -1};
    chunk.samples.push_back(s);
  }
  bytes += lineOf({0.4, chunk}) + lineOf({0.5, ViewChanged{{0.5, 0.5, 0.5, 0.5}, {2e9, -2e9, 2e9}, 1e8}}) +
           lineOf({3e7, ViewChanged{{1, 0, 0, 0}, {2e9, 0, 0}, 0.1}});
  bytes +=
      R"({"kind":"trace","t":0.6,"from":0.6,"ms":[0],"feature":"S","hip":[30,29,14],"scp":[30,29,14],"force":[1e37,0,0],"atoms":[[0,5]]})"
      "\n";
  bytes += R"({"kind":"view","t":0.7,"orientation":[0,0,0,0],"target_A":[1e300,0,0],"distance_A":1e-300})"
           "\n";
  writeFile(file, bytes);
  const auto driver = startWith("1ubq", smallWindow());
  Application& app = driver->app();
  const Camera seen = app.scene.camera;
  app.open(file.string());
  app.finishLoading();
  Playback& playback = app.extensions().playback;
  REQUIRE(playback.on());
  const auto reported = [&](const std::string& part) {
    return std::any_of(app.messages.all().begin(), app.messages.all().end(),
                       [&](const Message& m) { return contains(m.text, part); });
  };
  CHECK(reported(
      "2 lines of far.jsonl could not be read and are left out. The first: line 6, 'force' is a number that no "
      "Moltact writes."));
  playback.skips_rests = false;
  for (const double t_s : {0.0, 0.15, 0.25, 0.31, 0.4, 0.45, 0.55, 0.65, 1e7, 3e7}) {
    playback.seek(t_s);
    driver->frames(3);
    (void)driver->picture();
  }
  CHECK_FALSE(app.scene.camera == seen);
  CHECK(driver->click("playback/close"));
  driver->frames(5);
  CHECK(app.scene.camera == seen);
}

}  // namespace
}  // namespace moltact
