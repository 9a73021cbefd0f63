// Splits a CIF file into its tokens. Internal to engine/molecule.
#pragma once

#include <string>
#include <string_view>

#include "engine/molecule/text_source.h"

namespace moltact {

class CifWords {
 public:
  enum class Kind { End, Data, Loop, Save, Tag, Value };
  explicit CifWords(TextSource& text) : text_(text) {}

  /// Reads the next token. Returns End at the end of the text and after an error, see problem().
  Kind next();
  /// The value without its quotes, or the name of the data block. Valid until the next call.
  std::string_view text() const { return word_; }
  /// True for an unquoted "." or "?": inapplicable or unknown.
  bool null() const { return null_; }
  std::size_t line() const { return line_; }
  std::size_t column() const { return column_; }
  const std::optional<Problem>& problem() const { return problem_; }
  /// A Problem at the position of the last token.
  Problem problemHere(const std::string& what) const;

 private:
  Kind fail(const std::string& what);
  bool textField();

  TextSource& text_;
  std::string_view rest_, whole_;  // the rest of the line, and the whole line
  std::string field_;              // a text field of several lines
  std::string_view word_;
  std::size_t line_ = 0, column_ = 0;
  bool null_ = false;
  std::optional<Problem> problem_;
};

}  // namespace moltact
