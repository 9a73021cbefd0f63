// Writes an attempt's lines in a background thread, so that no disk delays a frame; in a browser, which has no threads,
// at once. The thread passes each line to the operating system immediately and syncs it to the disk within kSync_s. If
// the disk is full or not writable, lines stay in memory and are retried. Window's thread; only the destructor and
// flush() wait.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

class AttemptWriter {
 public:
  /// Creates `name`.jsonl in `folder`, and the folder if necessary. If the name is taken, "-2", "-3" … is appended.
  static AttemptWriter startNew(std::filesystem::path folder, std::string name);
  /// Resumes an attempt: appends lines to the file.
  static AttemptWriter resume(std::filesystem::path file);

  AttemptWriter(AttemptWriter&&) noexcept;
  AttemptWriter& operator=(AttemptWriter&&) noexcept;
  /// Tries to write the pending lines and ends the thread.
  ~AttemptWriter();

  /// Passes a line, with its line end, to the thread.
  void append(std::string line);

  /// The fault that prevents writing: returned once when it begins, then nothing until it has been resolved.
  std::optional<Problem> takeFault();
  /// Returns true once after writing has recovered from a fault.
  bool takeRecovered();
  /// Tries to write the pending lines and waits for the result. Returns false if lines are still pending.
  bool flush();

  /// The file; empty until it has been opened.
  std::filesystem::path file() const;

  static constexpr double kSync_s = 1.0;   ///< maximum time between two syncs to the disk
  static constexpr double kRetry_s = 3.0;  ///< interval between retries after a fault
  /// If more bytes than this are pending, the newest lines are dropped; earlier lines stay complete. Before the next
  /// line, a gap mark with their number is written.
  static constexpr std::size_t kMaxWaiting = std::size_t{32} << 20;

 private:
  struct Impl;
  explicit AttemptWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
