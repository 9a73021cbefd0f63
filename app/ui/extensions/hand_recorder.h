// Records every tick of a hand on the molecule to a file, and plays such recordings. A playback moves the hand and sets
// the scale, orientation and surface as recorded. During a playback no device is open, so that no force is given, and
// the attempt records nothing. Window's thread. Unit: second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/ui/application/extension.h"
#include "app/ui/scene/played_body.h"
#include "app/ui/widgets/messages.h"
#include "engine/servo/playback_device.h"

namespace moltact {

struct ApplicationOptions;
class AtomMovers;
class AttemptRecorder;
class DeviceLink;
class FileDialog;
class Opener;
struct PanelState;

class HandRecorder : public Extension {
 public:
  HandRecorder(const AtomMovers& movers, AttemptRecorder& recorder, DeviceLink& device, Opener& opener,
               HapticSession& scene, Messages& messages, PanelState& panels, FileDialog& file_dialog,
               const ApplicationOptions& options)
      : movers_(movers),
        opener_(opener),
        scene_(scene),
        messages_(messages),
        panels_(panels),
        file_dialog_(file_dialog),
        options_(options),
        attempts_(recorder),
        link_(device),
        body_(scene),
        moves_(scene.atoms().owner, MotionRank::Playback) {}

  /// Asks for a file, then records until stop() or until the molecule or the method changes.
  void askToRecord();
  void record(const std::filesystem::path& file);
  void stop();
  bool recording() const { return writer_.has_value(); }
  double recorded_s() const { return double(ticks_) * kTick_s; }

  /// Opens the recording's molecule and moves the hand as recorded. A file that is not a recording gives a message and
  /// changes nothing.
  void play(const std::filesystem::path& file);
  /// Restores the device used before.
  void endPlay();
  bool playing() const { return playing_ && scene_.servo().loop().device() == device_; }
  double at_s() const;
  double length_s() const;
  std::string name() const { return file_.filename().string(); }

  void beforeOpening(FileKind kind) override;
  bool open(FileKind kind, const std::filesystem::path& file) override;
  void beforeTicks() override;
  void afterPanels() override;
  void atEnd() override;
  bool live() const override { return recording() || playing_ || waiting_; }
  bool leadsHand() const override { return playing_; }

 private:
  const AtomMovers& movers_;
  Opener& opener_;
  HapticSession& scene_;
  Messages& messages_;
  PanelState& panels_;
  FileDialog& file_dialog_;
  const ApplicationOptions& options_;
  AttemptRecorder& attempts_;  // paused during a playback
  DeviceLink& link_;           // receives the played hand as a device
  PlayedBody body_;            // the body that the played hand holds
  void drain();
  void begin();
  void lead();
  void moveAtoms(const RecordedTick& now);
  std::string label(const char* key) const;

  std::filesystem::path file_;  // the file that is written or played
  // While recording:
  std::optional<ServoRecordingWriter> writer_;
  std::uint64_t ticks_ = 0;
  std::map<std::string, std::string> labels_;   // of the scene when the recording began
  SharedArray<Sphere> placed_;                  // its spheres, if they are not where the molecule's file has them
  std::shared_ptr<const SphereMotion> motion_;  // the last recorded one
  std::uint32_t motion_number_ = 0;
  std::uint32_t tracker_ = 0;  // the number of the scene's interaction when the recording began
  MessageId reported_ = 0;     // the message about the recording
  // While playing:
  std::optional<ServoRecording> waiting_;  // until its molecule is open
  PlaybackDevice* device_ = nullptr;       // owned by the servo loop while it is in use
  MotionSource moves_;                     // the atoms, as recorded
  std::shared_ptr<const SphereGrid> played_on_;
  std::optional<MotionReplay> motions_;  // of the recording of device_
  std::uint32_t moved_ = 0;              // the number of the last motion that was handed over
  bool playing_ = false;
  std::string before_;  // the device used before
};

}  // namespace moltact
