// A class that the window's program serves: begun, joined over the loopback, seen and steered without a browser, ended.
#include "engine/classroom/taught_class.h"

#include <doctest/doctest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/lesson/reader.h"
#include "engine/platform/folders.h"
#include "tests/classroom/http_client.h"
#include "tests/classroom/small_class.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Json = nlohmann::json;

bool comesTo(const TaughtClass& taught, TaughtClass::State state) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (taught.state() != state && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return taught.state() == state;
}

struct Desk {
  ScratchFolder scratch;
  LiveClassOptions options;
  std::uint16_t port = 0;
  std::string code;

  Desk() {
    writeFile(scratch.path / "page.html",
              "<html><script type=\"text/plain\" id=\"classroom-script\"></script><!--a lesson comes here--></html>");
    options.lessons = {"first-touch"};
    options.page = scratch.path / "page.html";
    options.folder = scratch.path / "class";
    options.port = 0;
  }
  void read(const TaughtClass& taught) {
    const std::string address = taught.facts().address, before = "http://127.0.0.1:";
    REQUIRE(address.starts_with(before));
    port = std::uint16_t(std::stoi(address.substr(before.size())));
    code = address.substr(address.find('/', before.size()));  // "/abcdefgh/"
  }
  Json post(const std::string& path, const Json& body) const {
    const HttpAnswer answer = httpAsk(port, "POST", code + path, body.dump(), "Content-Type: application/json\r\n");
    REQUIRE(answer.status == 200);
    return Json::parse(answer.body);
  }
};

TEST_CASE("the window's class is joined, seen, held, opened, asked for a scene and ended, and leaves the report") {
  Desk desk;
  auto taught = std::make_unique<TaughtClass>(desk.options);
  REQUIRE(comesTo(*taught, TaughtClass::State::Served));
  desk.read(*taught);
  CHECK(taught->facts().teacher.find("/teacher/") != std::string::npos);
  CHECK_FALSE(taught->facts().shared);
  CHECK(taught->facts().qr.width == 0);  // nobody else reaches it
  REQUIRE(taught->view());
  CHECK(taught->view()->students.empty());

  const LessonReading reading = readLesson(lessonsFolder() / "first-touch.md");
  REQUIRE(reading.lesson);
  const LessonOutline lesson = outlineOf(*reading.lesson, "0123456789abcdef");
  const std::string token = desk.post("join", {{"name", "Ada"}})["token"];
  const Json poll{{"token", token}};
  desk.post("lines", {{"token", token},
                      {"attempt", "a"},
                      {"from", 0},
                      {"lines", {headerLine("", lesson), eventLine(0.0, StepEntered{lesson.steps[0].id})}}});
  const auto view = taught->view();
  REQUIRE(view);
  REQUIRE(view->students.size() == 1);
  CHECK(view->students[0].name == "Ada");
  CHECK(view->students[0].step_number == 1);
  CHECK(view->here == 1);

  taught->hold("first-touch", 1);
  CHECK(desk.post("lines", poll)["held"] == Json{{"first-touch", 1}});
  CHECK(taught->view()->lessons[0].held == 1);
  taught->open("first-touch");
  CHECK(desk.post("lines", poll)["held"].empty());
  REQUIRE(taught->view()->students[0].may_ask_scene);
  taught->askForScene(0);
  CHECK(desk.post("lines", poll)["scene"] == Json{{"ask", 1}});
  REQUIRE(taught->view()->scene);
  CHECK(taught->view()->scene->student == "Ada");
  taught->endScene();
  CHECK_FALSE(taught->view()->scene);
  taught->end();
  CHECK(taught->view()->ended);
  CHECK(desk.post("lines", poll)["ended"] == true);

  const auto report = taught->writeReport();
  REQUIRE(report);
  CHECK(bytesOf(*report).find("Ada") != std::string::npos);
  taught->stop();
  REQUIRE(comesTo(*taught, TaughtClass::State::Over));
  CHECK_FALSE(taught->problem());
  CHECK(taught->report() == desk.scratch.path / "class" / "report.html");
  CHECK_FALSE(taught->view());
  CHECK(fs::exists(desk.scratch.path / "class/attempts/student-001-1.jsonl"));
}

TEST_CASE("a class that cannot begin is over with its reason, and one that is let go of stops and frees its folder") {
  Desk desk;
  desk.options.lessons = {"no-such-lesson"};
  const TaughtClass none(desk.options);
  REQUIRE(comesTo(none, TaughtClass::State::Over));
  REQUIRE(none.problem());
  CHECK(none.problem()->text().find("no-such-lesson") != std::string::npos);
  desk.options.lessons = {"first-touch"};
  for (int k = 0; k < 2; ++k) {
    const TaughtClass one(desk.options);
    REQUIRE_MESSAGE(comesTo(one, TaughtClass::State::Served), (one.problem() ? one.problem()->text() : ""));
  }
}

TEST_CASE("folders of classes are named by the time in UTC, so that the newest is the last") {
  const std::string name = newClassFolder().filename().string();
  CHECK(name.size() == 17);
  CHECK(name.find_first_not_of("0123456789-") == std::string::npos);
  CHECK(newClassFolder().parent_path().filename() == "classes");
}

}  // namespace
}  // namespace moltact
