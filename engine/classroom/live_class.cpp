#include "engine/classroom/live_class.h"

#include <chrono>
#include <memory>
#include <utility>

#include "engine/classroom/class_server.h"
#include "engine/classroom/qr_code.h"
#include "engine/classroom/secrets.h"
#include "engine/core/content_hash.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_lesson.h"
#include "engine/pack/pack_page.h"
#include "engine/pack/unpack.h"
#include "engine/platform/folders.h"
#include "engine/platform/local_addresses.h"
#include "engine/platform/random_bytes.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kCodeSigns = 8, kTeacherSigns = 26, kMaxClassLessons = 60;

struct ChosenLessons {
  std::vector<ClassLesson> outlines;
  std::vector<ServedLesson> served;
};

// Kinds of tasks that ask what is felt, mostly in the dark (TaskStage::unnamed).
bool isUnseenKind(std::string_view kind) {
  return kind == "find" || kind == "order" || kind == "rank" || kind == "same";
}

std::vector<ClassStep> classSteps(const Lesson& lesson) {
  std::vector<ClassStep> out;
  for (const Step& step : lesson.steps) {
    ClassStep& made = out.emplace_back();
    for (const TaskSpec& task : step.tasks)
      made.unseen_tasks.push_back(char(isUnseenKind(task.kind) || step.scene.hide.given()));
    for (const Question& asked : step.questions) made.tries.push_back(asked.attempts);
  }
  return out;
}

std::optional<Problem> addOutline(const fs::path& file, std::vector<ClassLesson>& into) {
  LessonReading reading = readLesson(file);
  if (!reading.lesson) return reading.errors.front();
  const Expected<std::string> bytes = readLessonFile(file);
  into.push_back({lessonName(file).id, outlineOf(*reading.lesson, bytes ? contentHash(*bytes) : std::string()),
                  classSteps(*reading.lesson)});
  return std::nullopt;
}

// A file, or the name of a lesson of the program.
fs::path lessonFileOf(const std::string& named) {
  std::error_code error;
  if (fs::exists(named, error) || named.find_first_of("/\\.") != std::string::npos) return named;
  return lessonsFolder() / (named + ".md");
}

// The same lesson for a command in another folder.
std::string lastingName(const std::string& named) {
  std::error_code error;
  return fs::exists(named, error) ? fs::absolute(named, error).string() : named;
}

Expected<ChosenLessons> chosenLessons(const std::vector<std::string>& named,
                                      const std::function<void(const std::string&)>& note) {
  ChosenLessons out;
  if (named.empty()) {
    for (const fs::path& file : inLanguage(lessonsIn(lessonsFolder()).lessons, language()))
      (void)addOutline(file, out.outlines);
    return out;
  }
  if (named.size() > kMaxClassLessons)
    return Problem{{}, 0, 0, trf("a class has at most {0} lessons", kMaxClassLessons), tr("name fewer")};
  for (const std::string& one : named) {
    const fs::path file = lessonFileOf(one);
    std::string pack;
    std::optional<Problem> problem;
    if (lower(file.extension().string()) == kPackEnding) {
      Expected<std::string> bytes = readFile(file, kMaxPackBytes, tr("name a pack that 'moltact pack' made"));
      if (!bytes) return bytes.problem();
      pack = *std::move(bytes);
      const Expected<TemporaryPack> opened = TemporaryPack::open(file);
      if (!opened) return opened.problem();
      problem = addOutline(opened->lesson(), out.outlines);
    } else {
      PackedLesson packed = packLesson(file);
      for (const Problem& p : packed.warnings) note(p.text());
      if (!packed.pack) return packed.errors.front();
      pack = std::move(packed.pack->bytes);
      problem = addOutline(file, out.outlines);
    }
    if (problem) return *problem;
    const ClassLesson& lesson = out.outlines.back();
    out.served.push_back({lesson.id, lesson.outline.title, std::make_shared<const std::string>(std::move(pack))});
  }
  return out;
}

std::string withPort(const std::string& host, int port) {
  return port == 80 ? host : host + ':' + std::to_string(port);
}

// Names that reach this computer, as a browser writes them, the best one for a student first.
std::vector<std::string> hostsOf(bool share, int port) {
  std::vector<std::string> names;
  if (share) {
    const LocalAddresses local = localAddresses();
    names = local.ip;
    if (names.empty()) names.emplace_back("127.0.0.1");  // in no network
    names.insert(names.end(), local.bridges.begin(), local.bridges.end());
    if (!local.host.empty()) {
      names.push_back(lower(local.host));
      names.push_back(lower(local.host) + ".local");
    }
  }
  names.insert(names.end(), {"127.0.0.1", "localhost"});
  for (std::string& name : names) name = withPort(name, port);
  return names;
}

Expected<int> bindPort(ClassServer& server, const LiveClassOptions& options, const ClassStore* resumed) {
  if (options.port >= 0) return server.bind(options.share, options.port);
  if (resumed) return server.bind(options.share, resumed->identity().port);
  Expected<int> port = server.bind(options.share, LiveClassOptions::kUsualPort);
  return port ? port : server.bind(options.share, 0);
}

}  // namespace

bool classIsOpen(const fs::path& folder) { return ClassStore::open(folder); }

std::optional<Problem> runLiveClass(const LiveClassOptions& given,
                                    const std::function<void(const LiveClassNews&)>& news,
                                    const std::function<bool()>& stop) {
  Expected<std::string> page = readFile(given.page, kMaxPageBytes, tr("name the moltact.html of the browser edition"));
  if (!page) return page.problem();
  std::shared_ptr<ClassStore> store;
  const bool resumed = ClassStore::begun(given.folder);
  if (resumed) {
    Expected<std::unique_ptr<ClassStore>> opened = ClassStore::goOn(given.folder);
    if (!opened) return opened.problem();
    store = *std::move(opened);
  }
  // A class that goes on has its lessons and its share, unless the command names others.
  LiveClassOptions options = given;
  if (store && options.lessons.empty()) options.lessons = store->identity().lessons;
  if (store) options.share = options.share || store->identity().share;
  Expected<ChosenLessons> lessons = chosenLessons(options.lessons, [&](const std::string& text) {
    LiveClassNews note;
    note.text = text;
    news(note);
  });
  if (!lessons) return lessons.problem();
  ClassServer server;
  const Expected<int> port = bindPort(server, options, store.get());
  if (!port) return port.problem();
  if (!store) {
    ClassIdentity identity;
    identity.code = secretText(kCodeSigns, randomBytes);
    identity.teacher = secretText(kTeacherSigns, randomBytes);
    identity.seed = hash64(randomBytes(16)) >> 1;
    identity.port = *port;
    identity.began = utcText(std::chrono::system_clock::now());
    identity.share = options.share;
    for (const std::string& one : options.lessons) identity.lessons.push_back(lastingName(one));
    Expected<std::unique_ptr<ClassStore>> begun = ClassStore::begin(options.folder, identity);
    if (!begun) return begun.problem();
    store = *std::move(begun);
  }
  ClassRoom room(std::move(lessons->outlines), store->identity().seed);
  if (resumed) store->forEachRecord([&](std::string_view record) { room.restore(record); });

  ClassSite site;
  site.page = *std::move(page);
  site.lessons = std::move(lessons->served);
  site.hosts = hostsOf(options.share, *port);
  site.address = "http://" + site.hosts.front() + '/' + store->identity().code + '/';
  site.shared = options.share;
  site.random = randomBytes;
  LiveClassNews started;
  started.kind = LiveClassNews::Kind::Started;
  started.address = site.address;
  started.shared = options.share;
  if (options.share) {
    const std::vector<std::string> ip = localAddresses().ip;
    started.alone = ip.empty();
    for (std::size_t k = 1; k < ip.size(); ++k)
      started.others.push_back("http://" + withPort(ip[k], *port) + '/' + store->identity().code + '/');
  }
  started.teacher = "http://" + withPort("127.0.0.1", *port) + "/teacher/" + store->identity().teacher + '/';
  if (options.share) started.qr = qrText(qrCode(site.address));
  started.resumed = resumed;
  started.students = room.students().size();
  started.ended = room.ended();
  Expected<std::unique_ptr<ClassRequests>> made = ClassRequests::make(std::move(site), std::move(room), *store);
  if (!made) {
    Problem problem = made.problem();
    problem.file = options.page.string();
    return problem;
  }
  // Whoever keeps the requests keeps the store that they write to.
  const std::shared_ptr<ClassRequests> requests(made->release(), [store](const ClassRequests* one) { delete one; });
  started.requests = requests;
  started.clock_began = server.clockBegan();
  news(started);
  started.requests.reset();
  if (!server.serve(*requests, stop)) {
    (void)requests->writeReport();
    return Problem{{},
                   0,
                   0,
                   trf("the port {0} of this computer cannot be served", *port),
                   tr("end the program that uses it, or choose another with --port")};
  }

  LiveClassNews stopped;
  stopped.kind = LiveClassNews::Kind::Stopped;
  stopped.ended = requests->ended();
  stopped.students = requests->students();
  const Expected<std::string> report = requests->writeReport();
  if (!report) return report.problem();
  if (!report->empty()) stopped.report = store->folder() / "report.html";
  news(stopped);
  return std::nullopt;
}

}  // namespace moltact
