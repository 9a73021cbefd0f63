// A trajectory that moves the atoms of the scene (engine/trajectory): of a lesson's scene (its key `trajectory`) or of a
// file opened beside a molecule. The atoms move at constant speed from frame to frame, and the servo loop follows them.
// Window's thread; frames are read on a background thread. Frames are counted from 0 here and from 1 on the screen, in
// lessons and in attempts. Units: angstrom, second.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/extensions/atom_mover.h"
#include "engine/platform/background.h"
#include "engine/trajectory/frame_store.h"
#include "engine/trajectory/frame_walk.h"
#include "engine/trajectory/leap_guard.h"

namespace moltact {

class PlayedTrajectory : public AtomMover {
 public:
  using AtomMover::AtomMover;

  /// Duration of a piece of the motion: about thirty a second.
  static constexpr int kPiece_ticks = 33;
  /// The greatest speed of an atom on the way to a frame that the user chose; the way takes at most kMaxSeek_ticks.
  static constexpr double kSeekSpeed_A_per_s = 8.0;
  static constexpr int kMaxSeek_ticks = 990;
  /// Above so many atoms a piece of the motion takes 100 ms, since preparing one takes the window's thread some 30 ms.
  static constexpr std::size_t kLargeMolecule = 50'000;
  static constexpr int kLargePiece_ticks = 100;
  /// The positions that are kept ready take at most this, or those of the frames that are needed (unit: byte).
  static constexpr std::size_t kMaxReady_bytes = std::size_t{96} << 20;
  static constexpr double kSlowest_per_s = 0.5, kFastest_per_s = 60.0;
  static constexpr std::size_t kMaxSmoothing = 10;
  /// The survey of a trajectory reads at most so many frames.
  static constexpr std::size_t kMaxSurveyed = 400;

  using AtEnd = moltact::AtEnd;

  bool open(FileKind kind, const std::filesystem::path& file) override;
  void sceneChanged() override;
  void lessonChanged() override { sceneChanged(); }
  void beforeTicks() override;
  bool live() const override { return opening_.busy() || reading_.busy() || surveying_.busy() || moving(); }

  std::string_view kind() const override { return "trajectory"; }
  std::optional<AtomsMoved> position() const override;
  bool moving() const override { return frames_ > 1 && (running_ || seek_ || leaps_.unsettled()); }
  void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) override;

  bool ready() const { return frames_ > 0; }
  const std::filesystem::path& file() const { return file_; }
  /// The format's name, the number of frames found so far, and whether these are all.
  const std::string& format() const { return format_; }
  std::size_t frames() const { return frames_; }
  bool complete() const { return complete_; }
  /// The frames that are played: the first, and the last.
  std::size_t first() const { return std::min<std::size_t>(first_, frames_ ? frames_ - 1 : 0); }
  std::size_t last() const { return frames_ ? std::min<std::size_t>(last_, frames_ - 1) : 0; }
  /// The present place between frames, from first() to last(); past last() on the way back to first().
  double at() const { return at_; }
  /// The time of the frame that was reached last, if the file has times (picosecond).
  std::optional<double> time_ps() const;

  bool running() const { return running_; }
  void run(bool on);
  /// Moves the atoms to a frame, and stops there.
  void goTo(double frame);
  double framesPerSecond() const { return per_s_; }
  void setFramesPerSecond(double per_s);
  std::size_t smoothing() const { return smoothing_; }
  void setSmoothing(std::size_t frames);
  AtEnd at_end = AtEnd::Return;

  /// Starts the survey if it has not been started; null until it is done.
  const TrajectorySurvey* survey();

  /// Ends the trajectory: the atoms return to their places.
  void close();
  void end() override { close(); }
  std::string unavailable() const override;

 private:
  struct Placed {
    AtomPositions positions;
    std::optional<double> time_ps;
    double leap_limit_A = 0.0;  // FrameStore::leapLimit_A
  };
  // What a background task found.
  struct Reading {
    std::shared_ptr<FrameStore> store;
    std::size_t frames = 0;
    bool complete = false;
    std::vector<std::pair<std::size_t, Placed>> placed;
    std::optional<Problem> problem;
    std::optional<std::size_t> failed;  // the frame that could not be read
    std::vector<std::string> warnings;
  };
  static Reading readingOf(std::shared_ptr<FrameStore> store, const std::vector<std::size_t>& frames,
                           std::size_t smoothing, bool find_more);

  void forget();
  void begin(const std::filesystem::path& file, const FrameFit& fit, std::string fit_text);
  void takeOpened(Expected<Reading> opened);
  void take(Reading reading);
  void request();
  std::vector<std::size_t> needed() const;
  int piece_ticks() const;
  // How many frames' positions may be kept ready.
  std::size_t maxReady() const;
  // The positions at a place between frames; empty until both frames have been read.
  std::optional<std::vector<Sphere>> spheresAt(double at) const;
  double leapLimit_A(double at) const;
  bool move(std::vector<Sphere> to, double at, int ticks);
  bool seek();
  void playOn();
  void paintFluctuation();

  std::filesystem::path file_;
  FrameFit fit_;
  std::string fit_text_;                      // the same in attempts
  std::shared_ptr<const Molecule> molecule_;  // the molecule that the frames move
  bool by_lesson_ = false;
  NewestWork<Expected<Reading>> opening_;
  NewestWork<Reading> reading_;
  NewestWork<Expected<TrajectorySurvey>> surveying_;
  std::shared_ptr<FrameStore> store_;  // used by at most one task at a time
  std::optional<TrajectorySurvey> survey_;
  bool survey_begun_ = false, warned_ = false;
  std::shared_ptr<const Colouring> painted_;  // the colours that show the survey
  std::string format_;
  std::size_t frames_ = 0, first_ = 0, last_ = ~std::size_t{0};
  bool complete_ = false;
  std::map<std::size_t, Placed> placed_;  // frames near the present one
  std::set<std::size_t> failed_;          // frames that could not be read
  std::size_t placed_smoothing_ = 0;
  LeapGuard leaps_;  // in the motion that the loop follows
  double at_ = 0.0, per_s_ = 10.0;
  int direction_ = 1;
  bool running_ = false, started_ = false;
  std::optional<double> seek_;
  std::optional<double> shown_;  // the position that a playback requests
  std::size_t smoothing_ = 0;
  std::shared_ptr<const Molecule> begins_;  // its atoms at the first frame of a lesson's scene
};

}  // namespace moltact
