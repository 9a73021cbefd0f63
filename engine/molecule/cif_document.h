// Reads the structure of a CIF file, for both readers of CIF: data blocks, loops, and tags with their values. Internal to
// engine/molecule.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/molecule/cif_words.h"
#include "engine/molecule/parsed_structure.h"

namespace moltact {

/// Parses a CIF number, with or without its uncertainty in brackets: "1.234(5)".
inline bool parseCifNumber(std::string_view word, double& value) {
  return parseNumber(word.substr(0, word.find('(')), value);
}

/// Passes the parts of a file to a `Taker` in the order of the file, until one of its functions returns a Problem:
///
///   block(name)   a data block begins
///   pair(tag)     a tag with a single value, which is words.text()
///   loop(tags)    a loop begins
///   cell(column)  a value of the loop, words.text()
///   row()         the row of the loop is complete
///   end()         the text has ended
///
/// Returns that Problem, or the one that ended the text. Save frames occur in dictionaries only; they are skipped.
template <class Taker>
std::optional<Problem> readCifDocument(TextSource& text, CifWords& words, Taker& taker) {
  using Kind = CifWords::Kind;
  // After an error the text ends, and that error is the one to report.
  const auto problem = [&](const std::string& what) {
    return words.problem() ? *words.problem() : text.problem() ? *text.problem() : words.problemHere(what);
  };
  Kind kind = words.next();
  if (kind != Kind::Data && kind != Kind::End) return problem(tr("a data block 'data_…' is to come first"));
  while (kind != Kind::End) {
    if (kind == Kind::Data) {
      if (auto bad = taker.block(words.text())) return bad;
      kind = words.next();
    } else if (kind == Kind::Loop) {
      std::vector<std::string> tags;
      for (kind = words.next(); kind == Kind::Tag; kind = words.next()) tags.emplace_back(words.text());
      if (tags.empty()) return problem(tr("a loop without tags"));
      taker.loop(tags);
      std::size_t column = 0;
      for (; kind == Kind::Value; kind = words.next()) {
        if (auto bad = taker.cell(column)) return bad;
        if (++column < tags.size()) continue;
        column = 0;
        if (auto bad = taker.row()) return bad;
      }
      if (column != 0) return problem(tr("the values of a loop do not fill its last row"));
    } else if (kind == Kind::Tag) {
      const std::string tag(words.text());
      kind = words.next();
      if (kind != Kind::Value) return problem(trf("the tag {0} has no value", inQuotes(tag)));
      if (auto bad = taker.pair(tag)) return bad;
      kind = words.next();
    } else if (kind == Kind::Save) {
      kind = words.next();
    } else {
      return problem(trf("a value without a tag: {0}", inQuotes(words.text())));
    }
  }
  if (words.problem()) return words.problem();
  if (text.problem()) return text.problem();
  return taker.end();
}

}  // namespace moltact
