// What a request may do: secrets, other sites, sizes, rates, names of files, and what an answer acknowledges. Without sockets.
#include "engine/classroom/class_requests.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "engine/classroom/class_server.h"
#include "engine/platform/local_addresses.h"
#include "engine/results/attempt_file.h"
#include "tests/classroom/small_class.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

using namespace test;
namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kSmallPage =
    "<html><script type=\"text/plain\" id=\"classroom-script\"></script><!--a lesson comes "
    "here--><script>run</script></html>";

struct SmallSite {
  ScratchFolder scratch;
  std::unique_ptr<ClassStore> store;
  std::unique_ptr<ClassRequests> requests;
  double now_s = 0.0;

  SmallSite() { start(); }
  void start() {
    const fs::path folder = scratch.path / "class";
    requests.reset();
    store.reset();
    auto opened = ClassStore::begun(folder)
                      ? ClassStore::goOn(folder)
                      : ClassStore::begin(folder, {"abc234", "teachertoken22", 7, 8230, "2026-11-21T10:00:00Z"});
    REQUIRE_MESSAGE(opened, opened.problem().text());
    store = *std::move(opened);
    ClassRoom room(smallLessons(), store->identity().seed);
    store->forEachRecord([&](std::string_view record) { CHECK_MESSAGE(room.restore(record), record); });
    ClassSite site;
    site.page = kSmallPage;
    site.lessons = {{"bumps", "Bumps </script><!--", std::make_shared<const std::string>("PACK")}};
    site.hosts = {"127.0.0.1:8230", "laptop.local:8230"};
    site.address = "http://127.0.0.1:8230/abc234/";
    site.random = [seed = std::uint64_t{1}](std::size_t n) mutable {
      std::string out;
      for (std::size_t k = 0; k < n; ++k) out += char(nextRandom(seed) >> 33);
      return out;
    };
    auto made = ClassRequests::make(std::move(site), std::move(room), *store);
    REQUIRE(made);
    requests = *std::move(made);
  }

  ClassReply ask(const std::string& method, const std::string& path, const std::string& body = "",
                 const std::function<void(ClassRequest&)>& change = {}) {
    ClassRequest request;
    request.method = method;
    request.path = path;
    request.host = "127.0.0.1:8230";
    if (method == "POST") request.content_type = "application/json";
    request.remote = path.starts_with("/teacher") ? "127.0.0.1" : "10.0.0.7";
    request.body = body;
    request.now_s = now_s += 0.2;
    if (change) change(request);
    return requests->answer(request);
  }
  Json join(const std::string& name) {
    const ClassReply reply = ask("POST", "/abc234/join", Json{{"name", name}}.dump());
    REQUIRE(reply.status == 200);
    return Json::parse(reply.body);
  }
  ClassReply send(const std::string& token, std::size_t from, const std::vector<std::string>& lines,
                  const std::string& key = "bumps-1") {
    return ask("POST", "/abc234/lines",
               Json{{"token", token}, {"attempt", key}, {"from", from}, {"lines", lines}}.dump());
  }
};

TEST_CASE("the projector's page has the address, its QR code and a number, and neither names, answers nor the token") {
  SmallSite site;
  const std::string token = site.join("Ada")["token"];
  site.send(token, 0, {headerLine(), eventLine(0.0, StepEntered{"one"})});
  const ClassReply board = site.ask("GET", "/abc234/board");
  REQUIRE(board.status == 200);
  CHECK(board.body.find("http://127.0.0.1:8230/abc234/") != std::string::npos);
  CHECK(board.body.find("1 student here") != std::string::npos);
  for (const std::string& secret : {std::string("Ada"), std::string("teachertoken22"), std::string("<script"), token})
    CHECK(board.body.find(secret) == std::string::npos);
  const std::string page = site.ask("GET", "/teacher/teachertoken22/").body;
  CHECK(page.find("/abc234/board") != std::string::npos);
  CHECK(page.find("class=\"qr\"") == std::string::npos);
}

TEST_CASE(
    "the printed addresses are those that others reach, that of the default route first, and no bridge of containers") {
  const std::vector<InterfaceAddress> interfaces{
      {"127.0.0.1", true, true, false},  {"172.17.0.1", true, false, true},   {"10.8.0.2", true, true, false},
      {"10.0.0.4", false, false, false}, {"192.168.9.1", true, false, false}, {"192.168.1.5", true, false, false}};
  const LocalAddresses by_radio = addressesForOthers(interfaces, "192.168.1.5");
  CHECK(by_radio.ip == std::vector<std::string>{"192.168.1.5", "192.168.9.1"});
  CHECK(by_radio.bridges == std::vector<std::string>{"172.17.0.1"});
  // A bridge over the network's own cable has the default route.
  CHECK(addressesForOthers(interfaces, "172.17.0.1").ip ==
        std::vector<std::string>{"172.17.0.1", "192.168.9.1", "192.168.1.5"});
  // A private network behind a tunnel has the route: the others keep the system's order.
  CHECK(addressesForOthers(interfaces, "10.8.0.2").ip == std::vector<std::string>{"192.168.9.1", "192.168.1.5"});
  CHECK(addressesForOthers({{"127.0.0.1", true, true, false}}, "").ip.empty());
}

TEST_CASE(
    "the projector shows one plot when the teacher says so, of three predictions and more, without a name or a typed "
    "word, and also after a restart") {
  SmallSite site;
  const auto board = [&] {
    const ClassReply reply =
        site.ask("GET", "/abc234/board", "", [&](ClassRequest& r) { r.now_s = site.now_s += 1.0; });
    REQUIRE(reply.status == 200);
    return reply.body;
  };
  const auto steer = [&](const std::string& body) {
    return site.ask("POST", "/teacher/teachertoken22/steer", body).status;
  };
  const std::string show = R"({"do":"show","lesson":"bumps","step":0,"question":0})", page = "/teacher/teachertoken22/";
  std::vector<std::string> tokens;
  const auto predict = [&](const std::string& name, std::size_t choice) {
    tokens.push_back(site.join(name)["token"]);
    site.send(tokens.back(), 0,
              {headerLine(), eventLine(0.0, StepEntered{"one"}),
               eventLine(1.0, Answered{"one", "expect", 1, {choice}, "typed-by-" + name, true, InputKind::Mouse}),
               eventLine(2.0, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {0.0, 1.0}})});
  };
  predict("Ada", 0);
  predict("Bo", 1);
  CHECK(site.ask("GET", page).body.find("data-do=\"show\"") == std::string::npos);
  CHECK(steer(show) == 400);  // of two students
  CHECK(board().find("What will you feel?") == std::string::npos);
  predict("Cy", 1);
  CHECK(board().find("What will you feel?") == std::string::npos);
  // Who has not predicted is counted beside the button, and asked about.
  const std::string late = site.join("Dee")["token"];
  site.send(late, 0, {headerLine()});
  site.join("Eve");
  const std::string teacher = site.ask("GET", page).body;
  CHECK(teacher.find("id=\"show-question-bumps-0-0\"") != std::string::npos);
  CHECK(teacher.find("2 students here have not predicted yet and would see") != std::string::npos);
  CHECK(steer(show) == 200);
  for (const std::string& all : {std::string("3"), std::string("4")}) {
    const std::string shown = board(), others = all == "3" ? "2" : "3";
    CHECK(shown.find("What will you feel?") != std::string::npos);
    CHECK(shown.find("What " + all + " students expect") != std::string::npos);
    CHECK(shown.find("max=\"" + all + "\" value=\"1\"></meter><b>1</b>") != std::string::npos);
    CHECK(shown.find("max=\"" + all + "\" value=\"" + others + "\"></meter><b>" + others + "</b>") !=
          std::string::npos);
    // The prediction of a student who is late does not appear, until the server begins again.
    if (all == "3") {
      predict("Flo", 1);
      CHECK(board().substr(0, board().find("<section>")) == shown.substr(0, shown.find("<section>")));
    }
    for (const char* secret :
         {"Ada", "Bo<", "Cy", "Dee", "Eve", "Flo", "typed-by", "teachertoken22", "<script", "<button"})
      CHECK_MESSAGE(shown.find(secret) == std::string::npos, secret);
    CHECK(site.ask("GET", page).body.find("id=\"hide-question-bumps-0-0\"") != std::string::npos);
    site.start();
  }
  // The force curves of a task, in its place.
  CHECK(steer(R"({"do":"show","lesson":"bumps","step":0,"task":0})") == 200);
  const std::string curves = board();
  CHECK(curves.find("Draw the force") != std::string::npos);
  CHECK(curves.find("class=\"drawn\"") != std::string::npos);
  CHECK(curves.find("What will you feel?") == std::string::npos);
  CHECK(steer(R"({"do":"hide"})") == 200);
  CHECK(board().find("Draw the force") == std::string::npos);
  // A marked question, a question or a lesson that is not there, and nothing to take off.
  for (const char* body :
       {R"({"do":"show","lesson":"bumps","step":1,"question":0})",
        R"({"do":"show","lesson":"bumps","step":0,"question":1})",
        R"({"do":"show","lesson":"bumps","step":9,"task":0})", R"({"do":"show","lesson":"bumps","step":0,"task":-1})",
        R"({"do":"show","lesson":"other","step":0,"question":0})", R"({"do":"show"})", R"({"do":"hide"})"})
    CHECK_MESSAGE(steer(body) == 400, body);
  CHECK(site.ask("POST", "/abc234/steer", show).status == 404);
}

TEST_CASE("the projector's page is made once in a second, however many ask for it") {
  SmallSite site;
  const auto board = [&](double now_s) {
    return site.ask("GET", "/abc234/board", "", [&](ClassRequest& r) { r.now_s = now_s; }).body;
  };
  CHECK(board(10.0).find("0 students here") != std::string::npos);
  site.now_s = 10.0;
  site.join("Ada");
  CHECK(board(10.9).find("0 students here") != std::string::npos);
  CHECK(board(11.0).find("1 student here") != std::string::npos);
}

TEST_CASE("the teacher's address, right to the last sign, opens nothing from another computer") {
  SmallSite site;
  for (const auto& [method, path] : {std::pair{"GET", "/teacher/teachertoken22/"},
                                     {"GET", "/teacher/teachertoken22/events"},
                                     {"POST", "/teacher/teachertoken22/steer"}})
    CHECK(site.ask(method, path, R"({"do":"end"})", [](ClassRequest& r) { r.remote = "10.0.0.8"; }).status == 404);
  CHECK_FALSE(site.requests->ended());
  CHECK(site.ask("GET", "/teacher/teachertoken22/").status == 200);
}

TEST_CASE(
    "journal, attempts and report are for their owner alone, also in a folder that was there and is open to all") {
  ScratchFolder scratch;
  const fs::path folder = scratch.path / "c";
  fs::create_directories(folder);
  fs::permissions(folder, fs::perms::all);
  const auto store = ClassStore::begin(folder, {"abc234", "t", 7, 1, "now", {"/a/b.md", "first-touch"}, true});
  REQUIRE(store);
  const auto others = fs::perms::group_all | fs::perms::others_all;
  CHECK((fs::status(folder / "class.jsonl").permissions() & others) == fs::perms::none);
  CHECK((fs::status(folder / "attempts").permissions() & others) == fs::perms::none);
}

TEST_CASE("a class that goes on has the lessons and the share of its beginning, and is open until it was ended") {
  ScratchFolder scratch;
  const fs::path folder = scratch.path / "c";
  {
    const auto store = ClassStore::begin(folder, {"abc234", "t", 7, 1, "now", {"/a/b.md", "first-touch"}, true});
    REQUIRE(store);
    CHECK_FALSE(ClassStore::open(folder));
    ClassRoom room(smallLessons(), 7);
    (*store)->add(room.join("Ada", "x", 0.0)->record);
    REQUIRE_FALSE((*store)->commit((*store)->newest()));
    CHECK(ClassStore::open(folder));
  }
  const auto again = ClassStore::goOn(folder);
  REQUIRE(again);
  CHECK((*again)->identity().lessons == std::vector<std::string>{"/a/b.md", "first-touch"});
  CHECK((*again)->identity().share);
  (*again)->add(ClassRoom(smallLessons(), 7).end());
  REQUIRE_FALSE((*again)->commit((*again)->newest()));
  CHECK_FALSE(ClassStore::open(folder));
  CHECK_FALSE(ClassStore::open(scratch.path / "none"));
}

TEST_CASE("two classes never share a port, and a class that is stopped before it serves stops") {
  ClassServer first, second;
  const auto port = first.bind(false, 0);
  REQUIRE(port);
  CHECK_FALSE(second.bind(false, *port));
  const auto other = second.bind(false, 0);
  REQUIRE(other);
  CHECK(*other != *port);
  SmallSite site;
  CHECK(first.serve(*site.requests, [] { return true; }));
}

TEST_CASE("without the code there is nothing, with the code the page with its lessons, and a slash is added") {
  SmallSite site;
  for (const char* path : {"/", "/abc235/", "/abc23/", "/abc2345/", "/ABC234/", "/abc234x", "//abc234/", "/teacher/",
                           "/teacher/abc234/", "/teachertoken22/"})
    CHECK(site.ask("GET", path).status == 404);
  const ClassReply moved = site.ask("GET", "/abc234");
  CHECK(moved.status == 301);
  CHECK(moved.headers[0] == std::pair<std::string, std::string>("Location", "abc234/"));
  const ClassReply page = site.ask("GET", "/abc234/");
  REQUIRE(page.whole);
  CHECK(page.type == "text/html; charset=utf-8");
  CHECK(page.whole->find("id=\"class-facts\">{\"code\":\"abc234\"") != std::string::npos);
  CHECK(page.whole->find("Bumps </script>") == std::string::npos);
  CHECK(page.whole->find("Bumps \\u003c/script>\\u003c!--") != std::string::npos);
  CHECK(page.whole->find("<!--a lesson comes here-->") == std::string::npos);
  std::string tag;
  for (const auto& [name, value] : page.headers)
    if (name == "ETag") tag = value;
  CHECK(site.ask("GET", "/abc234/", "", [&](ClassRequest& r) { r.if_none_match = tag; }).status == 304);
  CHECK(*site.ask("GET", "/abc234/lesson/0").whole == "PACK");
  CHECK(site.ask("GET", "/abc234/lesson/1").status == 404);
}

TEST_CASE(
    "another host's name, another site's page, another method or kind of body is refused before anything is done") {
  SmallSite site;
  const std::string body = "{\"name\":\"Ada\"}";
  const auto status = [&](const std::function<void(ClassRequest&)>& change) {
    return site.ask("POST", "/abc234/join", body, change).status;
  };
  CHECK(status([](ClassRequest& r) { r.host = "evil.example:8230"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.host = ""; }) == 403);
  CHECK(status([](ClassRequest& r) { r.host = "127.0.0.1:8231"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.origin = "http://evil.example"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.origin = "null"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.origin = "https://127.0.0.1:8230"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.fetch_site = "cross-site"; }) == 403);
  CHECK(status([](ClassRequest& r) { r.content_type = "text/plain"; }) == 415);
  CHECK(status([](ClassRequest& r) { r.content_type = ""; }) == 415);
  CHECK(status([](ClassRequest& r) { r.method = "PUT"; }) == 405);
  CHECK(status([](ClassRequest& r) { r.body = std::string(kMaxClassBody + 1, ' '); }) == 413);
  CHECK(site.requests->students() == 0);
  CHECK(status([](ClassRequest& r) {
          r.host = "Laptop.Local:8230";
          r.origin = "http://laptop.local:8230";
          r.fetch_site = "same-origin";
          r.content_type = "application/json; charset=utf-8";
        }) == 200);
  CHECK(site.requests->students() == 1);
}

TEST_CASE("only the teacher's token steers: the code, a student's token and a wrong one do not") {
  SmallSite site;
  const std::string hold = R"({"do":"hold","lesson":"bumps","step":1})", token = site.join("Ada")["token"];
  for (const std::string& secret :
       {std::string("abc234"), token, std::string("teachertoken2"), std::string("teachertoken222"), std::string("x")})
    CHECK(site.ask("POST", "/teacher/" + secret + "/steer", hold).status == 404);
  CHECK(site.ask("POST", "/abc234/steer", hold).status == 404);
  CHECK(Json::parse(site.send(token, 0, {headerLine()}).body)["held"].empty());
  CHECK(site.ask("POST", "/teacher/teachertoken22/steer", hold).status == 200);
  CHECK(Json::parse(site.send(token, 1, {}).body)["held"] == Json{{"bumps", 1}});
  for (const char* broken :
       {"", "[]", "{}", R"({"do":"hold","lesson":"none","step":0})", R"({"do":"hold","lesson":"bumps","step":3})",
        R"({"do":"hold","lesson":"bumps","step":-1})", R"({"do":"hold","lesson":"bumps","step":"1"})"})
    CHECK(site.ask("POST", "/teacher/teachertoken22/steer", broken).status == 400);
  CHECK(site.ask("POST", "/teacher/teachertoken22/steer", R"({"do":"open","lesson":"bumps"})").status == 200);
  CHECK(Json::parse(site.send(token, 1, {}).body)["held"].empty());
  CHECK(site.ask("POST", "/teacher/teachertoken22/steer", R"({"do":"end"})").status == 200);
  CHECK(Json::parse(site.send(token, 1, {}).body)["ended"] == true);
  CHECK(site.ask("POST", "/abc234/join", "{}").status == 410);
  // Late work still arrives.
  CHECK(Json::parse(site.send(token, 1, {eventLine(1.0, StepEntered{"one"})}).body)["have"] == 2);
}

TEST_CASE("guesses of the code and of tokens are limited by address: 20 at once, then one in five seconds") {
  SmallSite site;
  int answered = 0;
  for (int k = 0; k < 100; ++k)
    answered +=
        site.ask("GET", "/guess" + std::to_string(k) + "/", "", [](ClassRequest& r) { r.now_s = 50.0; }).status == 404;
  CHECK(answered == 20);
  CHECK(site.ask("POST", "/abc234/lines", R"({"token":"guess"})", [](ClassRequest& r) { r.now_s = 50.0; }).status ==
        429);
  CHECK(site.ask("GET", "/guess/", "",
                 [](ClassRequest& r) {
                   r.now_s = 50.0;
                   r.remote = "10.0.0.8";
                 })
            .status == 404);
  CHECK(site.ask("GET", "/guess/", "", [](ClassRequest& r) { r.now_s = 56.0; }).status == 404);
  // Who knows the code is not held up by the guesses of others at the same address.
  CHECK(site.ask("GET", "/abc234/", "", [](ClassRequest& r) { r.now_s = 56.0; }).status == 200);
}

TEST_CASE("a student may ask 40 times at once and 10 times a second, without slowing another student down") {
  SmallSite site;
  const std::string ada = site.join("Ada")["token"], bo = site.join("Bo")["token"];
  const auto poll = [&](const std::string& token, double now_s) {
    return site.ask("POST", "/abc234/lines", Json{{"token", token}}.dump(), [&](ClassRequest& r) { r.now_s = now_s; })
        .status;
  };
  int answered = 0;
  for (int k = 0; k < 100; ++k) answered += poll(ada, 100.0) == 200;
  CHECK(answered == 40);
  CHECK(poll(bo, 100.0) == 200);
  answered = 0;
  for (int k = 0; k < 100; ++k) answered += poll(ada, 101.0) == 200;
  CHECK(answered == 10);
}

TEST_CASE(
    "no request names a file: paths and keys with .., slashes, escapes or zeros leave the class's folder as it is") {
  SmallSite site;
  const std::string token = site.join("../../etc/<b>")["token"];
  REQUIRE(site.send(token, 0, {headerLine()}).status == 200);
  for (const std::string& path :
       {std::string("/abc234/../../etc/passwd"), std::string("/abc234/lesson/../../x"),
        std::string("/abc234/lesson/0/.."), std::string("/abc234/%2e%2e/x"), std::string("/abc234/lesson/0\0", 17),
        std::string("/abc234/class.jsonl"), std::string("/teacher/teachertoken22/../class.jsonl"),
        std::string("/teacher/teachertoken22/attempts/student-001-1.jsonl"), "/abc234/" + std::string(300, 'a')})
    CHECK(site.ask("GET", path).status == 404);
  for (const std::string& key :
       {std::string("../x"), std::string("a/b"), std::string("/etc/x"), std::string("x.jsonl")})
    CHECK(site.send(token, 0, {headerLine()}, key).status == 400);
  REQUIRE(site.ask("GET", "/teacher/teachertoken22/report").status == 200);
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(site.scratch.path))
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), site.scratch.path).generic_string());
  std::sort(files.begin(), files.end());
  CHECK(files ==
        std::vector<std::string>{"class/attempts/student-001-1.jsonl", "class/class.jsonl", "class/report.html"});
  CHECK((fs::status(site.scratch.path / "class").permissions() & (fs::perms::group_all | fs::perms::others_all)) ==
        fs::perms::none);
}

TEST_CASE("a name with a script in it stands escaped on the teacher's page, in its events and in the report") {
  SmallSite site;
  const std::string token = site.join("<script>alert(1)</script>")["token"];
  site.send(token, 0, {headerLine(), eventLine(0.0, StepEntered{"one"}), eventLine(1.0, HintOpened{"one"})});
  const ClassReply page = site.ask("GET", "/teacher/teachertoken22/"),
                   report = site.ask("GET", "/teacher/teachertoken22/report");
  for (const std::string& html : {page.body, site.requests->liveParts(site.now_s), report.body}) {
    CHECK(html.find("<script>alert") == std::string::npos);
    CHECK(html.find("&lt;script&gt;alert(1)") != std::string::npos);
  }
  for (const ClassReply* reply : {&page, &report}) {
    const auto policy = std::find_if(reply->headers.begin(), reply->headers.end(),
                                     [](const auto& header) { return header.first == "Content-Security-Policy"; });
    REQUIRE(policy != reply->headers.end());
    CHECK(policy->second.starts_with("default-src 'none'"));
    CHECK(policy->second.find("script-src 'unsafe") == std::string::npos);
  }
}

TEST_CASE("what was acknowledged is there after a restart, even if the journal ends in half a record") {
  SmallSite site;
  const std::string token = site.join("Ada")["token"];
  CHECK(Json::parse(site.send(token, 0, {headerLine(), eventLine(0.0, StepEntered{"one"})}).body)["have"] == 2);
  site.requests.reset();
  site.store.reset();
  const fs::path journal = site.scratch.path / "class" / "class.jsonl";
  const std::string whole = bytesOf(journal);
  CHECK(whole.ends_with("}}\n"));
  writeFile(journal, whole + "{\"kind\":\"line\",\"student\":0,\"att");
  site.start();
  CHECK(bytesOf(journal) == whole);
  CHECK(Json::parse(site.send(token, 2, {eventLine(2.0, HintOpened{"one"})}).body)["have"] == 3);
  CHECK(Json::parse(site.send(token, 0, {headerLine(), eventLine(0.0, StepEntered{"one"})}).body)["have"] == 3);
  REQUIRE_FALSE(site.store->writeAttempts());
  const auto attempt = readAttempt(site.scratch.path / "class/attempts/student-001-1.jsonl");
  REQUIRE(attempt);
  CHECK(attempt->header.student == "Ada");
  CHECK(attempt->events.size() == 2);
  CHECK(attempt->problems.empty());
}

TEST_CASE(
    "a class that ended, stopped and goes on keeps all lines, also of a page that sends only its first two again") {
  SmallSite site;
  const std::string ada = site.join("Ada")["token"];
  std::vector<std::string> lines{headerLine()};
  for (int k = 1; k < 6; ++k) lines.push_back(eventLine(double(k), HintOpened{"one"}));
  REQUIRE(Json::parse(site.send(ada, 0, lines).body)["have"] == 6);
  site.ask("POST", "/teacher/teachertoken22/steer", R"({"do":"end"})");
  REQUIRE(site.requests->writeReport());
  const fs::path file = site.scratch.path / "class/attempts/student-001-1.jsonl";
  const std::string whole = bytesOf(file);
  CHECK(std::count(whole.begin(), whole.end(), '\n') == 6);
  site.start();
  CHECK(site.requests->ended());
  CHECK(Json::parse(site.send(ada, 0, {lines[0], lines[1]}).body)["have"] == 6);
  REQUIRE(site.requests->writeReport());
  CHECK(bytesOf(file) == whole);
}

TEST_CASE("an answer has the mark of the attempt's last line, by which a page sees that the lines are not its own") {
  SmallSite site;
  const std::string token = site.join("Ada")["token"];
  const std::vector<std::string> lines{headerLine(), eventLine(1.0, HintOpened{"one"}),
                                       "{\"kind\":\"x\",\"y\":\"\xC3\xBC\"}"};
  CHECK_FALSE(Json::parse(site.send(token, 0, {lines[0]}).body).contains("last"));
  CHECK(Json::parse(site.send(token, 1, {lines[1]}).body)["last"] == lineMark(lines[1]));
  CHECK(Json::parse(site.send(token, 2, {lines[2]}).body)["last"] == lineMark(lines[2]));
  // In part new: refused with the mark; what is there stays.
  const ClassReply reply = site.send(token, 2, {eventLine(2.0, HintOpened{"one"}), eventLine(3.0, HintOpened{"one"})});
  CHECK(reply.status == 409);
  CHECK(Json::parse(reply.body)["have"] == 3);
  CHECK(Json::parse(reply.body)["last"] == lineMark(lines[2]));
  site.start();
  CHECK(Json::parse(site.send(token, 0, {}).body)["last"] == lineMark(lines[2]));
  // Published values of FNV-1a, 32 bits.
  CHECK(lineMark("") == 0x811c9dc5U);
  CHECK(lineMark("a") == 0xe40c292cU);
  CHECK(lineMark("foobar") == 0xbf9cf968U);
}

TEST_CASE("40 students who send at once get their lines acknowledged and on the disk, each in order") {
  SmallSite site;
  constexpr std::size_t kStudents = 40, kLines = 30;
  std::vector<std::string> tokens;
  for (std::size_t k = 0; k < kStudents; ++k) tokens.push_back(site.join("")["token"]);
  std::vector<std::thread> threads;
  std::atomic<int> refused{0};
  for (std::size_t k = 0; k < kStudents; ++k)
    threads.emplace_back([&, k] {
      for (std::size_t n = 0; n < kLines; ++n) {
        ClassRequest request;
        request.method = "POST";
        request.path = "/abc234/lines";
        request.host = "127.0.0.1:8230";
        request.content_type = "application/json";
        request.now_s = 1000.0 + double(n);
        const std::string line = n == 0 ? headerLine() : eventLine(double(n), HintOpened{"one"});
        request.body = Json{{"token", tokens[k]}, {"attempt", "a"}, {"from", n}, {"lines", {line}}}.dump();
        const ClassReply reply = site.requests->answer(request);
        if (reply.status != 200 || Json::parse(reply.body)["have"] != n + 1) ++refused;
      }
    });
  for (std::thread& one : threads) one.join();
  CHECK(refused == 0);
  REQUIRE_FALSE(site.store->writeAttempts());
  for (std::size_t k = 0; k < kStudents; ++k) {
    char name[40];
    std::snprintf(name, sizeof name, "student-%03zu-1.jsonl", k + 1);
    const auto attempt = readAttempt(site.scratch.path / "class/attempts" / name);
    REQUIRE(attempt);
    REQUIRE(attempt->events.size() == kLines - 1);
    for (std::size_t n = 1; n < kLines; ++n) CHECK(attempt->events[n - 1].t_s == double(n));
  }
}

TEST_CASE("bodies that are no JSON, or JSON of other shapes, are answered with 400 and change nothing") {
  SmallSite site;
  const std::string token = site.join("Ada")["token"];
  for (const std::string& body : {std::string(), std::string("{"), std::string("[]"), std::string("null"),
                                  std::string("\"x\""), std::string(100000, '['), std::string("{\"token\":1}"),
                                  Json{{"token", token}, {"attempt", "a"}, {"from", 0}, {"lines", {1, 2}}}.dump(),
                                  Json{{"token", token}, {"attempt", "a"}, {"from", 0}, {"lines", {"x"}}}.dump()})
    CHECK(site.ask("POST", "/abc234/lines", body).status == 400);
  CHECK(site.ask("POST", "/abc234/lines",
                 Json{{"token", token}, {"attempt", "a"}, {"from", 9}, {"lines", {headerLine()}}}.dump())
            .status == 409);
  CHECK(site.requests->liveParts(1.0).find("Bumps") != std::string::npos);
  CHECK(site.requests->students() == 1);
}

TEST_CASE("a page that is no browser edition of this version is refused with a remedy") {
  ScratchFolder scratch;
  auto store = ClassStore::begin(scratch.path / "c", {"abc234", "t", 7, 1, "now"});
  REQUIRE(store);
  for (const char* page : {"", "<html></html>", "<!--a lesson comes here-->"}) {
    ClassSite site;
    site.page = page;
    const auto made = ClassRequests::make(std::move(site), ClassRoom({}, 1), **store);
    REQUIRE_FALSE(made);
    CHECK_FALSE(made.problem().remedy.empty());
  }
}

}  // namespace
}  // namespace moltact
