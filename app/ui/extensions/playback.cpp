#include "app/ui/extensions/playback.h"

#include <algorithm>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/atom_movers.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/lesson_list.h"
#include "app/ui/files/own_lessons.h"
#include "app/ui/files/settings.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/catalogue.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

// An attempt names a molecule's file without folders.
NamedMolecule namedOf(const StageChanged& stage) { return {stage.file, stage.reading}; }
NamedMolecule namedOf(const MoleculeKey& key) {
  NamedMolecule out{key.file.filename().string(), key.reading};
  out.reading.beside = fs::path(out.reading.beside).filename().string();
  return out;
}

}  // namespace

void Playback::beforeOpening(FileKind kind) {
  if (kind != FileKind::Attempt) close(false);
}

bool Playback::open(FileKind kind, const fs::path& file) {
  if (kind != FileKind::Attempt) return false;
  open(file);
  return true;
}

void Playback::open(const fs::path& file) {
  Expected<Attempt> attempt = readAttempt(file);
  if (!attempt) {
    messages_.error(attempt.problem().text());
    return;
  }
  const std::size_t passed_over = attempt->problems.size();
  const std::string first_problem =
      passed_over ? trf("line {0}, {1}", attempt->problems.front().line, attempt->problems.front().message) : "";
  if (!on()) {
    before_ = scene_.molecule();
    seen_before_ = scene_.camera;
  }
  timeline_.emplace(*std::move(attempt));
  file_ = file;
  shown_stage_ = {};
  missing_.clear();
  unknown_mover_.clear();
  moved_ = {};
  shown_view_ = nullptr;
  follows_view = true;
  at_s_ = 0.0;
  running_ = true;
  recorder_.pause(true);
  motion_.claim();
  messages_.clearErrors();
  panels_.pages.welcome = false;
  if (passed_over)
    messages_.notice(trnf("{0} line of {1} could not be read and is left out. The first: {2}.",
                          "{0} lines of {1} could not be read and are left out. The first: {2}.", passed_over,
                          passed_over, file.filename().string(), first_problem));
  if (!timeline_->stage(timeline_->length_s()))
    messages_.notice(tr("This attempt has no touches to show; its steps and answers are on the bar."));
}

void Playback::close(bool back) {
  if (!on()) return;
  timeline_.reset();
  running_ = false;
  scene_.playedHand().show(std::nullopt);
  body_.release();
  motion_.release();
  recorder_.pause(false);
  if (!back) return;
  // The playback has moved the view.
  if (lesson_.session())
    lesson_.askForScene();
  else if (!before_.empty() && before_ != scene_.molecule())
    opener_.showMolecule(before_);
  else if (!before_.empty())
    scene_.camera = seen_before_;
  else if (scene_.stage())
    opener_.resetView();
}

void Playback::setRunning(bool run) {
  if (!on()) return;
  if (run && at_s_ >= timeline_->length_s()) at_s_ = 0.0;
  running_ = run;
}

void Playback::seek(double t_s) {
  if (on()) at_s_ = std::clamp(t_s, 0.0, timeline_->length_s());
}

void Playback::seekMark(int direction) {
  if (!on()) return;
  constexpr double kSame_s = 0.5;  // a second press soon after a mark goes to the mark before it
  const auto& marks = timeline_->marks();
  if (direction > 0) {
    for (const TimelineMark& m : marks)
      if (m.t_s > at_s_ + 1e-9) return seek(m.t_s);
    return seek(timeline_->length_s());
  }
  double to_s = 0.0;
  for (const TimelineMark& m : marks)
    if (m.t_s < at_s_ - kSame_s) to_s = m.t_s;
  seek(to_s);
}

std::string Playback::lastMark() const {
  std::string out;
  for (const TimelineMark& m : timeline_->marks())
    if (m.t_s <= at_s_) out = m.text;
  return out;
}

void Playback::stageFor() {
  const StageChanged* stage = timeline_->stage(at_s_);
  if (!stage || namedOf(*stage) == shown_stage_) return;
  shown_stage_ = namedOf(*stage);
  if (scene_.stage() && namedOf(scene_.molecule()) == shown_stage_) return;
  ReadOptions reading = stage->reading;
  // A library name is kept as it is.
  if (reading.beside.find('.') != std::string::npos)
    if (const fs::path beside = fileOf(reading.beside); !beside.empty()) reading.beside = beside.string();
  if (const fs::path file = fileOf(stage->file); !file.empty()) opener_.showMolecule({file, reading});
}

// Finds a file that the attempt names without folders: beside the attempt, in the library, among fetched ones, or
// beside its lesson. Reports a missing one.
fs::path Playback::fileOf(const std::string& name) {
  std::error_code error;
  for (const fs::path& folder : {file_.parent_path(), lessonsFolder()})
    if (fs::is_regular_file(folder / name, error)) return folder / name;
  // The library and fetched molecules are searched by the molecule's name, the file name without extensions.
  const Expected<MoleculeKey> found =
      findMoleculeKey(name.substr(0, name.find('.')), MoleculeFolders::ofThisComputer());
  if (found) return found->file;
  if (missing_ == name) return {};
  std::vector<fs::path> folders{lessonFolderOf(settings_), packsFolderOf(options_)};
  for (const fs::path& shared : sharedDataFolders()) folders.push_back(shared / "lessons");
  fs::path own = fileBesideLesson(timeline_->header().lesson.file, name, folders);
  if (!own.empty()) return own;
  missing_ = name;
  messages_.warning(trf("The molecule of this attempt, {0}, is not on this computer: put it beside {1}.", name,
                        file_.filename().string()));
  return {};
}

// Has the recorded mover restore the position of the atoms.
void Playback::showAtoms() {
  const AtomsMoved* moved = timeline_->atoms(at_s_);
  if (!moved || !staged()) return;
  AtomMover* mover = movers_.ofKind(moved->by);
  if (!mover) {
    if (std::exchange(unknown_mover_, moved->by) != moved->by)
      messages_.warning(
          trf("This version cannot move the atoms of this attempt (“{0}”); they are shown at rest.", moved->by));
    return;
  }
  if (moved_.first != moved->file) moved_ = {moved->file, fileOf(moved->file)};
  if (!moved->file.empty() && moved_.second.empty()) return;
  mover->show(motion_, *moved, {moved_.second, timeline_->stage(at_s_)->reading});
}

// Whether the molecule of the present time is loaded.
bool Playback::staged() const {
  const StageChanged* stage = timeline_->stage(at_s_);
  return stage && scene_.stage() && namedOf(scene_.molecule()) == namedOf(*stage) &&
         scene_.stage().molecule->atoms.size() == stage->atoms;
}

// Moves the atoms of a held body from the molecule to the hand.
void Playback::showHeld() {
  if (!staged()) return;
  const std::vector<std::uint32_t>& held = timeline_->stage(at_s_)->held;
  if (!held.empty())
    body_.hold(held, held);
  else if (scene_.stage().body)
    body_.hold({}, {});
}

void Playback::showHand() {
  ServoSample sample;
  const StageChanged* stage = timeline_->stage(at_s_);
  if (const std::optional<HipSample> hand = staged() ? timeline_->hand(at_s_) : std::nullopt) {
    sample.has_interaction = true;
    if (hand->held && scene_.stage().body) {
      sample.holds_body = true;
      sample.orientation = hand->held->orientation;
      sample.body_pose = hand->held->body;
    }
    sample.hip = hand->hip;
    sample.contact.scp = hand->scp;
    sample.contact.feature = hand->feature;
    sample.contact.atoms = hand->atoms;
    sample.contact.displacement_A = hand->displacement_A;
    sample.force = hand->force;
    // Without a stiffness of springs, the sample's wanted force is that of the field alone.
    if (hand->wanted_N) sample.field = FeltForce{.force_N = *hand->wanted_N};
    sample.probe_A = stage->touch.probe_A;
    sample.time_s = at_s_;
  }
  scene_.playedHand().show(sample);
}

void Playback::showView() {
  if (!follows_view) return;
  const ViewChanged* view = timeline_->view(at_s_);
  if (!view || view == shown_view_) return;
  shown_view_ = view;
  const auto& q = view->orientation;
  scene_.camera.orientation = glm::normalize(glm::dquat(q[0], q[1], q[2], q[3]));
  scene_.camera.target = {view->target_A};
  scene_.camera.distance_A = view->distance_A;
}

void Playback::beforeTicks() {
  if (!on()) return;
  if (running_ && !opener_.loading()) {
    if (skips_rests) {
      const double next_s = timeline_->nextAfter(at_s_);
      if (next_s - at_s_ > kRest_s) at_s_ = next_s - 0.5;
    }
    at_s_ = std::min(at_s_ + time_.dt_s * speed, timeline_->length_s());
    if (at_s_ >= timeline_->length_s()) running_ = false;
  }
  stageFor();
  showHeld();
  showAtoms();
  showHand();
  showView();
}

void Playback::afterPanels() {
  if (on() && scene_.controls.cameraMoved()) follows_view = false;
}

}  // namespace moltact
