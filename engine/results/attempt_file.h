// Attempts as files: read whole or in part, and mended after a program that was cut off. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/attempt.h"

namespace moltact {

/// userDataFolder()/attempts: where attempts are kept. Empty where this computer tells no home.
std::filesystem::path attemptsFolder();

struct Attempt {
  std::filesystem::path file;
  AttemptHeader header;              ///< its lesson is the one that was read last
  std::vector<AttemptEvent> events;  ///< in the order of the file
  std::vector<Problem> problems;     ///< lines that were passed over, with their numbers
  bool torn = false;                 ///< the last line was cut off and is not among the events

  /// The latest time of its events (unit: second of use).
  double end_s() const;
};

/// How often it was worked at: 1, and once more each time that it was taken up again.
std::size_t sittingsOf(const Attempt& attempt);

enum class ReadDepth {
  All,
  NoHipSamples,  ///< without the HIP samples and the views, which are most of the file
};

/// A Problem where the file cannot be read or holds no attempt; damaged lines after the first are skipped and reported.
Expected<Attempt> readAttempt(const std::filesystem::path& file, ReadDepth depth = ReadDepth::All);

/// When the attempt began, from its first line alone; empty where the file holds no attempt.
std::string attemptBegan(const std::filesystem::path& file);

/// The .jsonl files in a folder, by name, and with `deep` in the folders within it, kDeepestAttempts deep; those that
/// are named themselves. A Problem for what is not there.
Expected<std::vector<std::filesystem::path>> attemptFiles(const std::filesystem::path& file_or_folder,
                                                          bool deep = false);
inline constexpr int kDeepestAttempts = 8;

/// Ends every attempt in the folder with a whole line again: a last line that was cut off goes, or gets its line end
/// where it was whole but for that; a file that holds no whole line goes. Attempts that a running program writes, and
/// files that are no attempts, stay as they are. Returns the files that were mended.
std::vector<std::filesystem::path> mendAttempts(const std::filesystem::path& folder);

/// The same for one file; true where it was mended.
bool mendAttempt(const std::filesystem::path& file);

/// Whether what is appended to the file begins a line. True of what is empty or not there.
bool endsWithLine(const std::filesystem::path& file);

/// Larger files are refused (unit: byte): days of touching.
inline constexpr std::size_t kLargestAttempt = std::size_t{1} << 30;

}  // namespace moltact
