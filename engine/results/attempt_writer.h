// Writes an attempt's lines as they come, on a thread of its own, so that no disk delays a frame; in a page, which has
// neither, at once. A line is with the
// operating system as soon as that thread runs, and on the disk within kSync_s. Where the disk is full or may not be
// written, the lines wait in memory and are tried again. Window's thread; no call but the destructor and flush() waits.
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
  /// A new file `name`.jsonl in `folder` (made if need be); "-2", "-3" … is put after a name that is taken.
  static AttemptWriter startNew(std::filesystem::path folder, std::string name);
  /// An attempt that is taken up again: lines are put after those that are in the file.
  static AttemptWriter goOn(std::filesystem::path file);

  AttemptWriter(AttemptWriter&&) noexcept;
  AttemptWriter& operator=(AttemptWriter&&) noexcept;
  /// Writes what waits, if that can be now, and ends the thread.
  ~AttemptWriter();

  /// Gives a line, with its line end, to the thread.
  void append(std::string line);

  /// The fault that keeps the lines from being written: given once each time that it begins, then nothing until it has
  /// gone.
  std::optional<Problem> takeFault();
  /// Lines have been written again after fault: true once.
  bool takeRecovered();
  /// Tries to write what waits and comes back when that has been done. False where lines still wait.
  bool flush();

  /// The file; empty until it has been opened.
  std::filesystem::path file() const;

  static constexpr double kSync_s = 1.0;   ///< at most so long between two waits for the disk
  static constexpr double kRetry_s = 3.0;  ///< after fault
  /// Beyond so much that waits in memory (unit: byte) the newest lines are dropped; the lines before stay whole.
  /// A line that is kept after dropped ones has a mark before it, which says how many there were.
  static constexpr std::size_t kMaxWaiting = std::size_t{32} << 20;

 private:
  struct Impl;
  explicit AttemptWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
