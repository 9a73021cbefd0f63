// A student's scene on the projector: who is asked, what ends it, when it would answer something, and what it may bring.
#include "engine/classroom/shared_scene.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/classroom/class_requests.h"
#include "engine/classroom/scene_picture.h"
#include "tests/classroom/small_class.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using namespace test;
using Json = nlohmann::json;
using State = SharedScene::State;
using Taken = SharedScene::Taken;

// A JPEG's markers up to the frame's header, and its end.
std::string jpegOf(int wide, int high, std::size_t filling = 0) {
  std::string out = "\xFF\xD8\xFF\xE0";
  const auto two = [&](int value) { out += {char(value >> 8), char(value & 0xFF)}; };
  two(16);
  out += std::string("JFIF\0\1\1\0\0\1\0\1\0\0", 14) + "\xFF\xC0";
  two(11);
  out += char(8);
  two(high);
  two(wide);
  return out + std::string("\1\1\x11\0", 4) + std::string(filling, '\x55') + "\xFF\xD9";
}

std::string toBase64(const std::string& bytes) {
  constexpr const char* kSigns = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    unsigned bits = 0;
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - k);
    for (std::size_t i = 0; i < 3; ++i) bits = bits << 8 | (i < n ? static_cast<unsigned char>(bytes[k + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i) out += i <= n ? kSigns[bits >> (18 - 6 * i) & 63] : '=';
  }
  return out;
}

// The small lesson, with a task in the dark at its second step, and a question there that shows the answer after two tries.
std::vector<ClassLesson> darkLessons() {
  std::vector<ClassLesson> out = smallLessons();
  out[0].outline.steps[1].tasks.push_back({"find", "Find the hole"});
  out[0].steps = {{{0, 0}, {0}}, {{1}, {2}}, {{}, {}}};
  return out;
}

LessonOutline darkOutline() { return darkLessons()[0].outline; }

struct Room {
  ClassRoom room{darkLessons(), 7};
  SharedScene scene;
  double now_s = 100.0;
  std::vector<std::size_t> sent;

  std::size_t join(const std::string& name, bool begins = true) {
    const std::size_t number = room.join(name, "token-" + name, now_s)->student;
    sent.push_back(0);
    if (begins) {
      send(number, headerLine(name, darkOutline()));
      send(number, eventLine(0.0, StepEntered{"one"}));
    }
    return number;
  }
  void send(std::size_t student, const std::string& line) {
    sent[student] = room.take(student, "a", sent[student], {line}, now_s).have;
  }
  void enter(std::size_t student, const std::string& step) { send(student, eventLine(1.0, StepEntered{step})); }
  void predict(std::size_t student) {
    send(student, eventLine(1.0, Answered{"one", "expect", 1, {0}, "", false, InputKind::Mouse}));
  }
  SceneHidden answers(std::size_t step, std::size_t& waiting) {
    return sceneAnswers(room, {"bumps", step}, now_s, waiting);
  }
};

TEST_CASE(
    "only a student who is here, at a step of the teacher's lesson and of no test, can be asked, and one at a time") {
  Room at;
  const std::size_t ada = at.join("Ada"), bo = at.join("Bo"), new_one = at.join("New", false);
  CHECK(placeOf(at.room, ada) == ScenePlace{"bumps", 0});
  CHECK_FALSE(placeOf(at.room, new_one));
  CHECK_FALSE(at.scene.ask(at.room, new_one, at.now_s));
  CHECK_FALSE(at.scene.ask(at.room, 9, at.now_s));
  CHECK(at.scene.ask(at.room, ada, at.now_s));
  CHECK_FALSE(at.scene.ask(at.room, bo, at.now_s));
  CHECK(at.scene.takeOff());
  CHECK_FALSE(at.scene.takeOff());
  CHECK_FALSE(at.scene.ask(at.room, ada, at.now_s + 16.0));  // away
  at.room.end();
  CHECK_FALSE(at.scene.ask(at.room, ada, at.now_s));
  std::vector<ClassLesson> tests = darkLessons();
  tests[0].outline.test = true;
  ClassRoom room(tests, 7);
  SmallStudent student(room, "Ada");
  student.at(0.0, StepEntered{"one"});
  CHECK_FALSE(placeOf(room, 0));
}

TEST_CASE("a no, or taking it back, is final for the step; a question without an answer lapses after 60 s") {
  Room at;
  const std::size_t ada = at.join("Ada");
  const ScenePlace one{"bumps", 0}, two{"bumps", 1};
  REQUIRE(at.scene.ask(at.room, ada, at.now_s));
  CHECK_FALSE(at.scene.answer(ada + 1, at.scene.number(), true, true, one));
  CHECK_FALSE(at.scene.answer(ada, at.scene.number() + 1, true, true, one));
  CHECK(at.scene.answer(ada, at.scene.number(), false, true, one));
  CHECK(at.scene.state() == State::None);
  CHECK_FALSE(at.scene.named());
  CHECK_FALSE(at.scene.ask(at.room, ada, at.now_s));
  at.enter(ada, "two");
  REQUIRE(at.scene.ask(at.room, ada, at.now_s));
  CHECK(at.scene.answer(ada, at.scene.number(), true, false, two));
  CHECK(at.scene.withdraw(ada, at.scene.number()));
  CHECK_FALSE(at.scene.withdraw(ada, at.scene.number()));
  CHECK_FALSE(at.scene.ask(at.room, ada, at.now_s));
  at.enter(ada, "three");
  REQUIRE(at.scene.ask(at.room, ada, at.now_s));
  for (int k = 0; k < 6; ++k) {
    at.room.seen(ada, at.now_s += 10.0);
    at.scene.follow(at.room, at.now_s);
    CHECK(at.scene.state() == State::Asked);
  }
  at.room.seen(ada, at.now_s += 0.1);
  at.scene.follow(at.room, at.now_s);
  CHECK(at.scene.state() == State::None);
  CHECK(at.scene.ask(at.room, ada, at.now_s));  // a lapse is no no
}

TEST_CASE(
    "showing ends with the step, by the page and by the lines, with the class, and 15 s after the page fell silent") {
  for (const char* end : {"page", "lines", "class", "silence", "teacher"}) {
    CAPTURE(end);
    Room at;
    const std::size_t ada = at.join("Ada");
    at.predict(ada);
    const ScenePlace one{"bumps", 0};
    REQUIRE(at.scene.ask(at.room, ada, at.now_s));
    REQUIRE(at.scene.answer(ada, at.scene.number(), true, true, one));
    at.scene.follow(at.room, at.now_s);
    std::size_t waiting = 0;
    CHECK(at.scene.hidden(at.room, at.now_s, waiting) == SceneHidden::NoPicture);
    REQUIRE(at.scene.take(ada, at.scene.number(), one, "picture", at.now_s) == Taken::Yes);
    CHECK(at.scene.hidden(at.room, at.now_s, waiting) == SceneHidden::No);
    CHECK(at.scene.hidden(at.room, at.now_s + 5.1, waiting) == SceneHidden::NoPicture);
    const std::string how = end;
    if (how == "page") CHECK(at.scene.take(ada, at.scene.number(), {"bumps", 1}, "picture", at.now_s) == Taken::Over);
    if (how == "lines") at.enter(ada, "two");
    if (how == "class") at.room.end();
    if (how == "silence") at.now_s += 15.1;
    if (how == "teacher") at.scene.takeOff();
    at.scene.follow(at.room, at.now_s);
    CHECK(at.scene.state() == State::None);
    CHECK(at.scene.picture().empty());
    CHECK(at.scene.take(ada, at.scene.number(), one, "picture", at.now_s) == Taken::Over);
    CHECK(at.scene.picture().empty());
  }
}

TEST_CASE("a step that the page has entered and the lines have not is not shown until they have, and does not end it") {
  Room at;
  const std::size_t ada = at.join("Ada");
  at.predict(ada);
  REQUIRE(at.scene.ask(at.room, ada, at.now_s));
  const ScenePlace three{"bumps", 2};
  REQUIRE(at.scene.answer(ada, at.scene.number(), true, false, three));
  REQUIRE(at.scene.take(ada, at.scene.number(), three, "picture", at.now_s) == Taken::Yes);
  at.scene.follow(at.room, at.now_s);
  std::size_t waiting = 0;
  CHECK(at.scene.state() == State::Agreed);
  CHECK(at.scene.hidden(at.room, at.now_s, waiting) == SceneHidden::NoPicture);
  at.enter(ada, "three");
  at.scene.follow(at.room, at.now_s);
  CHECK(at.scene.hidden(at.room, at.now_s, waiting) == SceneHidden::No);
}

TEST_CASE(
    "a scene is hidden while a question of its step is open for somebody there, or a task in the dark for somebody in "
    "the lesson") {
  Room at;
  std::size_t waiting = 0;
  const std::size_t ada = at.join("Ada"), bo = at.join("Bo");
  CHECK(at.answers(0, waiting) == SceneHidden::Question);
  CHECK(waiting == 2);
  at.predict(ada);
  CHECK(at.answers(0, waiting) == SceneHidden::Question);
  CHECK(waiting == 1);
  at.predict(bo);
  CHECK(at.answers(0, waiting) == SceneHidden::No);
  // Who has not begun stands before the first step's question.
  const std::size_t new_one = at.join("New", false);
  CHECK(at.answers(0, waiting) == SceneHidden::Question);
  CHECK(at.answers(2, waiting) == SceneHidden::No);
  at.now_s += 20.0;
  for (const std::size_t student : {ada, bo}) at.room.seen(student, at.now_s);
  CHECK(at.answers(0, waiting) == SceneHidden::No);  // away
  // In the dark at the second step: hidden at every step, also the first one's scene of the same molecule.
  at.enter(bo, "two");
  for (const std::size_t step : {0, 1, 2}) CHECK(at.answers(step, waiting) == SceneHidden::Dark);
  CHECK(waiting == 1);
  at.send(bo, eventLine(2.0, TaskDone{"two", 0, 1.0, InputKind::Mouse, {}, true}));
  CHECK(at.answers(0, waiting) == SceneHidden::No);
  CHECK(at.answers(1, waiting) == SceneHidden::Question);
  // A wrong answer leaves the question open; the second one, after which the page shows the right one, does not.
  const auto answer = [&](int attempt, bool right) {
    at.send(bo, eventLine(3.0, Answered{"two", "which", attempt, {right ? 1U : 0U}, "", right, InputKind::Mouse}));
  };
  answer(1, false);
  CHECK(at.answers(1, waiting) == SceneHidden::Question);
  answer(2, false);
  CHECK(at.answers(1, waiting) == SceneHidden::No);
  answer(3, true);
  CHECK(at.answers(1, waiting) == SceneHidden::No);
  at.room.seen(new_one, at.now_s);
}

TEST_CASE("three pictures in a second are taken, more are not") {
  Room at;
  const std::size_t ada = at.join("Ada");
  REQUIRE(at.scene.ask(at.room, ada, at.now_s));
  const ScenePlace one{"bumps", 0};
  REQUIRE(at.scene.answer(ada, at.scene.number(), true, true, one));
  std::size_t taken = 0;
  for (int k = 0; k < 1000; ++k)
    taken += at.scene.take(ada, at.scene.number(), one, "picture", at.now_s + 0.01 * k) == Taken::Yes;
  CHECK(taken == 4 + 29);  // four at once, and three in each of 9.99 s
}

TEST_CASE("base64 is read as RFC 4648 writes it, and nothing else is") {
  for (const auto& [text, bytes] : {std::pair<const char*, const char*>{"", ""},
                                    {"Zg==", "f"},
                                    {"Zm8=", "fo"},
                                    {"Zm9v", "foo"},
                                    {"Zm9vYg==", "foob"},
                                    {"Zm9vYmE=", "fooba"},
                                    {"Zm9vYmFy", "foobar"}})
    CHECK(fromBase64(text) == std::string(bytes));
  for (const char* broken : {"Z", "Zg", "Zg=", "Zg===", "=Zg=", "Zh==", "Zm9=", "Zm9v\n", "Zm 9", "Zm-_", "===="})
    CHECK_FALSE(fromBase64(broken));
  const std::string picture = jpegOf(640, 400, 1000);
  CHECK(fromBase64(toBase64(picture)) == picture);
}

TEST_CASE("a picture is a JPEG of at most 48 KiB and 1024 pixels a side") {
  CHECK(isSmallJpeg(jpegOf(640, 400)));
  CHECK(isSmallJpeg(jpegOf(1024, 1024)));
  const std::string empty = jpegOf(1, 1);
  CHECK(isSmallJpeg(jpegOf(1, 1, kMaxPictureBytes - empty.size())));
  CHECK_FALSE(isSmallJpeg(jpegOf(1, 1, kMaxPictureBytes - empty.size() + 1)));
  CHECK_FALSE(isSmallJpeg(jpegOf(1025, 1)));
  CHECK_FALSE(isSmallJpeg(jpegOf(1, 65535)));
  CHECK_FALSE(isSmallJpeg(jpegOf(0, 1)));
  for (const char* other : {"", "\xFF\xD8\xFF\xD9", "GIF89a", "\x89PNG\r\n", "<svg/>"}) CHECK_FALSE(isSmallJpeg(other));
  for (std::size_t k = 0; k < empty.size(); ++k) CHECK_FALSE(isSmallJpeg(empty.substr(0, k)));
}

// ---- the requests ----------------------------------------------------------------------------------------------------

struct SceneSite {
  ScratchFolder scratch;
  std::unique_ptr<ClassStore> store;
  std::unique_ptr<ClassRequests> requests;
  double now_s = 0.0;

  SceneSite() {
    auto opened = ClassStore::begin(scratch.path / "class", {"abc234", "t22", 7, 8230, "2026-11-21T10:00:00Z"});
    REQUIRE(opened);
    store = *std::move(opened);
    ClassSite site;
    site.page = "<script id=\"classroom-script\"></script><!--a lesson comes here-->";
    site.hosts = {"127.0.0.1:8230"};
    site.address = "http://127.0.0.1:8230/abc234/";
    site.random = [seed = std::uint64_t{1}](std::size_t n) mutable {
      std::string out;
      for (std::size_t k = 0; k < n; ++k) out += char(nextRandom(seed) >> 33);
      return out;
    };
    auto made = ClassRequests::make(std::move(site), ClassRoom(darkLessons(), 7), *store);
    REQUIRE(made);
    requests = *std::move(made);
  }
  ClassReply ask(const std::string& path, const std::string& body = "", const std::string& tag = "",
                 const std::string& remote = "127.0.0.1") {
    ClassRequest request;
    request.method = body.empty() ? "GET" : "POST";
    request.path = path;
    request.host = "127.0.0.1:8230";
    request.content_type = "application/json";
    request.remote = remote;
    request.if_none_match = tag;
    request.body = body;
    request.now_s = now_s += 0.5;
    return requests->answer(request);
  }
  std::string join(const std::string& name) {
    const std::string token =
        Json::parse(ask("/abc234/join", Json{{"name", name}}.dump()).body)["token"].get<std::string>();
    poll(token, {headerLine("", darkOutline()), eventLine(0.0, StepEntered{"one"}),
                 eventLine(1.0, Answered{"one", "expect", 1, {0}, "", false, InputKind::Mouse})});
    return token;
  }
  Json poll(const std::string& token, const std::vector<std::string>& lines = {}, std::size_t from = 0) {
    return Json::parse(
        ask("/abc234/lines", Json{{"token", token}, {"attempt", "a"}, {"from", from}, {"lines", lines}}.dump()).body);
  }
  int steer(const Json& body) { return ask("/teacher/t22/steer", body.dump()).status; }
  int say(const std::string& token, std::uint64_t number, const std::string& say, bool named = false) {
    return ask("/abc234/scene", Json{{"token", token},
                                     {"scene", number},
                                     {"say", say},
                                     {"named", named},
                                     {"lesson", "bumps"},
                                     {"step", 0}}
                                    .dump())
        .status;
  }
  int send(const std::string& token, std::uint64_t number, const std::string& picture, std::size_t step = 0) {
    return ask("/abc234/scene", Json{{"token", token},
                                     {"scene", number},
                                     {"lesson", "bumps"},
                                     {"step", step},
                                     {"picture", toBase64(picture)}}
                                    .dump())
        .status;
  }
};

TEST_CASE("asked, agreed with the name, shown, taken back: only the student's yes brings the scene to the projector") {
  SceneSite site;
  const std::string ada = site.join("Ada <b>"), bo = site.join("Bo"), picture = jpegOf(640, 400, 200);
  CHECK_FALSE(site.poll(ada).contains("scene"));
  CHECK(site.send(ada, 1, picture) == 410);  // nobody has asked
  CHECK(site.say(ada, 1, "yes") == 410);
  CHECK(site.ask("/teacher/t22/").body.find("id=\"ask-scene-0\"") != std::string::npos);
  CHECK(site.steer({{"do", "ask scene"}, {"student", 0}}) == 200);
  CHECK(site.steer({{"do", "ask scene"}, {"student", 1}}) == 400);
  CHECK(site.poll(ada)["scene"] == Json{{"ask", 1}});
  CHECK_FALSE(site.poll(bo).contains("scene"));
  // Neither without the answer, nor by another student, nor with another number.
  CHECK(site.send(ada, 1, picture) == 410);
  CHECK(site.say(bo, 1, "yes", true) == 410);
  CHECK(site.say(ada, 2, "yes", true) == 410);
  CHECK(site.ask("/abc234/scene").status == 404);
  CHECK(site.ask("/abc234/board").body.find("Ada") == std::string::npos);
  CHECK(site.say(ada, 1, "yes", true) == 200);
  CHECK(site.poll(ada)["scene"] == Json{{"show", 1}});
  CHECK(site.ask("/abc234/scene").status == 409);  // no picture yet
  CHECK(site.send(bo, 1, picture) == 410);
  CHECK(site.send(ada, 1, picture) == 200);
  const ClassReply shown = site.ask("/abc234/scene");
  CHECK(shown.status == 200);
  CHECK(shown.type == "image/jpeg");
  CHECK(shown.body == picture);
  CHECK_FALSE(shown.whole);  // which a browser may keep
  REQUIRE(shown.headers.front().first == "ETag");
  CHECK(site.ask("/abc234/scene", "", shown.headers.front().second).status == 304);
  CHECK(site.send(ada, 1, picture) == 200);
  CHECK(site.ask("/abc234/scene", "", shown.headers.front().second).status == 200);
  const ClassReply board = site.ask("/abc234/board");
  CHECK(board.body.find("The scene of Ada &lt;b&gt;") != std::string::npos);
  CHECK(board.body.find("<script src=\"board.js\"") != std::string::npos);
  for (const std::string& secret : {std::string("t22"), ada, bo, std::string("Ada <b>"), std::string("http-equiv")})
    CHECK_MESSAGE(board.body.find(secret) == std::string::npos, secret);
  CHECK(site.ask("/abc234/board.js").type == "text/javascript; charset=utf-8");
  const std::string teacher = site.ask("/teacher/t22/").body;
  CHECK(teacher.find("shows the scene of Ada &lt;b&gt;, with the name") != std::string::npos);
  CHECK(teacher.find("ask-scene-") == std::string::npos);
  // Bo comes to the task in the dark: hidden at once, for as long.
  site.poll(bo, {eventLine(2.0, StepEntered{"two"})}, 3);
  CHECK(site.ask("/abc234/scene").status == 409);
  CHECK(site.ask("/abc234/scene").body.find("without seeing") != std::string::npos);
  site.poll(bo, {eventLine(3.0, TaskDone{"two", 0, 1.0, InputKind::Mouse, {}, true})}, 4);
  CHECK(site.send(ada, 1, picture) == 200);
  CHECK(site.ask("/abc234/scene").status == 200);
  // An empty picture is none.
  CHECK(site.send(ada, 1, "") == 200);
  CHECK(site.ask("/abc234/scene").status == 409);
  CHECK(site.say(ada, 1, "stop") == 200);
  CHECK(site.ask("/abc234/scene").status == 404);
  CHECK(site.ask("/abc234/board").body.find("Ada") == std::string::npos);
  CHECK_FALSE(site.poll(ada).contains("scene"));
  CHECK(site.steer({{"do", "ask scene"}, {"student", 0}}) == 400);  // not again at this step
  // Nothing of it is on the disk.
  REQUIRE_FALSE(site.store->commit(site.store->newest()));
  const std::string journal = bytesOf(site.scratch.path / "class" / "class.jsonl");
  CHECK(journal.find("Ada") != std::string::npos);
  for (const char* word : {"scene", "JFIF", "picture"}) CHECK(journal.find(word) == std::string::npos);
}

TEST_CASE("without the name the projector's page has none, and the teacher takes the scene off") {
  SceneSite site;
  const std::string ada = site.join("Ada");
  REQUIRE(site.steer({{"do", "ask scene"}, {"student", 0}}) == 200);
  REQUIRE(site.say(ada, 1, "yes") == 200);
  const std::string board = site.ask("/abc234/board").body;
  CHECK(board.find("The scene of a student") != std::string::npos);
  CHECK(board.find("Ada") == std::string::npos);
  CHECK(site.ask("/abc234/steer", R"({"do":"end scene"})").status == 404);
  CHECK(site.steer({{"do", "end scene"}}) == 200);
  CHECK(site.steer({{"do", "end scene"}}) == 400);
  CHECK(site.send(ada, 1, jpegOf(2, 2)) == 410);
  CHECK(site.steer({{"do", "ask scene"}, {"student", 0}}) == 200);
  CHECK(site.poll(ada)["scene"] == Json{{"ask", 2}});
  CHECK(site.say(ada, 1, "yes") == 410);  // the answer to an earlier question
}

TEST_CASE("bodies about a scene are bounded and have one form, and others' looks are limited together") {
  SceneSite site;
  const std::string ada = site.join("Ada");
  REQUIRE(site.steer({{"do", "ask scene"}, {"student", 0}}) == 200);
  REQUIRE(site.say(ada, 1, "yes") == 200);
  const auto post = [&](const Json& body) { return site.ask("/abc234/scene", body.dump()).status; };
  const Json good{{"token", ada}, {"scene", 1}, {"lesson", "bumps"}, {"step", 0}, {"picture", toBase64(jpegOf(2, 2))}};
  CHECK(post(good) == 200);
  Json other = good;
  for (const char* key : {"token", "scene", "picture"}) {
    other = good;
    other.erase(key);
    CHECK(post(other) == 400);
  }
  for (const Json& picture : {Json("Zg=="), Json("%%%"), Json(toBase64("<svg onload=alert(1)>")), Json(7),
                              Json(toBase64(jpegOf(5000, 5000)))}) {
    other = good;
    other["picture"] = picture;
    CHECK(post(other) == 400);
  }
  other = good;
  other["token"] = "nobody";
  CHECK(post(other) == 403);
  other = good;
  other["picture"] = std::string(kMaxSceneBody, 'A');
  CHECK(post(other) == 413);
  site.now_s += 10.0;
  CHECK(post(good) == 200);
  int looks = 0;
  for (int k = 0; k < 200; ++k) {
    site.now_s -= 0.5;  // all at once
    looks += site.ask("/abc234/scene", "", "", "10.0.0." + std::to_string(k)).status == 200;
  }
  CHECK(looks == 20);
  CHECK(site.ask("/abc234/scene").status == 200);  // of the laptop itself
  // Another step's picture ends it.
  site.now_s += 1.0;
  CHECK(site.send(ada, 1, jpegOf(2, 2), 1) == 410);
  CHECK(site.ask("/abc234/scene").status == 404);
}

}  // namespace
}  // namespace moltact
