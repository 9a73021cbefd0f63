// Checks a lesson's language by its file name and front matter, and whether the window can display its text.
#include <algorithm>
#include <cstdio>
#include <string>

#include "engine/core/utf8.h"
#include "engine/fonts/glyph_coverage.h"
#include "engine/language/catalogue.h"
#include "engine/language/language_code.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/lesson_files.h"

namespace moltact::checks {
namespace {

constexpr std::size_t kMaxSigns = 5;  // reported per line

// "'ж' (U+0436)"
std::string signName(char32_t c, std::string_view bytes) {
  char code[16];
  std::snprintf(code, sizeof code, "U+%04X", unsigned(c));
  return "'" + std::string(bytes) + "' (" + code + ")";
}

}  // namespace

void language(const Lesson& lesson, const std::filesystem::path& lesson_file, Findings& findings) {
  const LessonName name = lessonName(lesson_file);
  const std::string ending = std::filesystem::path(name.id).extension().string();
  if (name.language.empty() && !ending.empty())
    findings.warning({1, 1}, trf("'{0}' at the end of the file's name is no language", ending.substr(1)),
                     tr("name a lesson in another language by its two letters: first-touch.de.md"));
  if (!name.language.empty() && !lesson.language.empty() && lesson.language != name.language)
    findings.error(lesson.language_place,
                   trf("the file's name says that the lesson is in '{0}', its front matter in '{1}'", name.language,
                       lesson.language),
                   tr("let both say the same"));
}

void signs(std::string_view text, Findings& findings) {
  const GlyphCoverage& table = GlyphCoverage::ofWindow();
  std::size_t number = 1;
  for (std::size_t from = 0; from < text.size() && !enoughProblems(findings.warnings); ++number) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view line = text.substr(from, end - from);
    from = end + 1;
    // Fast path for ASCII, which is most lines.
    if (std::all_of(line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; })) continue;
    std::vector<char32_t> absent, turned;
    std::size_t column = 0, at = 0;
    std::string names;
    for (const char32_t c : charactersOf(line)) {
      ++at;
      const Writable w = table.writable(c);
      if (w == Writable::Yes) continue;
      if (column == 0) column = at;
      std::vector<char32_t>& into = w == Writable::NoSign ? absent : turned;
      if (into.size() < kMaxSigns && std::find(into.begin(), into.end(), c) == into.end()) into.push_back(c);
    }
    const auto listed = [](const std::vector<char32_t>& signs) {
      std::string out;
      for (const char32_t c : signs) out += (out.empty() ? "" : ", ") + signName(c, utf8Of(c));
      return out;
    };
    const Place place{number, std::max<std::size_t>(1, column)};
    if (!absent.empty())
      findings.warning(place, trf("the window's fonts have no sign for {0}", listed(absent)),
                       tr("it is shown as '?': write it otherwise"));
    if (!turned.empty())
      findings.warning(place, trf("the window cannot set the script of {0}", listed(turned)),
                       tr("it sets signs from left to right, each for itself"));
  }
}

}  // namespace moltact::checks
