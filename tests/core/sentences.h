// The sentences of pages and comments, for a test of their length.
#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/source_text.h"

namespace moltact::test {

// A paragraph, an item of a list or a cell of a table, on one line.
struct Passage {
  std::size_t line = 0;  // where it begins, from 1
  std::string text;
  bool is_cell = false;
};

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.remove_suffix(1);
  return text;
}

inline std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

// The length of "* ", "- " or "12. " at the beginning of an item; 0 for other text.
inline std::size_t bulletOf(std::string_view text) {
  std::size_t at = 0;
  if (text.starts_with('*') || text.starts_with('-')) {
    at = 1;
  } else {
    while (at < text.size() && std::isdigit(static_cast<unsigned char>(text[at]))) ++at;
    if (at == 0 || at >= text.size() || text[at] != '.') return 0;
    ++at;
  }
  return at < text.size() && text[at] == ' ' ? at + 1 : 0;
}

// Text in backticks becomes one word, and of a link only its text remains.
inline std::string withoutCode(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (const std::size_t end = text[k] == '`' ? text.find('`', k + 1) : std::string_view::npos;
        end != std::string_view::npos) {
      out += 'X';
      k = end;
    } else if (text[k] == '[' && text.find("](", k) < text.find('[', k + 1)) {
      continue;
    } else if (text[k] == ']' && k + 1 < text.size() && text[k + 1] == '(' &&
               text.find(')', k) != std::string_view::npos) {
      k = text.find(')', k);
    } else {
      out += text[k];
    }
  }
  return out;
}

// Splits at blanks; a dash, an operator or a bullet is no word.
inline std::size_t wordsIn(std::string_view text) {
  std::size_t words = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string_view word = text.substr(at, end - at);
    words += std::any_of(word.begin(), word.end(), [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return std::isalnum(byte) || (byte >= 0xc3 && byte <= 0xd4);  // the first byte of a letter such as Å or φ
    });
    at = end + 1;
  }
  return words;
}

// A sentence ends at one of . ! ? : ; before a blank, with closing quotation marks or brackets between. The dots of
// abbreviations end none.
inline std::vector<std::string> sentencesOf(std::string_view passage) {
  constexpr std::array<std::string_view, 9> kAbbreviations{"e.g.", "i.e.", "cf.",  "vs.",  "Fig.",
                                                           "No.",  "al.",  "etc.", "Surf."};
  const std::string text = withoutCode(passage);
  std::vector<std::string> out;
  std::size_t begin = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (std::string_view(".!?:;").find(text[k]) == std::string_view::npos) continue;
    std::size_t end = k + 1;
    while (end < text.size() && std::string_view("\"')]*").find(text[end]) != std::string_view::npos) ++end;
    if (end < text.size() && text[end] != ' ') continue;
    const std::string_view before = std::string_view(text).substr(0, k + 1);
    const std::string_view word = before.substr(before.find_last_of(" (") + 1);
    if (end < text.size() && std::find(kAbbreviations.begin(), kAbbreviations.end(), word) != kAbbreviations.end())
      continue;
    out.emplace_back(trimmed(std::string_view(text).substr(begin, end - begin)));
    begin = end;
  }
  if (const std::string_view rest = trimmed(std::string_view(text).substr(begin)); !rest.empty())
    out.emplace_back(rest);
  return out;
}

// How many sentences of a cell end at . ! or ?
inline std::size_t fullSentencesIn(std::string_view cell) {
  const std::vector<std::string> all = sentencesOf(cell);
  return std::size_t(std::count_if(all.begin(), all.end(), [](const std::string& one) {
    const std::size_t last = one.find_last_not_of("\"')]*");
    return last != std::string::npos && std::string_view(".!?").find(one[last]) != std::string_view::npos;
  }));
}

// The cells of a table's row; a bar in backticks or behind "\" separates none.
inline std::vector<std::string> cellsOf(std::string_view row) {
  std::vector<std::string> out(1);
  bool code = false;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (row[k] == '`') code = !code;
    if (row[k] == '|' && !code && (k == 0 || row[k - 1] != '\\'))
      out.emplace_back();
    else
      out.back() += row[k];
  }
  return out;
}

// A page in Markdown: its paragraphs, items and cells. Headings, code, remarks and the rules of tables are left out.
inline std::vector<Passage> passagesOfPage(std::string_view page) {
  std::vector<Passage> out;
  bool code = false, open = false;  // `open`: the last passage goes on with the next line
  std::size_t number = 0;
  for (const std::string& line : linesOf(page)) {
    ++number;
    const std::string_view text = trimmed(line);
    if (text.starts_with("```")) {
      code = !code;
      open = false;
    } else if (code || (line.starts_with("    ") && !open)) {
      continue;
    } else if (text.empty() || text.starts_with('#') || text.starts_with("<!--")) {
      open = false;
    } else if (text.starts_with('|')) {
      open = false;
      if (text.find_first_not_of("|-: ") == std::string_view::npos) continue;
      for (const std::string& cell : cellsOf(text))
        if (!trimmed(cell).empty()) out.push_back({number, std::string(trimmed(cell)), true});
    } else if (const std::size_t bullet = bulletOf(text); bullet > 0 || !open) {
      out.push_back({number, std::string(text.substr(bullet)), false});
      open = true;
    } else {
      out.back().text.append(" ").append(text);
    }
  }
  return out;
}

// The comments of a C++ source after "//". A comment goes on in the next line if that has no code and begins in the same
// column with the same sign ("//", "///", "///<"). Lines in columns, and indented lines outside of items, are tables.
inline std::vector<Passage> passagesOfSource(const std::string& source) {
  const std::vector<std::string> lines = linesOf(source), comments = linesOf(halvesOf(source).comments);
  std::vector<Passage> out;
  std::size_t column = 0;
  std::string sign;
  enum class Last { None, Text, Item } last = Last::None;
  for (std::size_t number = 1; number <= lines.size(); ++number) {
    const std::string& line = lines[number - 1];
    std::size_t start = line.find("//");  // of the comment, and not of "//" in a literal
    while (start != std::string::npos &&
           line.compare(start + 2, std::string::npos, comments[number - 1], start + 2) != 0)
      start = line.find("//", start + 1);
    if (start == std::string::npos) {
      last = Last::None;
      continue;
    }
    const std::size_t behind = std::min(line.find_first_not_of("/!<", start), line.size());
    std::string_view text = std::string_view(line).substr(behind);
    if (text.starts_with(' ')) text.remove_prefix(1);
    const std::string now = line.substr(start, behind - start);
    const bool alone = line.find_first_not_of(' ') == start;  // with code before it, it is of that code only
    if (now != sign || start != column || !alone) last = Last::None;
    sign = now, column = start;
    const bool indented = text.starts_with("  ");
    text = trimmed(text);
    if (text.empty()) {
      last = Last::None;
    } else if (const std::size_t bullet = bulletOf(text); bullet > 0) {
      out.push_back({number, std::string(text.substr(bullet)), false});
      last = Last::Item;
    } else if (text.find("  ") != std::string_view::npos || (indented && last != Last::Item)) {
      for (std::size_t end = 0; !text.empty(); text = trimmed(text.substr(end))) {
        end = std::min(text.find("  "), text.size());
        out.push_back({number, std::string(text.substr(0, end)), false});
      }
      last = Last::None;
    } else if (last == Last::Text || (last == Last::Item && indented)) {
      out.back().text.append(" ").append(text);
    } else {
      out.push_back({number, std::string(text), false});
      last = Last::Text;
    }
  }
  return out;
}

// The literals of a C++ source, adjacent ones joined, one passage for each of their lines.
inline std::vector<Passage> passagesOfLiterals(const std::string& source) {
  const Halves halves = halvesOf(source);
  std::vector<Passage> out;
  bool joins = false;  // only blanks stand behind the last literal
  std::size_t number = 1;
  for (std::size_t at = 0; at < source.size(); ++at) {
    number += source[at] == '\n';
    if (halves.code[at] != ' ' && halves.code[at] != '\n') joins = false;
    if (source[at] != '"' || (at > 0 && source[at - 1] == '\'') || halves.code[at] != ' ' || halves.comments[at] != ' ')
      continue;
    if (!joins) out.push_back({number, "", false});
    for (++at; at < source.size() && source[at] != '"'; ++at) {
      if (source[at] == '\n')  // of a raw literal
        out.push_back({++number, "", false});
      else if (source[at] != '\\')
        out.back().text += source[at];
      else if (source[++at] == 'n')
        out.push_back({number, "", false});
      else
        out.back().text += source[at];
    }
    joins = true;
  }
  return out;
}

// "12: 34 words: the sentence" for each sentence of more than `most` words, and "12: 3 sentences: the cell" for each
// cell of more than two.
inline std::vector<std::string> tooLongIn(const std::vector<Passage>& passages, std::size_t most = 30) {
  std::vector<std::string> out;
  for (const Passage& one : passages) {
    for (const std::string& sentence : sentencesOf(one.text))
      if (const std::size_t words = wordsIn(sentence); words > most)
        out.push_back(std::to_string(one.line) + ": " + std::to_string(words) + " words: " + sentence);
    if (const std::size_t full = one.is_cell ? fullSentencesIn(one.text) : 0; full > 2)
      out.push_back(std::to_string(one.line) + ": " + std::to_string(full) + " sentences in a cell: " + one.text);
  }
  return out;
}

}  // namespace moltact::test
