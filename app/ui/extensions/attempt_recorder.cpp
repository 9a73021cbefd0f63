#include "app/ui/extensions/attempt_recorder.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/atom_movers.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/language/catalogue.h"
#include "engine/platform/background.h"
#include "engine/platform/read_file.h"
#include "engine/results/lesson_language.h"
#include "engine/results/progress.h"

namespace moltact {
namespace {

constexpr double kLongestFrame_s = 2.0;  // longer frames are cut: the computer was asleep
constexpr double kView_s = 0.2;          // minimum interval between two recorded views

std::string now() { return utcText(std::chrono::system_clock::now()); }

bool gaveForce(const HapticSession& scene) { return scene.servo().device().gives_force; }

std::string deviceName(const HapticSession& scene) { return scene.servo().device().name; }

// True for a haptic device, false for the mouse or the keyboard.
bool realDevice(HapticSession& scene) { return &scene.servo().device() != &scene.servo().mouse().info(); }

// An attempt is copied to other computers, so paths are reduced to file names.
ReadOptions withoutFolders(ReadOptions reading) {
  reading.beside = std::filesystem::path(reading.beside).filename().string();
  return reading;
}

StageChanged stageOf(const HapticSession& scene) {
  const Molecule& molecule = *scene.stage().molecule;
  return {molecule.id,
          scene.molecule().file.filename().string(),
          molecule.atoms.size(),
          scene.servo_settings.workspace,
          scene.touch(),
          withoutFolders(scene.molecule().reading),
          scene.stage().body ? scene.stage().body->atoms : std::vector<std::uint32_t>()};
}

}  // namespace

void AttemptRecorder::beginParts() {
  session_ = lesson_.session();
  lesson_file_ = lesson_.file();
  session_facts_ = {};
  happened_.clear();
  lesson_.session()->restartEvents();
  touch_watch_ = TouchWatch();
  now_s_ = 0.0;
  view_written_s_ = atoms_written_s_ = -1.0;
  way_.reset();
  stage_.reset();
  atoms_.reset();
  view_.reset();
}

void AttemptRecorder::beginNew() {
  log_.reset();
  if (options_.attempts_folder.empty() || paused_) return;
  const Expected<std::string> bytes = readFile(lesson_.file(), kLargestAttempt, "");
  hash_ = bytes ? contentHash(*bytes) : std::string();
  AttemptHeader header;
  header.program = MOLTACT_VERSION;
  header.began = now();
  header.student = student_;
  header.device = deviceName(scene_);
  header.gives_force = gaveForce(scene_);
  header.lesson = outlineOf(lesson_.session()->lesson(), hash_);
  lesson_.session()->setOrderSeed(orderSeed(header));
  log_.emplace(options_.attempts_folder, std::move(header));
  beginParts();
  for (Predicted& p : std::exchange(predictions_, {})) keepPrediction(std::move(p));
}

void AttemptRecorder::lessonChanged() {
  if (log_ && session_ == lesson_.session()) {
    const Expected<std::string> bytes = readFile(lesson_.file(), kLargestAttempt, "");
    // The attempt continues. Its outline must match the lesson, even while recording is paused.
    log_->add(
        {now_s_, LessonReread{outlineOf(lesson_.session()->lesson(), bytes ? contentHash(*bytes) : std::string())}});
    return;
  }
  endAttempt();
  beginNew();
}

void AttemptRecorder::resume(const std::filesystem::path& lesson_file, const std::filesystem::path& attempt_file) {
  endAttempt();
  if (attempt_file.empty()) return opener_.open(lesson_file);
  const Expected<Attempt> attempt = readAttempt(attempt_file, ReadDepth::NoHipSamples);
  opener_.open(lesson_file);
  if (lesson_.file() != lesson_file || !lesson_.session()) return;
  if (!attempt) {
    messages_.warning(trf("{0}. The lesson begins anew.", attempt.problem().text()));
    return;
  }
  if (paused_) return;  // the student is asked for a name first
  lesson_.session()->restore(memoryOf(inTermsOf(outlineOf(lesson_.session()->lesson(), hash_), *attempt)));
  lesson_.session()->setOrderSeed(orderSeed(attempt->header), sittingsOf(*attempt));
  if (!log_) return;
  student_ = attempt->header.student;
  log_.emplace(attempt_file, attempt->end_s(), Resumed{now(), MOLTACT_VERSION, deviceName(scene_), gaveForce(scene_)});
  beginParts();
  const LessonOutline outline = outlineOf(lesson_.session()->lesson(), hash_);
  if (attempt->header.lesson.hash != hash_) add(LessonReread{outline});
}

void AttemptRecorder::passTo(const std::string& student) {
  const std::filesystem::path lesson = lesson_.file();
  if (!lesson_.session()) {
    student_ = student;
    return;
  }
  const std::string step = lesson_.session()->step().id;
  endAttempt();
  student_ = student;
  const auto before = std::find_if(turns_.begin(), turns_.end(),
                                   [&](const Turn& t) { return t.student == student && t.lesson == lesson; });
  if (before != turns_.end()) {
    resume(lesson, std::filesystem::path(before->file));
  } else {
    opener_.open(lesson);
  }
  if (lesson_.session()) lesson_.session()->goTo(step);
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
  // Opening the file determines its name, so the log is flushed first.
  log_->flush();
  if (const std::filesystem::path kept = log_->file(); !kept.empty() && !lesson_file_.empty()) {
    std::erase_if(turns_, [&](const Turn& t) { return t.student == student_ && t.lesson == lesson_file_; });
    turns_.push_back({student_, lesson_file_, kept});
  }
  log_.reset();
  session_ = nullptr;
}

void AttemptRecorder::atEnd() { endAttempt(); }

void AttemptRecorder::beforeTicks() {
  const std::filesystem::path& folder = options_.attempts_folder;
  if (!mending_begun_ && !folder.empty()) {
    mending_begun_ = true;
    mended_ = inBackground([folder] { return mendAttempts(folder).size(); });
  }
  if (!paused_ && !panels_.pages.welcome) now_s_ += std::clamp(time_.dt_s, 0.0, kLongestFrame_s);
}

void AttemptRecorder::ticks(const FeltTicks& felt) {
  if (!log_ || paused_) return;
  const double last_s = felt.ticks.back().sample.time_s;
  const InputKind way = realDevice(scene_) ? InputKind::Device : input_.kind();
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& s = tick.sample;
    if (!s.has_interaction) continue;
    const double t_s = std::max({0.0, now_s_ - time_.dt_s, now_s_ - (last_s - s.time_s)});
    touch_watch_.add(touchSampleOf(s), t_s, way);
  }
}

void AttemptRecorder::sceneChanged() { touch_watch_.breakOff(); }

void AttemptRecorder::lookAtWay() {
  InputChanged is{realDevice(scene_) ? InputKind::Device : input_.kind(), deviceName(scene_), gaveForce(scene_)};
  if (way_ == is) return;
  add(is);
  way_ = std::move(is);
}

void AttemptRecorder::lookAtStage() {
  if (!scene_.stage()) return;
  StageChanged is = stageOf(scene_);
  if (stage_ == is) return;
  add(is);
  stage_ = std::move(is);
  atoms_.reset();
}

void AttemptRecorder::lookAtAtoms() {
  std::optional<AtomsMoved> is = movers_.position();
  if (!is) return atoms_.reset();
  // The end of a motion is recorded at once.
  if (atoms_ == is || (movers_.present()->moving() && now_s_ - atoms_written_s_ < kView_s)) return;
  AtomsMoved line = *is;
  if (atoms_ && atoms_->by == is->by && atoms_->engine == is->engine) line.engine.clear();
  add(std::move(line));
  atoms_ = std::move(is);
  atoms_written_s_ = now_s_;
}

void AttemptRecorder::lookAtView() {
  if ((view_ && *view_ == scene_.camera) || now_s_ - view_written_s_ < kView_s) return;
  const Camera& c = scene_.camera;
  add(ViewChanged{{c.orientation.w, c.orientation.x, c.orientation.y, c.orientation.z}, c.target.A, c.distance_A});
  view_ = c;
  view_written_s_ = now_s_;
}

void AttemptRecorder::lessonEvents(std::span<const SessionEvent> events) {
  if (log_ && lesson_.session() == session_) happened_.insert(happened_.end(), events.begin(), events.end());
}

void AttemptRecorder::afterPanels() {
  input_.look(ImGui::GetIO());
  tell();
  const LessonSession* session = lesson_.session();
  if (!log_ || paused_ || session != session_) return;
  lookAtWay();
  lookAtStage();
  lookAtAtoms();
  lookAtView();
  for (AttemptEvent& e : touch_watch_.take(now_s_)) add(std::move(e));
  bool further = false;
  for (const SessionEvent& e : std::exchange(happened_, {})) {
    // Tasks are solved by touch, so the input device is recorded with them.
    add(session_facts_.factOf(e, now_s_, std::holds_alternative<TaskFinished>(e) ? way_->by : input_.kind()));
    further = further || SessionFacts::changesProgress(e);
  }
  if (further) add(SessionFacts::progressOf(*session));
  log_->heartbeat(now_s_);
}

void AttemptRecorder::tell() {
  if (mended_.valid() && mended_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    const std::size_t n = mended_.get();
    if (n > 0)
      messages_.notice(trnf("The program ended in the middle of a lesson last time. What was done until then is kept.",
                            "The program ended in the middle of {0} lessons. What was done until then is kept.", n, n));
  }
  if (!log_) return;
  if (const std::optional<Problem> fault = log_->takeFault())
    unkept_ = messages_.ask(MessageKind::Warning,
                            trf("What you do is not being kept on the disk: {0}. Go on with the lesson: it is held "
                                "in memory and written as "
                                "soon as that can be.",
                                fault->text()),
                            {});
  if (!log_->takeRecovered()) return;
  messages_.takeBack(unkept_);
  messages_.notice(tr("What you do is kept on the disk again, with all that waited."));
}

}  // namespace moltact
