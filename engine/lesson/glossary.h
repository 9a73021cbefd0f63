// The words that lessons explain. They are a list of words with their meanings, below the heading "## Glossary" of a
// lesson. A file "glossary.md" (in German "glossary.de.md") is shared by all lessons of its folder.
//
//   - **active site**, active sites: The pocket of an enzyme in which …
//
// The word is bold; commas separate other forms of it; the meaning follows the colon. In each step, the first
// occurrence of a word links to its meaning. Explicit links do too: [the pocket](#word:active-site). Not for the haptic
// thread.
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
  std::filesystem::path file;  ///< empty: the lesson's folder has none
  std::vector<GlossaryWord> words;
  std::vector<Problem> errors, warnings;  ///< in the order of the file; faulty entries are not in `words`
};

/// A file with more words is rejected.
inline constexpr std::size_t kMaxGlossaryWords = 2000;

/// Reads the text of a glossary; `name` is its name in messages.
Glossary readGlossary(const std::string& name, std::string bytes);

/// The glossary in the lesson's folder. Its language is that of the lesson's file name; otherwise that of the front
/// matter (may be empty) or none. Without words if there is no such file.
Glossary glossaryBeside(const std::filesystem::path& lesson_file, std::string_view language);

/// Whether a file is a glossary, by its name.
bool isGlossaryFile(const std::filesystem::path& file);

/// "Glossary", or the same in German.
bool isGlossaryHeading(std::string_view heading);

/// The slug of the word to which a link leads ("#word:active-site"), or nothing for other links.
std::optional<std::string> wordLink(std::string_view link);

/// The word with that slug in any of its forms; null if there is none.
const GlossaryWord* findWord(const Lesson& lesson, std::string_view slug);

/// Adds the words of a file to those of the lesson, whose own have precedence. Links the first occurrence of each word
/// in every step to its meaning: in paragraphs, lists, quotes, hints and tables. Headings and questions get no links,
/// because a question may ask for the meaning.
void linkWords(Lesson& lesson, const Glossary& shared);

}  // namespace moltact
