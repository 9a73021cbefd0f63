#include "engine/molecule/cif_words.h"

#include "engine/core/text.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxTextBytes = std::size_t{32} << 20;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// True if the word starts with `start`, ignoring case.
bool beginsWith(std::string_view word, std::string_view start) {
  if (word.size() < start.size()) return false;
  for (std::size_t i = 0; i < start.size(); ++i)
    if ((word[i] >= 'A' && word[i] <= 'Z' ? word[i] + ('a' - 'A') : word[i]) != start[i]) return false;
  return true;
}

}  // namespace

Problem CifWords::problemHere(const std::string& what) const {
  return {text_.file(), line_, column_, trf("it is not sound CIF: {0}", what),
          tr("correct the file, or take it again from its source")};
}

CifWords::Kind CifWords::fail(const std::string& what) {
  problem_ = problemHere(what);
  return Kind::End;
}

// Text from a ';' at the start of a line to the next line that starts with one.
bool CifWords::textField() {
  field_.assign(rest_.substr(1));
  while (text_.next(whole_)) {
    if (whole_.starts_with(';')) {
      rest_ = whole_.substr(1);
      if (!field_.empty() && field_.back() == '\r') field_.pop_back();
      word_ = field_;
      return true;
    }
    if (field_.size() + whole_.size() > kMaxTextBytes) {
      problem_ = problemHere(tr("a text of more than 32 MiB"));
      return false;
    }
    field_.append("\n").append(whole_);
  }
  problem_ = problemHere(tr("a text that begins with ';' has no end"));
  return false;
}

CifWords::Kind CifWords::next() {
  if (problem_) return Kind::End;
  null_ = false;
  for (;;) {
    while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
    if (!rest_.empty() && rest_.front() != '#') break;
    if (!text_.next(whole_)) return Kind::End;
    rest_ = whole_;
    if (!rest_.starts_with(';')) continue;
    line_ = text_.number(), column_ = 1;
    return textField() ? Kind::Value : Kind::End;
  }
  line_ = text_.number();
  column_ = static_cast<std::size_t>(rest_.data() - whole_.data()) + 1;
  const char first = rest_.front();
  if (first == '\'' || first == '"') {
    // A quote ends the text if whitespace follows.
    std::size_t end = 1;
    while ((end = rest_.find(first, end)) != std::string_view::npos && end + 1 < rest_.size() &&
           !isBlank(rest_[end + 1]))
      ++end;
    if (end == std::string_view::npos) return fail(tr("the quoted text has no end"));
    word_ = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    return Kind::Value;
  }
  std::size_t end = 0;
  while (end < rest_.size() && !isBlank(rest_[end])) ++end;
  word_ = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (first == '_') return Kind::Tag;
  switch (first | 0x20) {
    case 'd':
      if (!beginsWith(word_, "data_")) break;
      word_.remove_prefix(5);
      return Kind::Data;
    case 'l':
      if (word_.size() == 5 && beginsWith(word_, "loop_")) return Kind::Loop;
      break;
    case 's':
      if (beginsWith(word_, "save_")) return Kind::Save;
      break;
    default:
      break;
  }
  null_ = word_ == "." || word_ == "?";
  return Kind::Value;
}

}  // namespace moltact
