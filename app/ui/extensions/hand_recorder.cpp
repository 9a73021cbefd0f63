#include "app/ui/extensions/hand_recorder.h"

#include <map>
#include <memory>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/device_link.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/molecule/catalogue.h"

namespace moltact {
namespace fs = std::filesystem;
void HandRecorder::askToRecord(Application& app) {
  app.file_dialog.ask({.title = tr("Record the hand in a file"),
                       .name = app.scene.molecule().file.stem().string() + kRecordingEnding,
                       .ending = kRecordingEnding,
                       .chosen = [this, &app](const fs::path& file) { record(app, file); }},
                      app.options().picture_folder);
}

void HandRecorder::record(Application& app, const fs::path& file) {
  stop(app);
  Expected<ServoRecordingWriter> made = ServoRecordingWriter::create(file, true);
  if (!made) return app.messages.error(made.problem().text());
  if (!app.scene.beginRecording())
    return app.messages.error(tr("Nothing can be recorded now: open a molecule, and end what is played."));
  writer_.emplace(*std::move(made));
  file_ = file;
  ticks_ = 0;
  tracker_ = app.scene.servo().handedOver();
  told_ =
      app.messages.ask(MessageKind::Notice, trf("The hand is recorded in {0}.", file.filename().string()), {"device"});
}

void HandRecorder::drain(Application& app) {
  ServoLink& servo = app.scene.servo();
  ServoStep start;
  std::optional<Problem> problem;
  servo.drainRecording(start, [&](const RecordedTick& tick) {
    if (problem) return;
    if (ticks_ == 0) {
      auto labels = moleculeLabels(lastingName(app.scene.molecule(), MoleculeFolders::ofThisComputer()));
      labels["balls"] = fingerprint(*app.scene.stage().balls);
      labels.merge(touchLabels(app.scene.touch()));
      labels["device"] = servo.device().name;
      problem = writer_->begin(labels, start);
    }
    if (!problem) problem = writer_->add(tick);
    ++ticks_;
  });
  if (!problem && servo.lostOfRecording())
    problem = Problem{file_.string(), 0, 0, tr("the window stood too long and ticks are missing from here on"),
                      tr("end other programs, and record anew")};
  if (!problem) return;
  app.messages.error(problem->text());
  writer_.reset();
  servo.record(false);
  app.messages.takeBack(told_);
}

void HandRecorder::stop(Application& app) {
  if (!recording()) return;
  drain(app);
  if (!recording()) return;
  app.scene.servo().record(false);
  app.messages.takeBack(told_);
  const std::optional<Problem> problem = ticks_ > 0 ? writer_->finish() : std::nullopt;
  writer_.reset();
  if (problem)
    app.messages.error(problem->text());
  else
    app.messages.notice(trf("{0} of the hand are in {1}; open the file to play them.",
                            quantityText(recorded_s(), Dimension::Time, decimals(1)), file_.string()));
}

void HandRecorder::beforeOpening(Application& app, FileKind kind) {
  if (kind != FileKind::Attempt) endPlay(app);
}

bool HandRecorder::open(Application& app, FileKind kind, const fs::path& file) {
  if (kind != FileKind::Recording) return false;
  play(app, file);
  return true;
}

void HandRecorder::play(Application& app, const fs::path& file) {
  Expected<ServoRecording> recording = readServoRecording(file);
  if (!recording) return app.messages.error(recording.problem().text());
  if (recording->ticks.empty())
    return app.messages.error(trf("{0}: there are no ticks in this recording. Record it anew.", file.string()));
  if (!recording->torn.empty()) app.messages.warning(recording->torn);
  stop(app);
  endPlay(app);
  file_ = file;
  waiting_ = *std::move(recording);
  const NamedMolecule recorded = labelledMolecule(waiting_->labels);
  const std::string& molecule = recorded.name;
  const Expected<MoleculeKey> found = findMoleculeKey(recorded, MoleculeFolders::ofThisComputer());
  if (found && *found != app.scene.molecule()) {
    app.showMolecule(*found);
  } else if (!found && !app.scene.stage()) {
    waiting_.reset();
    app.messages.error(trf("The molecule of this recording, {0}, is not on this computer.", molecule));
  } else if (!found) {
    app.messages.warning(
        trf("The molecule of this recording, {0}, is not on this computer: the hand is led on what is on the stage.",
            molecule));
  }
}

std::string HandRecorder::label(const char* key) const {
  const ServoRecording& recording = device_ ? device_->recording() : *waiting_;
  const auto found = recording.labels.find(key);
  return found == recording.labels.end() ? std::string() : found->second;
}

void HandRecorder::begin(Application& app) {
  app.panels.welcome = false;
  if (const std::string balls = label("balls"); !balls.empty() && balls != fingerprint(*app.scene.stage().balls))
    app.messages.warning(tr(
        "What is on the stage is not what the hand was recorded on: it goes as it went, and may meet something else."));
  app.scene.endTry();
  app.scene.setTouch(labelledTouch(waiting_->labels, app.scene.touch()));
  before_ = link_.chosen();
  auto device = std::make_unique<PlaybackDevice>(*std::exchange(waiting_, std::nullopt));
  device_ = device.get();
  playing_ = true;
  attempts_.pause(true);
  link_.lend(app, std::move(device));
  lead(app);
}

// With what it was recorded with at this tick.
void HandRecorder::lead(Application& app) {
  const ServoSettings& now = device_->recording().ticks[device_->at()].settings;
  app.scene.leadBy(&now);
}

void HandRecorder::endPlay(Application& app) {
  waiting_.reset();
  if (!playing_) return;
  playing_ = false;
  // Another device may have been chosen meanwhile, and this one is gone.
  const bool leads = app.scene.servo().chosen() == device_;
  device_ = nullptr;
  app.scene.leadBy(nullptr);
  if (!app.scene.playing()) attempts_.pause(false);
  if (leads) link_.giveBack(app, before_);
}

double HandRecorder::at_s() const { return playing_ ? double(device_->at()) * kTick_s : 0.0; }
double HandRecorder::length_s() const { return playing_ ? double(device_->recording().ticks.size()) * kTick_s : 0.0; }

void HandRecorder::beforeTicks(Application& app) {
  if (waiting_ && !app.loading() && app.scene.stage()) begin(app);
  if (!playing_) return;
  if (app.scene.servo().chosen() != device_) return endPlay(app);
  if (!device_->ended()) return lead(app);
  const std::string name = file_.filename().string();
  endPlay(app);
  app.messages.notice(trf("{0} has been played to its end; {1} leads again.", name, app.scene.servo().device().name));
}

void HandRecorder::afterPanels(Application& app) {
  if (!recording()) return;
  drain(app);
  if (recording() && app.scene.servo().handedOver() != tracker_) stop(app);
}

void HandRecorder::atEnd(Application& app) { stop(app); }

}  // namespace moltact
