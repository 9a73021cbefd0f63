// All requests of a live class: methods, paths, headers and bodies, well formed and not, one after the other in one class.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/classroom/class_requests.h"
#include "engine/core/random.h"
#include "tests/classroom/small_class.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr const char* kTokens[] = {"first-student", "second-student", "nobody", ""};

// In memory where the system allows; empty at the start of each run.
fs::path classFolder() {
  std::error_code error;
  const fs::path memory = "/dev/shm";
  fs::path out = (fs::is_directory(memory, error) ? memory : fs::temp_directory_path()) /
                 ("moltact-fuzz-class-" + std::to_string(::getpid()));
  fs::remove_all(out, error);
  return out;
}

std::string rawText(Choices& choices, std::size_t most) {
  std::string out;
  for (std::size_t n = choices.pick(most); n > 0 && choices.more(); --n) out += char(choices.pick(256));
  return out;
}

std::string path(Choices& choices) {
  static constexpr const char* kPaths[] = {"/abc234/lines",
                                           "/abc234/join",
                                           "/teacher/t22/steer",
                                           "/abc234/",
                                           "/abc234/lesson/0",
                                           "/abc234/board",
                                           "/abc234/board.js",
                                           "/abc234/scene",
                                           "/teacher/t22/",
                                           "/teacher/t22/events",
                                           "/teacher/t22/report",
                                           "/teacher/t22/class.js",
                                           "/abc234",
                                           "/",
                                           "/abc234/../x",
                                           "/teacher/",
                                           ""};
  const std::size_t which = choices.pick(std::size(kPaths) + 2);
  if (which < std::size(kPaths)) return kPaths[which];
  return (which == std::size(kPaths) ? "/abc234/" : "/") + rawText(choices, 40);
}

// A line of an attempt, or something like one.
std::string line(Choices& choices) {
  const double t_s = choices.pick(50) ? double(choices.pick(1000)) / 8.0 : 1e300;
  const char* const steps[] = {"one", "two", "three", "none"};
  const std::string step = steps[choices.pick(4)];
  switch (choices.pick(12)) {
    case 0:
      return test::headerLine();
    case 1:
      return test::eventLine(t_s, StepEntered{step});
    case 2:
      return test::eventLine(t_s, HintOpened{step});
    case 3:
      return test::eventLine(t_s, Answered{step,
                                           choices.pick(2) ? "which" : "expect",
                                           1,
                                           {choices.pick(5)},
                                           rawText(choices, 20),
                                           choices.pick(2) > 0,
                                           InputKind::Mouse});
    case 4:
      return test::eventLine(t_s, TaskDone{step, choices.pick(4), 1.0, InputKind::Mouse, {}, true});
    case 5:
      return test::eventLine(t_s, CurveKept{step,
                                            choices.pick(3),
                                            false,
                                            "depth",
                                            double(choices.pick(9)),
                                            double(choices.pick(9)),
                                            {0.0, double(choices.pick(99))}});
    case 6: {
      LessonOutline other = test::smallOutline();
      other.steps.resize(choices.pick(4));
      return test::eventLine(t_s, LessonReread{other});
    }
    case 7:
      return test::eventLine(t_s, ProgressMade{step, choices.pick(9), choices.pick(9)});
    case 8:
      return "{\"kind\":\"step\",\"t\":" + std::string(oddNumber(choices)) + ",\"step\":\"one\"}";
    case 9:
      return "{\"kind\":\"still\",\"t\":" + std::string(oddNumber(choices)) + "}";
    case 10:
      return "{" + rawText(choices, 60) + "}";
    default:
      return rawText(choices, 60);
  }
}

std::string body(Choices& choices) {
  switch (choices.pick(11)) {
    case 9: {
      Json out{{"do", choices.pick(4) ? "ask scene" : "end scene"}, {"student", choices.pick(4)}};
      return out.dump();
    }
    case 10: {
      Json out{{"token", kTokens[choices.pick(4)]}, {"scene", choices.pick(4)}, {"step", choices.pick(4)}};
      out["lesson"] = choices.pick(9) ? "bumps" : "none";
      constexpr const char* kSays[] = {"yes", "no", "stop", "?"};
      if (choices.pick(3)) {
        out["say"] = kSays[choices.pick(4)];
        out["named"] = choices.pick(2) > 0;
      }
      // A JPEG of 2 x 2 pixels up to the frame's header, and its end.
      constexpr const char* kJpeg = "/9j/wAALCAACAAIBAREA/9k=";
      if (choices.pick(2)) out["picture"] = choices.pick(3) ? kJpeg : rawText(choices, 40);
      return out.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    case 0:
      return rawText(choices, 200);
    case 1:
      return Json{{"name", rawText(choices, 60)}}.dump(-1, ' ', false, Json::error_handler_t::replace);
    case 2:
      return Json{{"do", choices.pick(2) ? "hold" : "open"}, {"lesson", "bumps"}, {"step", choices.pick(5)}}.dump();
    case 3:
      return R"({"do":"end"})";
    case 4: {
      Json out{{"do", choices.pick(5) ? "show" : "hide"}, {"lesson", choices.pick(9) ? "bumps" : "none"}};
      out["step"] = choices.pick(5);
      out[choices.pick(2) ? "question" : "task"] = choices.pick(4);
      return out.dump();
    }
    default: {
      Json out{{"token", kTokens[choices.pick(4)]}, {"from", choices.pick(20)}, {"lines", Json::array()}};
      if (choices.pick(6)) out["attempt"] = choices.pick(5) ? "a" : rawText(choices, 12);
      for (std::size_t n = choices.pick(6); n > 0; --n) out["lines"].push_back(line(choices));
      return out.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
  }
}

}  // namespace

void classRequests(std::string_view bytes) {
  Choices choices(bytes);
  const fs::path folder = classFolder();
  auto store = ClassStore::begin(folder, {"abc234", "t22", 7, 8230, "2026-11-21T10:00:00Z"});
  mustBe(bool(store), "a folder");
  ClassRoom room(test::smallLessons(), 7);
  for (const char* token : {kTokens[0], kTokens[1]}) (*store)->add(room.join("", token, 0.0)->record);
  ClassSite site;
  site.page = "<script id=\"classroom-script\"></script><!--a lesson comes here-->";
  site.lessons = {{"bumps", "Bumps", std::make_shared<const std::string>("PACK")}};
  site.hosts = {"127.0.0.1:8230"};
  site.random = [seed = std::uint64_t{1}](std::size_t n) mutable {
    std::string out;
    for (std::size_t k = 0; k < n; ++k) out += char(nextRandom(seed) >> 33);
    return out;
  };
  auto requests = ClassRequests::make(std::move(site), std::move(room), **store);
  mustBe(bool(requests), "a page");
  constexpr std::array kStatuses{200, 301, 304, 400, 403, 404, 405, 409, 410, 413, 415, 429, 507};
  for (int n = 0; n < 40 && choices.more(); ++n) {
    ClassRequest request;
    request.method = choices.pick(8) ? (choices.pick(4) ? "POST" : "GET") : rawText(choices, 5);
    request.path = path(choices);
    request.host = choices.pick(12) ? "127.0.0.1:8230" : rawText(choices, 20);
    request.content_type = choices.pick(12) ? "application/json" : rawText(choices, 20);
    if (!choices.pick(12)) request.origin = rawText(choices, 20);
    request.remote = choices.pick(3) ? "127.0.0.1" : "10.0.0.7";
    if (request.method == "POST") request.body = body(choices);
    request.now_s = double(n);
    const ClassReply reply = (*requests)->answer(request);
    mustBe(std::find(kStatuses.begin(), kStatuses.end(), reply.status) != kStatuses.end(), "a known status");
    if (reply.type == "application/json") mustBe(Json::accept(reply.body), "JSON");
    for (const auto& [name, value] : reply.headers)
      mustBe(value.find_first_of("\r\n") == std::string::npos, "headers of one line");
  }
  const std::string parts = (*requests)->liveParts(50.0);
  mustBe(Json::accept(parts), "JSON for the teacher's page");
  mustBe(parts.find("<script") == std::string::npos, "no script");
  const std::size_t students = (*requests)->students();
  mustBe(!(*store)->commit((*store)->newest()) && !(*store)->writeAttempts(), "a journal on the disk");
  // What a restart makes of it is the same.
  ClassRoom again(test::smallLessons(), 7);
  (*store)->forEachRecord([&](std::string_view record) { mustBe(again.restore(record), "a record"); });
  mustBe(again.students().size() == students, "the same students");
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    mustBe(name == "attempts" || name == "class.jsonl" || name == "report.html" ||
               (name.starts_with("student-") && name.ends_with(".jsonl")),
           "no other file");
  }
}

}  // namespace moltact::fuzz
