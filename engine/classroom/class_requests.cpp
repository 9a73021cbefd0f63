#include "engine/classroom/class_requests.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "engine/classroom/live_page.h"
#include "engine/classroom/scene_picture.h"
#include "engine/classroom/secrets.h"
#include "engine/core/content_hash.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/platform/write_file.h"
#include "engine/results/class_files.h"
#include "engine/results/class_page.h"

namespace moltact {
namespace {

using RequestJson = nlohmann::ordered_json;

constexpr RateLimit kStudentRate{40.0, 10.0};
constexpr double kBoardFor_s = 1.0;
// Pictures of a scene that computers other than this one get, all together.
constexpr RateLimit kSceneLooks{20.0, 10.0};
constexpr std::size_t kStudentToken = 26, kMaxLinesOfRequest = 5000;

// The marker in app/web/page.html, behind which the page's scripts stand.
constexpr std::string_view kPageMarker = "<!--a lesson comes here-->", kClassScript = "id=\"classroom-script\"";

// What the program needs: its own scripts and style in the page, WebAssembly, workers and pictures made in the page. It may
// speak to this server only.
constexpr const char* kStudentPolicy =
    "default-src 'none'; script-src 'unsafe-inline' 'wasm-unsafe-eval' blob:; style-src 'unsafe-inline'; "
    "img-src data: blob:; connect-src 'self'; worker-src blob:; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";
constexpr const char* kTeacherPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; base-uri 'none'; "
    "form-action 'none'; frame-ancestors 'none'";
constexpr const char* kReportPolicy =
    "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

// The projector's page with a student's scene: its own script fetches the pictures.
constexpr const char* kScenePolicy =
    "default-src 'none'; script-src 'self'; style-src 'unsafe-inline'; connect-src 'self'; img-src blob:; base-uri "
    "'none'; form-action 'none'; frame-ancestors 'none'";

ClassReply plainReply(int status, std::string text) {
  ClassReply out;
  out.status = status;
  out.body = std::move(text);
  return out;
}

ClassReply htmlReply(std::string html, const char* policy) {
  ClassReply out;
  out.type = "text/html; charset=utf-8";
  out.body = std::move(html);
  out.headers.emplace_back("Content-Security-Policy", policy);
  return out;
}

ClassReply jsonReply(int status, const RequestJson& json) {
  ClassReply out;
  out.status = status;
  out.type = "application/json";
  out.body = json.dump(-1, ' ', false, RequestJson::error_handler_t::replace);
  return out;
}

ClassReply nothingHere() {
  return plainReply(404, tr("There is nothing here. The address of a class has its code at the end."));
}
ClassReply tooOften() { return plainReply(429, tr("Too many requests; wait a moment.")); }

// JSON that stands in a page between script tags.
std::string inPage(const RequestJson& json) {
  std::string out;
  for (const char c : json.dump(-1, ' ', true, RequestJson::error_handler_t::replace))
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

std::optional<std::string> textOf(const RequestJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? std::optional(found->get<std::string>()) : std::nullopt;
}

std::optional<std::size_t> numberOf(const RequestJson& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_number_unsigned() ? std::optional(found->get<std::size_t>()) : std::nullopt;
}

ShownPlot shownPlot(const RequestJson& body, const std::string& lesson) {
  const bool curve = body.contains("task");
  constexpr std::size_t kNone = ~std::size_t{0};
  return {lesson, numberOf(body, "step").value_or(kNone), numberOf(body, curve ? "task" : "question").value_or(kNone),
          curve};
}

bool isThisComputer(const std::string& remote) { return remote.starts_with("127.") || remote == "::1"; }

RequestJson objectOf(const std::string& body) {
  RequestJson json = RequestJson::parse(body, nullptr, false);
  return json.is_object() ? json : RequestJson();
}

}  // namespace

Expected<std::unique_ptr<ClassRequests>> ClassRequests::make(ClassSite site, ClassRoom room, ClassStore& store) {
  const std::size_t marker = site.page.find(kPageMarker);
  if (marker == std::string::npos || site.page.find(kClassScript) == std::string::npos)
    return Problem{{},
                   0,
                   0,
                   tr("it is no page of this version's browser edition, or holds a lesson already"),
                   tr("name the moltact.html that './run.sh web' made or that came with the program")};
  RequestJson facts{{"code", store.identity().code}, {"language", language()}, {"lessons", RequestJson::array()}};
  for (const ServedLesson& lesson : site.lessons)
    facts["lessons"].push_back({{"id", lesson.id}, {"title", lesson.title}});
  std::string page = std::move(site.page);
  page.replace(marker, kPageMarker.size(),
               "<script type=\"application/json\" id=\"class-facts\">" + inPage(facts) + "</script>");
  std::unique_ptr<ClassRequests> out(new ClassRequests(std::move(site), std::move(room), store));
  out->page_tag_ = '"' + contentHash(page) + '"';
  out->page_ = std::make_shared<const std::string>(std::move(page));
  out->student_rates_.resize(out->room_.students().size());
  if (out->room_.shown()) out->board_plot_ = boardPlotOf(out->room_, *out->room_.shown());
  return out;
}

std::optional<ClassReply> ClassRequests::refused(const ClassRequest& request) {
  // A page of another site whose name was bound to this address (DNS rebinding) has its own name here.
  const auto known = [&](std::string_view host) {
    return std::any_of(site_.hosts.begin(), site_.hosts.end(), [&](const std::string& one) { return one == host; });
  };
  const std::string host = lower(request.host);
  if (!known(host)) return plainReply(403, tr("This computer does not serve that address."));
  if (request.path.empty() || request.path.size() > kMaxClassPath) return nothingHere();
  if (request.method == "GET") return std::nullopt;
  if (request.method != "POST") return plainReply(405, tr("Only GET and POST are accepted here."));
  if (!request.origin.empty() && lower(request.origin) != "http://" + host)
    return plainReply(403, tr("Another site may not write here."));
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin")
    return plainReply(403, tr("Another site may not write here."));
  if (!lower(request.content_type).starts_with("application/json"))
    return plainReply(415, tr("Only JSON is accepted here."));
  return std::nullopt;
}

ClassReply ClassRequests::answer(const ClassRequest& request) {
  if (auto reply = refused(request)) return *std::move(reply);
  if (request.body.size() > kMaxClassBody) return plainReply(413, tr("That is too much at once."));
  // "/FIRST/REST", and for the teacher "/teacher/FIRST/REST".
  std::string_view path = request.path;
  path.remove_prefix(1);
  constexpr std::string_view kTeacher = "teacher/";
  const bool teacher = path.starts_with(kTeacher);
  // The teacher's address is of this computer only, so that its token in a photograph opens nothing.
  if (teacher && !isThisComputer(request.remote)) return nothingHere();
  if (teacher) path.remove_prefix(kTeacher.size());
  const std::size_t slash = path.find('/');
  const std::string_view secret = path.substr(0, slash);
  const ClassIdentity& identity = store_.identity();
  if (!sameSecret(teacher ? identity.teacher : identity.code, secret)) {
    const std::lock_guard held(lock_);
    return secret.empty() || guesses_.take(request.remote, request.now_s) ? nothingHere() : tooOften();
  }
  if (slash == std::string_view::npos) {
    // A relative address, so that nothing of the request stands in the header.
    ClassReply out = plainReply(301, {});
    out.headers.emplace_back("Location", (teacher ? identity.teacher : identity.code) + "/");
    return out;
  }
  path.remove_prefix(slash + 1);
  return teacher ? teacherAnswer(path, request) : studentAnswer(path, request);
}

// ---- students --------------------------------------------------------------------------------------------------------

ClassReply ClassRequests::studentAnswer(std::string_view path, const ClassRequest& request) {
  if (request.method == "POST") {
    if (path == "join") return join(request);
    if (path == "lines") return takeLines(request);
    if (path == "scene") return takeScene(request);
    return nothingHere();
  }
  if (path.empty()) {
    ClassReply out = htmlReply({}, kStudentPolicy);
    out.headers.emplace_back("ETag", page_tag_);
    if (request.if_none_match == page_tag_)
      out.status = 304;
    else
      out.whole = page_;
    return out;
  }
  if (path == "board") return board(request);
  if (path == "scene") return giveScene(request);
  if (path == "board.js") {
    ClassReply out;
    out.type = "text/javascript; charset=utf-8";
    out.body = boardScript();
    return out;
  }
  for (std::size_t k = 0; k < site_.lessons.size(); ++k)
    if (path == "lesson/" + std::to_string(k)) {
      ClassReply out;
      out.type = "application/octet-stream";
      out.whole = site_.lessons[k].pack;
      return out;
    }
  return nothingHere();
}

ClassReply ClassRequests::board(const ClassRequest& request) {
  // Everyone who has the code may ask for it at any rate, so that it is made once in a second.
  const std::lock_guard held(lock_);
  scene_.follow(room_, request.now_s);
  const bool scene = scene_.state() == SharedScene::State::Agreed;
  if (board_.empty() || board_scene_ != scene || request.now_s - board_at_s_ >= kBoardFor_s) {
    const TeacherPageFacts facts{site_.address, site_.shared};
    const std::size_t here = studentsHere(room_, request.now_s);
    const std::string name = scene && scene_.named() ? room_.students()[scene_.student()].name : std::string();
    board_ = scene ? boardScenePage(facts, here, name) : boardPage(facts, here, board_plot_);
    board_scene_ = scene;
    board_at_s_ = request.now_s;
  }
  return htmlReply(board_, scene ? kScenePolicy : kReportPolicy);
}

// The present picture; 404 if nobody shows a scene, 409 with a sentence if it is not shown now.
ClassReply ClassRequests::giveScene(const ClassRequest& request) {
  const std::lock_guard held(lock_);
  scene_.follow(room_, request.now_s);
  if (scene_.state() != SharedScene::State::Agreed) return nothingHere();
  if (!isThisComputer(request.remote) && !scene_looks_.take(kSceneLooks, request.now_s)) return tooOften();
  std::size_t waiting = 0;
  const SceneHidden hidden = scene_.hidden(room_, request.now_s, waiting);
  if (hidden != SceneHidden::No) return plainReply(409, sceneHiddenText(hidden));
  ClassReply out;
  const std::string tag = '"' + std::to_string(scene_.number()) + '-' + std::to_string(scene_.pictures()) + '"';
  out.headers.emplace_back("ETag", tag);
  out.type = "image/jpeg";
  if (request.if_none_match == tag)
    out.status = 304;
  else
    out.body = scene_.picture();
  return out;
}

// A student's answer to the question whether the class may see the scene, the end of showing it, and pictures of it.
ClassReply ClassRequests::takeScene(const ClassRequest& request) {
  if (request.body.size() > kMaxSceneBody) return plainReply(413, tr("That is too much at once."));
  const RequestJson body = objectOf(request.body);
  const auto token = textOf(body, "token"), say = textOf(body, "say"), lesson = textOf(body, "lesson"),
             picture = textOf(body, "picture");
  const auto number = numberOf(body, "scene"), step = numberOf(body, "step");
  std::optional<std::string> bytes;
  if (picture) bytes = fromBase64(*picture);
  if (!token || !number || (!say && !picture)) return plainReply(400, tr("The request cannot be read."));
  if (picture && (!bytes || (!bytes->empty() && !isSmallJpeg(*bytes))))
    return plainReply(400, tr("The request cannot be read."));
  const ScenePlace place{lesson.value_or(""), step.value_or(~std::size_t{0})};
  const std::lock_guard held(lock_);
  const auto student = room_.studentOf(*token);
  if (!student) {
    if (!guesses_.take(request.remote, request.now_s)) return tooOften();
    return jsonReply(403, {{"unknown", true}});
  }
  if (!student_rates_[*student].take(kStudentRate, request.now_s)) return tooOften();
  room_.seen(*student, request.now_s);
  scene_.follow(room_, request.now_s);
  bool open = true;
  if (picture) {
    const SharedScene::Taken taken = scene_.take(*student, *number, place, *std::move(bytes), request.now_s);
    if (taken == SharedScene::Taken::TooOften) return tooOften();
    open = taken == SharedScene::Taken::Yes;
  } else if (*say == "yes" || *say == "no") {
    const auto named = body.find("named");
    open = scene_.answer(*student, *number, *say == "yes", named != body.end() && *named == true, place);
  } else {
    open = *say == "stop" && scene_.withdraw(*student, *number);
  }
  return open ? jsonReply(200, {{"scene", *number}}) : jsonReply(410, {{"over", true}});
}

ClassReply ClassRequests::join(const ClassRequest& request) {
  const RequestJson body = objectOf(request.body);
  if (!body.is_object()) return plainReply(400, tr("The request cannot be read."));
  std::uint64_t ticket = 0;
  RequestJson reply;
  {
    const std::lock_guard held(lock_);
    if (!joins_.take(request.remote, request.now_s)) return tooOften();
    if (room_.ended()) return jsonReply(410, {{"ended", true}});
    const auto joined =
        room_.join(textOf(body, "name").value_or(""), secretText(kStudentToken, site_.random), request.now_s);
    if (!joined) return jsonReply(409, {{"full", true}});
    student_rates_.resize(room_.students().size());
    const LiveStudent& student = room_.students()[joined->student];
    reply = {{"name", student.name}, {"token", student.token}, {"number", joined->student + 1}};
    ticket = store_.add(joined->record);
  }
  if (store_.commit(ticket)) return plainReply(503, tr("The class's disk takes nothing now."));
  return jsonReply(200, reply);
}

ClassReply ClassRequests::takeLines(const ClassRequest& request) {
  const RequestJson body = objectOf(request.body);
  const auto token = textOf(body, "token");
  std::vector<std::string> lines;
  if (const auto sent = body.find("lines");
      sent != body.end() && sent->is_array() && sent->size() <= kMaxLinesOfRequest)
    for (const RequestJson& line : *sent) {
      if (!line.is_string()) return plainReply(400, tr("The request cannot be read."));
      lines.push_back(line.get<std::string>());
    }
  if (!token) return plainReply(400, tr("The request cannot be read."));
  std::uint64_t ticket = 0;
  RequestJson reply{{"ended", false}, {"held", RequestJson::object()}};
  int status = 200;
  {
    const std::lock_guard held(lock_);
    const auto student = room_.studentOf(*token);
    if (!student) {
      if (!guesses_.take(request.remote, request.now_s)) return tooOften();
      return jsonReply(403, {{"unknown", true}});
    }
    if (!student_rates_[*student].take(kStudentRate, request.now_s)) return tooOften();
    room_.seen(*student, request.now_s);
    reply["ended"] = room_.ended();
    for (const auto& [lesson, step] : room_.held()) reply["held"][lesson] = step;
    scene_.follow(room_, request.now_s);
    if (scene_.state() != SharedScene::State::None && scene_.student() == *student)
      reply["scene"] = {{scene_.state() == SharedScene::State::Asked ? "ask" : "show", scene_.number()}};
    if (const auto attempt = textOf(body, "attempt")) {
      ClassRoom::Taken taken = room_.take(*student, *attempt, numberOf(body, "from").value_or(0), lines, request.now_s);
      reply["have"] = taken.have;
      if (const auto mark = room_.lastMark(*student, *attempt)) reply["last"] = *mark;
      using Refused = ClassRoom::Refused;
      if (taken.refused == Refused::Gap) status = 409;
      if (taken.refused == Refused::Broken) status = 400;
      if (taken.refused == Refused::Full) status = 507;
      store_.add(taken.records);
      // Also lines that came before: their first answer may have been lost before the disk had them.
      ticket = store_.newest();
    }
  }
  if (ticket && store_.commit(ticket)) return plainReply(503, tr("The class's disk takes nothing now."));
  return jsonReply(status, reply);
}

// ---- the teacher -----------------------------------------------------------------------------------------------------

ClassReply ClassRequests::teacherAnswer(std::string_view path, const ClassRequest& request) {
  if (request.method == "POST") return path == "steer" ? steer(request) : nothingHere();
  ClassReply out;
  if (path.empty()) {
    const std::lock_guard held(lock_);
    return htmlReply(teacherPage(view(request.now_s), {site_.address, site_.shared}), kTeacherPolicy);
  }
  if (path == "class.css") {
    out.type = "text/css; charset=utf-8";
    out.body = teacherStyle();
  } else if (path == "class.js") {
    out.type = "text/javascript; charset=utf-8";
    out.body = teacherScript();
  } else if (path == "events") {
    out.type = "text/event-stream";
    out.events = true;
  } else if (path == "report") {
    Expected<std::string> page = writeReport();
    if (!page) return plainReply(503, page.problem().text());
    if (page->empty()) return plainReply(200, tr("Nobody has begun a lesson yet."));
    return htmlReply(*std::move(page), kReportPolicy);
  } else {
    return nothingHere();
  }
  return out;
}

std::string ClassRequests::show(const ShownPlot& plot) {
  BoardPlot shown = boardPlotOf(room_, plot);
  std::string record = shown.empty() ? std::string() : room_.show(plot);
  if (!record.empty()) board_plot_ = std::move(shown);
  return record;
}

std::string ClassRequests::hide() {
  board_plot_ = {};
  return room_.hide();
}

// Nothing of it is on the disk: after a restart no scene is shown.
bool ClassRequests::steerScene(const std::string& act, std::size_t student, double now_s) {
  scene_.follow(room_, now_s);
  return act == "ask scene" ? scene_.ask(room_, student, now_s) : scene_.takeOff();
}

ClassReply ClassRequests::steer(const ClassRequest& request) {
  const RequestJson body = objectOf(request.body);
  const std::string act = textOf(body, "do").value_or(""), lesson = textOf(body, "lesson").value_or("");
  std::uint64_t ticket = 0;
  {
    const std::lock_guard held(lock_);
    std::string record;
    if (act == "ask scene" || act == "end scene") {
      board_.clear();
      return steerScene(act, numberOf(body, "student").value_or(kMaxStudents), request.now_s)
                 ? jsonReply(200, {{"done", act}})
                 : plainReply(400, tr("The request cannot be read."));
    }
    if (act == "hold")
      record = room_.hold(lesson, numberOf(body, "step").value_or(~std::size_t{0}));
    else if (act == "open")
      record = room_.open(lesson);
    else if (act == "show")
      record = show(shownPlot(body, lesson));
    else if (act == "hide")
      record = hide();
    else if (act == "end")
      record = room_.end();
    if (record.empty()) return plainReply(400, tr("The request cannot be read."));
    ticket = store_.add(record);
    board_.clear();
  }
  if (store_.commit(ticket)) return plainReply(503, tr("The class's disk takes nothing now."));
  return jsonReply(200, {{"done", act}});
}

Expected<std::string> ClassRequests::writeReport() {
  if (const auto problem = store_.commit(store_.newest())) return *problem;
  if (const auto problem = store_.writeAttempts()) return *problem;
  const std::vector<std::filesystem::path> folder{store_.attemptsFolder()};
  const ClassReading reading = readClass(folder);
  if (reading.summary.attempts == 0) return std::string();
  const std::string now = utcText(std::chrono::system_clock::now());
  std::string page =
      classPage(reading.summary, reading.passed_over, now.substr(0, 10) + " " + now.substr(11, 5) + " UTC");
  if (const auto problem = writeWhole(reportFile(), page, IfThere::Renew)) return *problem;
  std::error_code error;
  std::filesystem::permissions(reportFile(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_write,
                               error);
  return page;
}

// Under the lock.
ClassView ClassRequests::view(double now_s) const {
  ClassView out = viewOf(room_, now_s);
  scene_.follow(room_, now_s);
  addScene(out, room_, scene_, now_s);
  return out;
}

std::string ClassRequests::liveParts(double now_s) const {
  RequestJson out;
  const std::lock_guard held(lock_);
  for (auto& [id, html] : teacherParts(view(now_s))) out[id] = std::move(html);
  return out.dump(-1, ' ', false, RequestJson::error_handler_t::replace);
}

ClassView ClassRequests::shownView(double now_s) const {
  const std::lock_guard held(lock_);
  return view(now_s);
}

bool ClassRequests::steerHere(std::string body, double now_s) {
  ClassRequest request;
  request.body = std::move(body);
  request.now_s = now_s;
  return steer(request).status == 200;
}

bool ClassRequests::ended() const {
  const std::lock_guard held(lock_);
  return room_.ended();
}

std::size_t ClassRequests::students() const {
  const std::lock_guard held(lock_);
  return room_.students().size();
}

}  // namespace moltact
