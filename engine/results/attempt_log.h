// The attempt in progress: receives events and passes them to the writer. A lesson that was only viewed is not
// recorded: the file begins with the first action (a touch, an answer, a hint, or a move to another step). Window's
// thread; only the destructor and flush() wait.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/results/attempt.h"
#include "engine/results/attempt_writer.h"

namespace moltact {

class AttemptLog {
 public:
  /// A new attempt in `folder` (empty: nothing is recorded).
  AttemptLog(std::filesystem::path folder, AttemptHeader header);
  /// Resumes an attempt; `end_s` is the time of its last event. New events continue from there.
  AttemptLog(std::filesystem::path file, double end_s, const Resumed& resumed);

  /// `event.t_s` is the time of use since this object was created.
  void add(AttemptEvent event);
  /// Called once per frame. Writes the time if no other event has for kHeartbeat_s, so that the end of a killed
  /// program's attempt is known. Views and HIP samples do not count, because a report skips them.
  void heartbeat(double t_s);

  /// Whether the file has been created.
  bool begun() const { return writer_.has_value(); }
  /// The file; empty before it exists.
  std::filesystem::path file() const { return writer_ ? writer_->file() : std::filesystem::path(); }
  /// See AttemptWriter.
  std::optional<Problem> takeFault() { return writer_ ? writer_->takeFault() : std::nullopt; }
  bool takeRecovered() { return writer_ && writer_->takeRecovered(); }
  bool flush() { return !writer_ || writer_->flush(); }

  /// Progress is written again after this many bytes, so that readProgress finds it near the end (unit: byte).
  static constexpr std::size_t kProgressEvery = 24 << 10;

 private:
  void write(std::string line);

  std::filesystem::path folder_;
  std::string name_;    // of the new file
  std::string before_;  // lines before the first action
  double from_s_ = 0.0;
  double written_s_ = 0.0;  // the latest time written in an event that reports read, including from_s_
  std::size_t since_progress_ = 0;
  std::optional<AttemptEvent> progress_;
  std::optional<AttemptWriter> writer_;
};

}  // namespace moltact
