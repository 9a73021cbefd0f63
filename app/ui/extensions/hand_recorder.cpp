#include "app/ui/extensions/hand_recorder.h"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/atom_movers.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/device_link.h"
#include "app/ui/files/file_dialog.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/catalogue.h"

namespace moltact {
namespace fs = std::filesystem;

namespace {

// What moves the atoms, at the recording's first tick.
std::map<std::string, std::string> moverLabels(const AtomsMoved& moved) {
  // Long details, such as the displacements of a simulation, stand in the recording itself.
  constexpr std::size_t kMaxHow = 200;
  std::map<std::string, std::string> out{{"moved", moved.by}, {"moved_at", std::to_string(moved.position)}};
  if (!moved.file.empty()) out["moved_by_file"] = moved.file;
  if (!moved.engine.empty()) out["moved_by_engine"] = moved.engine;
  if (!moved.detail.empty() && moved.detail.size() <= kMaxHow) out["moved_how"] = moved.detail;
  for (auto& [key, value] : out) std::replace(value.begin(), value.end(), '\n', ' ');
  return out;
}

}  // namespace

void HandRecorder::askToRecord() {
  file_dialog_.ask({.title = tr("Record the hand in a file"),
                    .name = scene_.molecule().file.stem().string() + kRecordingEnding,
                    .ending = kRecordingEnding,
                    .chosen = [this](const fs::path& file) { record(file); }},
                   options_.picture_folder);
}

void HandRecorder::record(const fs::path& file) {
  stop();
  Expected<ServoRecordingWriter> made = ServoRecordingWriter::create(file, true);
  if (!made) return messages_.error(made.problem().text());
  if (!scene_.recording().begin())
    return messages_.error(tr("Nothing can be recorded now: open a molecule, and end what is played."));
  writer_.emplace(*std::move(made));
  file_ = file;
  ticks_ = 0;
  motion_.reset();
  motion_number_ = 0;
  // The interaction that is recorded was created for the spheres where they are now.
  const TouchableModel& now = scene_.stage();
  labels_ = moleculeLabels(lastingName(scene_.molecule(), MoleculeFolders::ofThisComputer()));
  labels_.merge(sceneLabels(*now.spheres, now.body.get()));
  if (const auto moved = movers_.position()) labels_.merge(moverLabels(*moved));
  const SharedArray<Sphere>& resting = scene_.atoms().resting().spheres->spheres();
  placed_ = now.spheres->spheres().sharesWith(resting) ? SharedArray<Sphere>() : now.spheres->spheres();
  tracker_ = scene_.servo().handedOver();
  reported_ =
      messages_.ask(MessageKind::Notice, trf("The hand is recorded in {0}.", file.filename().string()), {"device"});
}

void HandRecorder::drain() {
  ServoLink& servo = scene_.servo();
  ServoStep start;
  std::optional<Problem> problem;
  servo.loop().drainRecording(start, [&](const RecordedTick& tick) {
    if (problem) return;
    if (ticks_ == 0) {
      labels_.merge(touchLabels(scene_.touch()));
      labels_["device"] = servo.device().name;
      problem = writer_->begin(labels_, start);
      if (!problem && !placed_.empty()) problem = writer_->place(placed_);
    }
    RecordedTick numbered = tick;
    if (tick.motion_serial && !(motion_ && motion_->serial() == tick.motion_serial)) {
      const std::shared_ptr<const SphereMotion> next = servo.motionOf(tick.motion_serial);
      if (!problem && next) problem = writer_->addMotion(recordedMotion(*next, motion_.get()));
      motion_ = next;
      ++motion_number_;
    }
    if (tick.motion_serial) numbered.motion = motion_ ? motion_number_ : kUnknownMotion;
    if (!problem) problem = writer_->add(numbered);
    ++ticks_;
  });
  if (!problem && servo.loop().lostOfRecording())
    problem = Problem{file_.string(), 0, 0, tr("the window stood too long and ticks are missing from here on"),
                      tr("end other programs, and record again")};
  if (!problem) return;
  messages_.error(problem->text());
  writer_.reset();
  servo.record(false);
  messages_.takeBack(reported_);
}

void HandRecorder::stop() {
  if (!recording()) return;
  drain();
  if (!recording()) return;
  scene_.servo().record(false);
  messages_.takeBack(reported_);
  const std::optional<Problem> problem = ticks_ > 0 ? writer_->finish() : std::nullopt;
  writer_.reset();
  if (problem)
    messages_.error(problem->text());
  else
    messages_.notice(trf("{0} of the hand are in {1}; open the file to play them.",
                         quantityText(recorded_s(), Dimension::Time, decimals(1)), file_.string()));
}

void HandRecorder::beforeOpening(FileKind kind) {
  if (kind != FileKind::Attempt) endPlay();
}

bool HandRecorder::open(FileKind kind, const fs::path& file) {
  if (kind != FileKind::Recording) return false;
  play(file);
  return true;
}

void HandRecorder::play(const fs::path& file) {
  Expected<ServoRecording> recording = readServoRecording(file);
  if (!recording) return messages_.error(recording.problem().text());
  if (recording->ticks.empty())
    return messages_.error(trf("{0}: there are no ticks in this recording. Record it again.", file.string()));
  if (!recording->torn.empty()) messages_.warning(recording->torn);
  stop();
  endPlay();
  file_ = file;
  waiting_ = *std::move(recording);
  const NamedMolecule recorded = labelledMolecule(waiting_->labels);
  const std::string& molecule = recorded.name;
  const Expected<MoleculeKey> found = findMoleculeKey(recorded, MoleculeFolders::ofThisComputer());
  if (found && *found != scene_.molecule()) {
    opener_.showMolecule(*found);
  } else if (!found && !scene_.stage()) {
    waiting_.reset();
    messages_.error(trf("The molecule of this recording, {0}, is not on this computer.", molecule));
  } else if (!found) {
    messages_.warning(trf(
        "The molecule of this recording, {0}, is not on this computer. The recording is played on the open molecule.",
        molecule));
  }
}

std::string HandRecorder::label(const char* key) const {
  const ServoRecording& recording = device_ ? device_->recording() : *waiting_;
  const auto found = recording.labels.find(key);
  return found == recording.labels.end() ? std::string() : found->second;
}

void HandRecorder::begin() {
  panels_.pages.welcome = false;
  // The recorded touch settings and held body if the molecule is identical to the last bit; otherwise those of the open
  // scene.
  const SharedArray<Sphere>& at_rest = scene_.atoms().resting().molecule->spheres;
  const bool placed = waiting_->placed.size() == at_rest.size();
  if (const RecordedScene was =
          recordedScene(waiting_->labels, placed ? SharedArray<Sphere>(waiting_->placed) : at_rest);
      label("balls") == fingerprint(*was.spheres))
    body_.hold(was.spheres->untouchable(), was.body ? was.body->atoms : std::vector<std::uint32_t>());
  if (placed && moves_.claim()) scene_.placeAtoms(moves_, waiting_->placed);
  const auto labels = sceneLabels(*scene_.stage().spheres, scene_.stage().body.get());
  const bool same = label("held") == (labels.contains("held") ? labels.at("held") : "") &&
                    (label("balls").empty() || label("balls") == labels.at("balls"));
  if (!same)
    messages_.warning(
        tr("The open molecule is not the one of this recording. The hand repeats its recorded path and may touch other "
           "atoms."));
  scene_.force().endTrial();
  scene_.setTouch(labelledTouch(waiting_->labels, scene_.touch()));
  before_ = link_.chosen();
  auto device = std::make_unique<PlaybackDevice>(*std::exchange(waiting_, std::nullopt));
  device_ = device.get();
  played_on_ = scene_.stage().spheres;
  motions_.emplace(device_->recording().motions, *played_on_);
  moved_ = 0;
  playing_ = true;
  attempts_.pause(true);
  link_.useTemporarily(std::move(device));
  lead();
}

// Applies the settings that were recorded at this tick.
void HandRecorder::lead() {
  const RecordedTick& now = device_->recording().ticks[device_->at()];
  scene_.recording().lead(now.settings);
  moveAtoms(now);
}

// Each recorded motion is handed over when the playback has reached it, so that the atoms are late by a frame or two.
void HandRecorder::moveAtoms(const RecordedTick& now) {
  if (now.motion == moved_ || now.motion == kUnknownMotion) return;
  const std::optional<MotionPhase> phase = motions_->at(now.motion, now.motion_tick);
  if (!phase || !phase->motion) return;
  if (moves_.claim() && scene_.moveAtoms(moves_, phase->motion->at(1.0), phase->motion->ticks())) moved_ = now.motion;
}

void HandRecorder::endPlay() {
  waiting_.reset();
  if (!playing_) return;
  playing_ = false;
  // If another device has been chosen meanwhile, this one no longer exists.
  const bool leads = scene_.servo().loop().device() == device_;
  device_ = nullptr;
  motions_.reset();
  scene_.recording().endLead();
  if (moves_.owns()) scene_.placeAtoms(moves_, scene_.atoms().resting().spheres->spheres());
  moves_.release();
  body_.release();
  if (!scene_.playedHand().on()) attempts_.pause(false);
  if (leads) link_.giveBack(before_);
}

double HandRecorder::at_s() const { return playing() ? double(device_->at()) * kTick_s : 0.0; }
double HandRecorder::length_s() const { return playing() ? double(device_->recording().ticks.size()) * kTick_s : 0.0; }

void HandRecorder::beforeTicks() {
  if (waiting_ && !opener_.loading() && scene_.stage()) begin();
  if (!playing_) return;
  if (scene_.servo().loop().device() != device_) return endPlay();
  if (!device_->ended()) return lead();
  const std::string name = file_.filename().string();
  endPlay();
  messages_.notice(trf("{0} has been played to its end; {1} leads again.", name, scene_.servo().device().name));
}

void HandRecorder::afterPanels() {
  if (!recording()) return;
  drain();
  if (recording() && scene_.servo().handedOver() != tracker_) stop();
}

void HandRecorder::atEnd() { stop(); }

}  // namespace moltact
