// `moltact class` as a process on a free port of the loopback: joined, sent to, killed and started again.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/results/attempt_file.h"
#include "tests/classroom/http_client.h"
#include "tests/classroom/small_class.h"
#include "tests/dynamics/child_program.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Json = nlohmann::json;

// A class in a process of its own, with a page that stands for the browser edition.
struct RunningClass {
  ScratchFolder scratch;
  std::uint16_t port = freePort();
  std::string code, teacher;
  std::unique_ptr<ChildProgram> process;

  RunningClass() {
    writeFile(scratch.path / "page.html",
              "<html><script type=\"text/plain\" id=\"classroom-script\"></script><!--a lesson comes here--></html>");
    start();
  }
  // `lessons`: the command names the lesson; else the folder has to know it.
  void start(bool lessons = true) {
    fs::remove(scratch.path / "log");
    process = std::make_unique<ChildProgram>(command(lessons), scratch.path.string(), "log");
    const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    for (;;) {
      const std::string log = bytesOf(scratch.path / "log");
      if (log.find("Ctrl+C") != std::string::npos) {
        const std::string student = "http://127.0.0.1:" + std::to_string(port) + "/";
        const std::size_t at = log.find(student) + student.size(), token = log.find("/teacher/") + 9;
        code = log.substr(at, log.find('/', at) - at);
        teacher = log.substr(token, log.find('/', token) - token);
        return;
      }
      if (process->ended() || std::chrono::steady_clock::now() > until) FAIL("it does not start: " << log);
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }
  std::vector<std::string> command(bool lessons) const {
    std::vector<std::string> out{MOLTACT_BINARY, "class"};
    if (lessons) out.emplace_back("first-touch");
    out.insert(out.end(), {"--folder", (scratch.path / "class").string(), "--port", std::to_string(port), "--page",
                           (scratch.path / "page.html").string()});
    return out;
  }
  HttpAnswer post(const std::string& path, const Json& body, const std::string& more = "") const {
    return httpAsk(port, "POST", path, body.dump(), "Content-Type: application/json\r\n" + more);
  }
  HttpAnswer get(const std::string& path, const std::string& more = "") const {
    return httpAsk(port, "GET", path, "", more);
  }
};

LessonOutline firstTouch() {
  LessonOutline lesson = smallOutline();
  lesson.file = "first-touch.md";
  return lesson;
}

TEST_CASE(
    "a class is served, killed while 8 students send, and started again: every acknowledged line is there, once") {
  RunningClass room;
  CHECK(room.code.size() == 8);
  CHECK(room.teacher.size() == 26);
  const HttpAnswer page = room.get("/" + room.code + "/");
  CHECK(page.status == 200);
  CHECK(page.body.find("class-facts") != std::string::npos);
  CHECK(room.get("/" + room.code + "/lesson/0").body.starts_with("PK"));

  constexpr int kStudents = 8;
  std::vector<std::string> tokens;
  for (int k = 0; k < kStudents; ++k) {
    const HttpAnswer joined = room.post("/" + room.code + "/join", {{"name", k ? "" : "Ada"}});
    REQUIRE(joined.status == 200);
    tokens.push_back(Json::parse(joined.body)["token"]);
  }
  // Each sends lines, of which it counts those that were acknowledged, until the server dies.
  std::array<std::atomic<std::size_t>, kStudents> kept{};
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < kStudents; ++k)
    threads.emplace_back([&, k] {
      for (;;) {
        const std::size_t from = kept[k];
        const std::string line = from == 0 ? headerLine("", firstTouch()) : eventLine(double(from), HintOpened{"one"});
        const HttpAnswer answer = room.post(
            "/" + room.code + "/lines", {{"token", tokens[k]}, {"attempt", "a"}, {"from", from}, {"lines", {line}}});
        if (answer.status == 429) {
          std::this_thread::sleep_for(std::chrono::milliseconds(100));
          continue;
        }
        if (answer.status != 200) return;
        kept[k] = Json::parse(answer.body)["have"];
      }
    });
  std::this_thread::sleep_for(std::chrono::milliseconds(1500));
  room.process->kill();
  for (std::thread& one : threads) one.join();

  room.start();
  std::size_t acknowledged = 0;
  for (std::size_t k = 0; k < kStudents; ++k) {
    CHECK(kept[k] > 2);
    acknowledged += kept[k];
    const HttpAnswer answer = room.post(
        "/" + room.code + "/lines", {{"token", tokens[k]}, {"attempt", "a"}, {"from", 0}, {"lines", Json::array()}});
    REQUIRE(answer.status == 200);
    const std::size_t have = Json::parse(answer.body)["have"];
    // One more may be on the disk whose answer died with the server.
    CHECK(have >= kept[k]);
    CHECK(have <= kept[k] + 1);
  }
  CHECK(acknowledged > 40);

  // The report, and the attempts from which it is made.
  const HttpAnswer report = room.get("/teacher/" + room.teacher + "/report");
  CHECK(report.status == 200);
  CHECK(report.body.find(">Ada<") != std::string::npos);
  for (std::size_t k = 0; k < kStudents; ++k) {
    const auto attempt =
        readAttempt(room.scratch.path / ("class/attempts/student-00" + std::to_string(k + 1) + "-1.jsonl"));
    REQUIRE(attempt);
    CHECK(attempt->problems.empty());
    CHECK(attempt->events.size() + 1 >= kept[k]);
    for (std::size_t n = 0; n < attempt->events.size(); ++n) CHECK(attempt->events[n].t_s == double(n + 1));
  }

  // The teacher's page listens: the first event has the names.
  const HttpAnswer events = httpAsk(room.port, "GET", "/teacher/" + room.teacher + "/events", "", "", "Ada");
  CHECK(events.status == 200);
  CHECK(events.body.find("event: live") != std::string::npos);
  CHECK(events.body.find("Ada") != std::string::npos);

  // Ended and stopped by a signal: what remains.
  CHECK(room.post("/teacher/" + room.teacher + "/steer", {{"do", "end"}}).status == 200);
  room.process->signal(SIGINT);
  for (int k = 0; k < 500 && !room.process->ended(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(room.process->ended());
  CHECK(bytesOf(room.scratch.path / "class/class.jsonl").find("\"line\"") != std::string::npos);
  CHECK(bytesOf(room.scratch.path / "log").find("report.html") != std::string::npos);
}

TEST_CASE("a class that is started again with its folder alone has its lesson, and what was held is held") {
  RunningClass room;
  const Json hold{{"do", "hold"}, {"lesson", "first-touch"}, {"step", 1}};
  REQUIRE(room.post("/teacher/" + room.teacher + "/steer", hold).status == 200);
  const std::string token = Json::parse(room.post("/" + room.code + "/join", {{"name", "Ada"}}).body)["token"];
  room.process->kill();
  room.start(false);
  CHECK(room.get("/" + room.code + "/lesson/0").body.starts_with("PK"));
  CHECK(Json::parse(room.post("/" + room.code + "/lines", {{"token", token}}).body)["held"] ==
        Json{{"first-touch", 1}});
}

TEST_CASE(
    "what a connection brings is bounded: bodies, their encodings, methods, hosts, paths; and the server lives on") {
  RunningClass room;
  const std::string join = "/" + room.code + "/join";
  const std::string json = "Content-Type: application/json\r\n";
  CHECK(httpRaw(room.port, "POST " + join + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(room.port) + "\r\n" +
                               json + "Content-Length: 1048577\r\n\r\n")
            .status == 413);
  CHECK(httpRaw(room.port, "POST " + join + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(room.port) + "\r\n" +
                               json + "Transfer-Encoding: chunked\r\n\r\n5\r\n{\"a\":\r\n")
            .status == 400);
  CHECK(httpAsk(room.port, "POST", join, "{}", json + "Content-Encoding: gzip\r\n").status == 400);
  CHECK(httpRaw(room.port,
                "POST " + join + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(room.port) + "\r\n" + json + "\r\n")
            .status == 411);
  CHECK(httpAsk(room.port, "POST", join, "a=b", "Content-Type: application/x-www-form-urlencoded\r\n").status == 415);
  CHECK(httpAsk(room.port, "DELETE", join, "", json).status == 405);
  CHECK(httpAsk(room.port, "POST", join, "{}", json + "Origin: http://evil.example\r\n").status == 403);
  CHECK(httpRaw(room.port, "GET /" + room.code + "/ HTTP/1.1\r\nHost: evil.example\r\n\r\n").status == 403);
  CHECK(room.get("/" + room.code + "/", "Range: bytes=0-1,0-1,0-1\r\n").status == 400);
  CHECK(room.get("/../../etc/passwd").status == 404);
  CHECK(room.get("/" + room.code + "/%2e%2e/%2e%2e/etc/passwd").status == 404);
  CHECK(room.get("/" + std::string(3000, 'a')).status == 404);
  CHECK(room.get("/teacher/" + std::string(26, 'x') + "/").status == 404);
  CHECK(httpRaw(room.port, "nonsense\r\n\r\n").status != 200);
  const HttpAnswer named = room.post(join, {{"name", "<script>alert(1)</script>"}});
  CHECK(named.status == 200);
  CHECK(room.get("/teacher/" + room.teacher + "/").body.find("<script>alert") == std::string::npos);
  CHECK_FALSE(room.process->ended());
}

}  // namespace
}  // namespace moltact
