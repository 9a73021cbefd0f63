// The kinds of file that the window opens, distinguished by their names: what the file browser lists, and what
// Application::open hands to whom. Any thread.
#pragma once

#include <filesystem>
#include <optional>

namespace moltact {

enum class FileKind {
  Molecule,   ///< what engine/molecule/reader.cpp has a format for
  Lesson,     ///< ".md"
  Pack,       ///< ".moltact": a lesson with all that it needs
  Attempt,    ///< ".jsonl": what a student did in a lesson
  Recording,  ///< ".recording": a hand, every tick of it
};

/// The ending of a recording's name.
inline constexpr const char* kRecordingEnding = ".recording";

/// By the name alone; nothing for a file that is none of these.
std::optional<FileKind> fileKind(const std::filesystem::path& file);

}  // namespace moltact
