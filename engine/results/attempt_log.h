// An attempt while it goes on: takes its events and has them written. Nothing is kept of a lesson that was only looked
// at: the file begins with the first deed (a touch, an answer, a hint, a step gone on to). Window's thread; never
// waits, but in its destructor.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/results/attempt.h"
#include "engine/results/attempt_writer.h"

namespace moltact {

class AttemptLog {
 public:
  /// A new attempt, kept in `folder` (empty: nothing is kept).
  AttemptLog(std::filesystem::path folder, AttemptHeader header);
  /// An attempt that is taken up again; `end_s` is the time of its last event. Events that are added count on from
  /// there.
  AttemptLog(std::filesystem::path file, double end_s, const Resumed& resumed);

  /// `event.t_s` is the time of use since this object was made.
  void add(AttemptEvent event);
  /// Once a frame: writes the time where no other event has for kHeartbeat_s, so that an attempt whose program is
  /// killed is known almost to its end. Views and the hand's way do not count, for a report passes over them.
  void heartbeat(double t_s);

  /// The file has been begun.
  bool begun() const { return writer_.has_value(); }
  /// The file; empty before it is there.
  std::filesystem::path file() const { return writer_ ? writer_->file() : std::filesystem::path(); }
  /// As AttemptWriter has them.
  std::optional<Problem> takeFault() { return writer_ ? writer_->takeFault() : std::nullopt; }
  bool takeRecovered() { return writer_ && writer_->takeRecovered(); }
  bool flush() { return !writer_ || writer_->flush(); }

  /// Progress is written again after so many bytes, so that readProgress finds it near the end (unit: byte).
  static constexpr std::size_t kProgressEvery = 24 << 10;

 private:
  void write(std::string line);

  std::filesystem::path folder_;
  std::string name_;    // of the new file
  std::string before_;  // lines of which none is a deed
  double from_s_ = 0.0;
  double told_s_ = 0.0;  // the latest time that a report reads, from_s_ counted in
  std::size_t since_progress_ = 0;
  std::optional<AttemptEvent> progress_;
  std::optional<AttemptWriter> writer_;
};

}  // namespace moltact
