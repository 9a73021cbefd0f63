#include "app/ui/extensions/hand_recorder.h"

#include <cstdio>
#include <map>
#include <memory>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "app/ui/extensions/device_link.h"
#include "engine/molecule/catalogue.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

std::string seconds(double s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", s);
  return text;
}

}  // namespace

void HandRecorder::askToRecord(Application& app) {
  app.file_dialog.ask({.title = "Record the hand in a file",
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
    return app.messages.error("Nothing can be recorded now: open a molecule, and end what is played.");
  writer_.emplace(*std::move(made));
  file_ = file;
  ticks_ = 0;
  tracker_ = app.scene.servo().handedOver();
  told_ = "The hand is recorded in " + file.filename().string() + ".";
  app.messages.ask(MessageKind::Notice, told_, {"device"});
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
      labels["method"] = app.scene.method();
      labels["device"] = servo.device().name;
      problem = writer_->begin(labels, start);
    }
    if (!problem) problem = writer_->add(tick);
    ++ticks_;
  });
  if (!problem && servo.lostOfRecording())
    problem = Problem{file_.string(), 0, 0, "the window stood too long and ticks are missing from here on",
                      "end other programs, and record anew"};
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
    app.messages.notice(seconds(recorded_s()) + " of the hand are in " + file_.string() +
                        "; open the file to play them.");
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
    return app.messages.error(file.string() + ": there are no ticks in this recording. Record it anew.");
  if (!recording->torn.empty()) app.messages.warning(recording->torn);
  stop(app);
  endPlay(app);
  file_ = file;
  waiting_ = *std::move(recording);
  const NamedMolecule recorded = labelledMolecule(waiting_->labels);
  const std::string& molecule = recorded.name;
  const Expected<MoleculeKey> found = findMolecule(recorded, MoleculeFolders::ofThisComputer());
  if (found && *found != app.scene.molecule()) {
    app.showMolecule(*found);
  } else if (!found && !app.scene.stage()) {
    waiting_.reset();
    app.messages.error("The molecule of this recording, " + molecule + ", is not on this computer.");
  } else if (!found) {
    app.messages.warning("The molecule of this recording, " + molecule +
                         ", is not on this computer: the hand is led on what is on the stage.");
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
    app.messages.warning(
        "What is on the stage is not what the hand was recorded on: it goes as it went, and may meet something else.");
  app.scene.useMethod(label("method"));
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
  app.messages.notice(name + " has been played to its end; " + app.scene.servo().device().name + " leads again.");
}

void HandRecorder::afterPanels(Application& app) {
  if (!recording()) return;
  drain(app);
  if (recording() && app.scene.servo().handedOver() != tracker_) stop(app);
}

void HandRecorder::atEnd(Application& app) { stop(app); }

}  // namespace moltact
