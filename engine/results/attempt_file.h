// Files of attempts: reads them completely or in part, and repairs them after an interrupted write. Any thread but the
// haptic one.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/attempt.h"

namespace moltact {

/// userDataFolder()/attempts: the folder of the attempts. Empty if the computer has no home folder.
std::filesystem::path attemptsFolder();

struct Attempt {
  std::filesystem::path file;
  AttemptHeader header;              ///< with the outline of the lesson as read last
  std::vector<AttemptEvent> events;  ///< in the order of the file
  std::vector<Problem> problems;     ///< skipped lines, with their numbers
  bool torn = false;                 ///< the last line is incomplete and not among the events

  /// The latest time of its events (unit: second of use).
  double end_s() const;
};

/// The number of sittings: 1, plus one for each time that it was resumed.
std::size_t sittingsOf(const Attempt& attempt);

enum class ReadDepth {
  All,
  NoHipSamples,  ///< without HIP samples and views, which are most of the file
};

/// Returns a Problem if the file cannot be read or is not an attempt. Damaged lines after the first are skipped and
/// reported.
Expected<Attempt> readAttempt(const std::filesystem::path& file, ReadDepth depth = ReadDepth::All);

/// The time at which the attempt began, from the first line only; empty if the file is not an attempt.
std::string attemptBegan(const std::filesystem::path& file);

/// The .jsonl files in a folder, by name; with `deep` also in subfolders, down to kDeepestAttempts levels. A named file
/// is returned itself. Returns a Problem if nothing of this name exists.
Expected<std::vector<std::filesystem::path>> attemptFiles(const std::filesystem::path& file_or_folder,
                                                          bool deep = false);
inline constexpr int kDeepestAttempts = 8;

/// Repairs every attempt in the folder, so that it ends with a complete line. An incomplete last line is removed; a
/// last line that lacks only its line end gets one. A file without any complete line is deleted. Attempts that a
/// running program writes and other files stay unchanged. Returns the repaired files.
std::vector<std::filesystem::path> mendAttempts(const std::filesystem::path& folder);

/// Repairs one file; returns whether it was changed.
bool mendAttempt(const std::filesystem::path& file);

/// Whether text appended to the file begins a new line. Also true if the file is empty or missing.
bool endsWithLine(const std::filesystem::path& file);

/// Larger files are rejected (unit: byte). This is enough for days of touching.
inline constexpr std::size_t kLargestAttempt = std::size_t{1} << 30;

}  // namespace moltact
