// Words that lessons explain. They stand in a list, each with its meaning: below the heading "## Glossary" of a lesson,
// or in the file "glossary.md" (in German "glossary.de.md") beside the lessons of a folder, which all of them share.
//
//   - **active site**, active sites: The pocket of an enzyme in which …
//
// The word is bold; commas part it from other ways to write it; what stands behind the colon is its meaning. In a
// lesson the first of each word in a step leads to its meaning, and links do: [the pocket](#word:active-site).
// Not for the haptic thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct Glossary {
  std::filesystem::path file;  ///< empty: there is none beside the lesson
  std::vector<GlossaryWord> words;
  std::vector<Problem> errors, warnings;  ///< in the order of the file; what is wrong is left out of `words`
};

/// More words of one file are refused.
inline constexpr std::size_t kMaxGlossaryWords = 2000;

/// Reads the text of such a file; `name` is its name as messages give it.
Glossary readGlossary(const std::string& name, std::string bytes);

/// The words of the file beside a lesson: in the language that the lesson's file name gives; else in that of its front
/// matter (which may be empty), or in none. Without words where there is no such file.
Glossary glossaryBeside(const std::filesystem::path& lesson_file, std::string_view language);

/// Whether a file is one of words, by its name.
bool isGlossaryFile(const std::filesystem::path& file);

/// "Glossary", or the same in German.
bool isGlossaryHeading(std::string_view heading);

/// Which word a link means ("#word:active-site"), as its slug; nothing where it is another kind of link.
std::optional<std::string> wordLink(std::string_view link);

/// The word of that slug, by any of the ways to write it; null where there is none.
const GlossaryWord* findWord(const Lesson& lesson, std::string_view slug);

/// Adds the words of a file to those of the lesson, whose own come first, and has the first of each word in every step
/// lead to its meaning: in paragraphs, lists, quotes, hints and tables, not in headings and questions, where a meaning
/// may be asked for.
void linkWords(Lesson& lesson, const Glossary& shared);

}  // namespace moltact
