// Lesson files on the disk: reads one, and finds those in a folder. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// The bytes of a lesson's file, at most one more than kLargestLesson (which the reader then rejects). A Problem if the
/// file does not exist or cannot be read.
Expected<std::string> readLessonFile(const std::filesystem::path& file);

/// The same for a file that a lesson names: at most `max_bytes` + 1 bytes. `what_it_is` is the remedy if there is no
/// such file.
Expected<std::string> readBesideLesson(const std::filesystem::path& file, std::size_t max_bytes,
                                       const std::string& what_it_is);

/// A lesson's link or picture that refers to a file.
struct FileLink {
  std::filesystem::path file;  ///< in the lesson's folder, unless an absolute path was written
  std::string step;            ///< the text after '#'; may be empty
};

/// The file to which a link leads; nothing for links to steps ("#id") and addresses ("https:…", "mailto:…"). Escapes
/// such as "%20" are decoded.
std::optional<FileLink> fileLink(const std::filesystem::path& lesson_file, std::string_view link);

/// The scheme of an address, "https" or "mailto"; empty for a link to a file or step.
std::string_view linkScheme(std::string_view link);

/// The parts of a lesson's file name: "first-touch.de.md" is the lesson "first-touch" in German. A file without a
/// language stands for all languages that have no file of their own.
struct LessonName {
  std::string id;        ///< "first-touch"
  std::string language;  ///< "de", a code of ISO 639-1; empty: not given
};
LessonName lessonName(const std::filesystem::path& file);

/// Of the files in one folder that are the same lesson, keeps the one in this language, else the one without a
/// language, else the first. The order is kept.
std::vector<std::filesystem::path> inLanguage(std::vector<std::filesystem::path> lessons, std::string_view language);

/// Whether a Markdown file is meant as a lesson: it has front matter or a block scene, touch or answer.
bool looksLikeLesson(const std::filesystem::path& file);

struct LessonFolder {
  std::vector<std::filesystem::path> lessons;  ///< in ascending order
  std::vector<std::filesystem::path> others;   ///< Markdown files that are not lessons, such as README.md
  std::optional<Problem> fault;                ///< the folder cannot be read, or holds no lesson
};

/// The Markdown files in a folder and its subfolders, without hidden ones. A lesson is recognised by its front matter
/// or by a block scene, touch or answer. A lesson that lacks its front matter is therefore still checked.
LessonFolder lessonsIn(const std::filesystem::path& folder);

}  // namespace moltact
