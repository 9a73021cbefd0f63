// The words of a CIF file, one after the other, as the text comes. Inside engine/molecule only.
#pragma once

#include <string>
#include <string_view>

#include "engine/molecule/text_source.h"

namespace moltact {

class CifWords {
 public:
  enum class Kind { End, Data, Loop, Save, Tag, Value };
  explicit CifWords(TextSource& text) : text_(text) {}

  /// The next word; End at the end, and where there is a problem, the text's own or one of the syntax.
  Kind next();
  /// The text of a value without its quotes; the name in `data_name`. Valid until the next call.
  std::string_view text() const { return word_; }
  /// A value without quotes that is "." or "?": not known, or not meant.
  bool null() const { return null_; }
  std::size_t line() const { return line_; }
  std::size_t column() const { return column_; }
  const std::optional<Problem>& problem() const { return problem_; }
  /// At the last word.
  Problem problemHere(const std::string& what) const;

 private:
  Kind fail(const std::string& what);
  bool textField();

  TextSource& text_;
  std::string_view rest_, whole_;  // of the line, and the line
  std::string field_;              // a text of several lines
  std::string_view word_;
  std::size_t line_ = 0, column_ = 0;
  bool null_ = false;
  std::optional<Problem> problem_;
};

}  // namespace moltact
