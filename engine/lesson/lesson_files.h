// Lesson files on the disk: the bytes of one, and those in a folder. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// The bytes of a lesson file, at most one more than kLargestLesson (which the reader then refuses). A problem where
/// there is no such file, or it cannot be read.
Expected<std::string> readLessonFile(const std::filesystem::path& file);

/// The same of a file that a lesson names: at most one byte more than `max_bytes`. `what_it_is` is the remedy where its
/// name leads to no file.
Expected<std::string> readBesideLesson(const std::filesystem::path& file, std::size_t max_bytes,
                                       const std::string& what_it_is);

/// A link or picture of a lesson that leads to a file.
struct FileLink {
  std::filesystem::path file;  ///< in the lesson's folder, unless it was written with its whole path
  std::string step;            ///< what stands after '#'; may be empty
};

/// Where a link leads, if to a file: nothing for links to steps ("#id") and for addresses ("https:…", "mailto:…").
/// "%20" and the like are read as the letters that they stand for.
std::optional<FileLink> fileLink(const std::filesystem::path& lesson_file, std::string_view link);

/// "https" or "mailto" of an address; empty for a link to a file or step.
std::string_view linkScheme(std::string_view link);

/// A lesson file's name: "first-touch.de.md" is the lesson "first-touch" in German; one without a language stands for
/// all languages that have none of their own.
struct LessonName {
  std::string id;        ///< "first-touch"
  std::string language;  ///< "de", a code of ISO 639-1; empty: none is named
};
LessonName lessonName(const std::filesystem::path& file);

/// The file in this language among those of one folder that are the same lesson; else the one that names none; else the
/// first. The order stays.
std::vector<std::filesystem::path> inLanguage(std::vector<std::filesystem::path> lessons, std::string_view language);

/// Whether a Markdown file means to be a lesson: it has front matter, or a block scene, touch or answer.
bool looksLikeLesson(const std::filesystem::path& file);

struct LessonFolder {
  std::vector<std::filesystem::path> lessons;  ///< ascending
  std::vector<std::filesystem::path> others;   ///< Markdown without anything of a lesson, such as README.md
  std::optional<Problem> fault;                ///< the folder cannot be read, or holds no lesson
};

/// The Markdown files in a folder and the folders in it, but hidden ones. A lesson is recognised by its front matter or
/// by a block scene, touch or answer, so that one that lost its front matter is still checked.
LessonFolder lessonsIn(const std::filesystem::path& folder);

}  // namespace moltact
