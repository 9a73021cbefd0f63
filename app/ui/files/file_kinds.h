// The kinds of files that the window opens, distinguished by name. The file browser lists them; Application::open
// selects the code that opens them. Any thread.
#pragma once

#include <filesystem>
#include <optional>

namespace moltact {

enum class FileKind {
  Molecule,    ///< a format of engine/molecule/reader.cpp
  Lesson,      ///< ".md"
  Pack,        ///< ".moltact": a lesson with all files that it needs
  Attempt,     ///< ".jsonl": a student's work on a lesson
  Recording,   ///< ".recording": every tick of a hand's motion
  Trajectory,  ///< ".xtc" and others: frames of a molecule's atoms
};

/// The extension of a recording's name.
inline constexpr const char* kRecordingEnding = ".recording";

/// The kind by the name alone, or nothing for other files.
std::optional<FileKind> fileKind(const std::filesystem::path& file);

}  // namespace moltact
