#include "app/ui/extensions/attempt_recorder.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "engine/language/catalogue.h"
#include "engine/platform/background.h"
#include "engine/platform/read_file.h"
#include "engine/results/progress.h"

namespace moltact {
namespace {

constexpr double kLongestFrame_s = 2.0;  // a computer that slept was not used
constexpr double kView_s = 0.2;          // views are told at most so often

std::string now() { return utcText(std::chrono::system_clock::now()); }

bool gaveForce(const Application& app) { return app.scene.servo().device().gives_force; }

std::string deviceName(const Application& app) { return app.scene.servo().device().name; }

// The stand-in led by mouse or keyboard, or a device in the hand.
bool realDevice(Application& app) { return &app.scene.servo().device() != &app.scene.servo().mouse().info(); }

// An attempt goes to other computers.
ReadOptions withoutFolders(ReadOptions reading) {
  reading.beside = std::filesystem::path(reading.beside).filename().string();
  return reading;
}

StageChanged stageOf(const Application& app) {
  const TouchScene& scene = app.scene;
  const Molecule& molecule = *scene.stage().molecule;
  return {molecule.id,           scene.molecule().file.filename().string(),
          molecule.atoms.size(), scene.servo_settings.workspace,
          scene.touch(),         withoutFolders(scene.molecule().reading)};
}

}  // namespace

void AttemptRecorder::beginParts(Application& app) {
  session_ = app.lesson.session();
  lesson_ = app.lesson.file();
  session_watch_.begin(*app.lesson.session());
  touch_watch_ = TouchWatch();
  now_s_ = 0.0;
  view_told_s_ = states_told_s_ = -1.0;
  way_.reset();
  stage_.reset();
  states_.reset();
  view_.reset();
  hints_ = 0;
}

void AttemptRecorder::beginNew(Application& app) {
  log_.reset();
  if (app.options().attempts_folder.empty() || paused_) return;
  const Expected<std::string> bytes = readFile(app.lesson.file(), kLargestAttempt, "");
  hash_ = bytes ? contentHash(*bytes) : std::string();
  AttemptHeader header;
  header.program = MOLTACT_VERSION;
  header.began = now();
  header.student = student_;
  header.device = deviceName(app);
  header.gives_force = gaveForce(app);
  header.lesson = outlineOf(app.lesson.session()->lesson(), hash_);
  app.lesson.session()->setOrderSeed(orderSeed(header));
  log_.emplace(app.options().attempts_folder, std::move(header));
  beginParts(app);
  for (Predicted& p : std::exchange(predictions_, {})) keepPrediction(std::move(p));
}

void AttemptRecorder::lessonChanged(Application& app) {
  if (log_ && session_ == app.lesson.session()) {
    const Expected<std::string> bytes = readFile(app.lesson.file(), kLargestAttempt, "");
    // The same attempt goes on, and in a pause too its outline is to be the lesson's.
    log_->add(
        {now_s_, LessonReread{outlineOf(app.lesson.session()->lesson(), bytes ? contentHash(*bytes) : std::string())}});
    return;
  }
  endAttempt();
  beginNew(app);
}

void AttemptRecorder::resume(Application& app, const std::filesystem::path& lesson_file,
                             const std::filesystem::path& attempt_file) {
  endAttempt();
  if (attempt_file.empty()) return app.open(lesson_file);
  const Expected<Attempt> attempt = readAttempt(attempt_file, ReadDepth::NoHipSamples);
  app.open(lesson_file);
  if (app.lesson.file() != lesson_file || !app.lesson.session()) return;
  if (!attempt) {
    app.messages.warning(trf("{0}. The lesson begins anew.", attempt.problem().text()));
    return;
  }
  if (paused_) return;  // whose work it is will be asked first
  app.lesson.session()->restore(memoryOf(*attempt));
  app.lesson.session()->setOrderSeed(orderSeed(attempt->header), sittingsOf(*attempt));
  if (!log_) return;
  student_ = attempt->header.student;
  log_.emplace(attempt_file, attempt->end_s(), Resumed{now(), MOLTACT_VERSION, deviceName(app), gaveForce(app)});
  beginParts(app);
  const LessonOutline outline = outlineOf(app.lesson.session()->lesson(), hash_);
  if (attempt->header.lesson.hash != hash_) add(LessonReread{outline});
}

void AttemptRecorder::passTo(Application& app, const std::string& student) {
  const std::filesystem::path lesson = app.lesson.file();
  if (!app.lesson.session()) {
    student_ = student;
    return;
  }
  const std::string step = app.lesson.session()->step().id;
  endAttempt();
  student_ = student;
  const auto before = std::find_if(turns_.begin(), turns_.end(),
                                   [&](const Turn& t) { return t.student == student && t.lesson == lesson; });
  if (before != turns_.end()) {
    resume(app, lesson, std::filesystem::path(before->file));
  } else {
    app.open(lesson);
  }
  if (app.lesson.session()) app.lesson.session()->goTo(step);
}

void AttemptRecorder::keepPrediction(Predicted prediction) {
  if (log_)
    log_->add({now_s_, std::move(prediction)});
  else
    predictions_.push_back(std::move(prediction));
}

void AttemptRecorder::pause(bool on) {
  if (on == paused_) return;
  touch_watch_.breakOff();
  for (AttemptEvent& e : touch_watch_.take(now_s_)) add(std::move(e));
  paused_ = on;
}

void AttemptRecorder::add(AttemptEvent event) {
  if (log_ && !paused_) log_->add(std::move(event));
}

void AttemptRecorder::endAttempt() {
  if (!log_) return;
  touch_watch_.breakOff();
  for (AttemptEvent& e : touch_watch_.take(now_s_)) add(std::move(e));
  add(SessionClosed{now()});
  // Its name is known once the file has been opened.
  log_->flush();
  if (const std::filesystem::path kept = log_->file(); !kept.empty() && !lesson_.empty()) {
    std::erase_if(turns_, [&](const Turn& t) { return t.student == student_ && t.lesson == lesson_; });
    turns_.push_back({student_, lesson_, kept});
  }
  log_.reset();
  session_ = nullptr;
}

void AttemptRecorder::atEnd(Application&) { endAttempt(); }

void AttemptRecorder::beforeTicks(Application& app) {
  const std::filesystem::path& folder = app.options().attempts_folder;
  if (!mending_begun_ && !folder.empty()) {
    mending_begun_ = true;
    mended_ = inBackground([folder] { return mendAttempts(folder).size(); });
  }
  if (!paused_ && !app.panels.welcome) now_s_ += std::clamp(app.dt_s(), 0.0, kLongestFrame_s);
}

void AttemptRecorder::ticks(Application& app, const FeltTicks& felt) {
  if (!log_ || paused_) return;
  const double last_s = felt.ticks.back().sample.time_s;
  const InputWay way = realDevice(app) ? InputWay::Device : input_.way();
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    if (!s.has_interaction) continue;
    const double t_s = std::max({0.0, now_s_ - app.dt_s(), now_s_ - (last_s - s.time_s)});
    touch_watch_.add(touchSampleOf(s), t_s, way);
  }
}

void AttemptRecorder::sceneChanged(Application&) { touch_watch_.breakOff(); }

void AttemptRecorder::lookAtWay(Application& app) {
  InputChanged is{realDevice(app) ? InputWay::Device : input_.way(), deviceName(app), gaveForce(app)};
  if (way_ == is) return;
  add(is);
  way_ = std::move(is);
}

void AttemptRecorder::lookAtStage(Application& app) {
  if (!app.scene.stage()) return;
  StageChanged is = stageOf(app);
  if (stage_ == is) return;
  add(is);
  stage_ = std::move(is);
  states_.reset();
}

void AttemptRecorder::lookAtStates(Application& app) {
  const MovingStates& moving = app.extensions().moving_states;
  if (!moving.there()) return states_.reset();
  StatesMoved is{moving.file().filename().string(), moving.then().superposed_on.text(), moving.share()};
  // What does not move any more is told at once.
  if (states_ == is || (moving.share() != moving.wanted() && now_s_ - states_told_s_ < kView_s)) return;
  add(is);
  states_ = std::move(is);
  states_told_s_ = now_s_;
}

void AttemptRecorder::lookAtView(Application& app) {
  if ((view_ && *view_ == app.scene.camera) || now_s_ - view_told_s_ < kView_s) return;
  const Camera& c = app.scene.camera;
  add(ViewChanged{{c.orientation.w, c.orientation.x, c.orientation.y, c.orientation.z}, c.target.A, c.distance_A});
  view_ = c;
  view_told_s_ = now_s_;
}

void AttemptRecorder::afterPanels(Application& app) {
  input_.look(ImGui::GetIO());
  tell(app);
  const LessonSession* session = app.lesson.session();
  if (!log_ || paused_ || session != session_) return;
  lookAtWay(app);
  lookAtStage(app);
  lookAtStates(app);
  lookAtView(app);
  bool further = false;
  for (AttemptEvent& e : touch_watch_.take(now_s_)) add(std::move(e));
  for (AttemptEvent& e : session_watch_.look(*session, now_s_, input_.way())) {
    further = true;
    // A task is done by touch.
    if (auto* done = std::get_if<TaskDone>(&e.what)) done->by = way_->by;
    add(std::move(e));
  }
  for (; hints_ < app.panels.hints; ++hints_) add(HintOpened{session->step().id});
  hints_ = app.panels.hints;
  if (further) add(SessionWatch::progressOf(*session));
  log_->heartbeat(now_s_);
}

void AttemptRecorder::tell(Application& app) {
  if (mended_.valid() && mended_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    const std::size_t n = mended_.get();
    if (n > 0)
      app.messages.notice(
          trnf("The program ended in the middle of a lesson last time. What was done until then is kept.",
               "The program ended in the middle of {0} lessons. What was done until then is kept.", n, n));
  }
  if (!log_) return;
  if (const std::optional<Problem> fault = log_->takeFault())
    unkept_ = app.messages.ask(MessageKind::Warning,
                               trf("What you do is not being kept on the disk: {0}. Go on with the lesson: it is held "
                                   "in memory and written as "
                                   "soon as that can be.",
                                   fault->text()),
                               {});
  if (!log_->takeRecovered()) return;
  app.messages.takeBack(unkept_);
  app.messages.notice(tr("What you do is kept on the disk again, with all that waited."));
}

}  // namespace moltact
