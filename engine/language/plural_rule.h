// Selects the plural form for a number by the C expression of a catalogue's header, for example "nplurals=3;
// plural=n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2;" (GNU gettext manual, "Plural forms").
// Immutable; any thread except the haptic one.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace moltact {

class PluralRule {
 public:
  /// The rule of English and German: one form for 1, another for every other number.
  PluralRule();

  /// Parses "nplurals=N; plural=EXPRESSION;". Empty if the syntax is invalid, if it has more than 16 forms, or if it
  /// exceeds the limit of length.
  static std::optional<PluralRule> parse(std::string_view text);

  /// The index of the form, 0 to forms() - 1. A rule that exceeds this range or divides by zero gives 0.
  unsigned long form(unsigned long n) const noexcept;
  unsigned long forms() const noexcept { return forms_; }

 private:
  enum class Op : std::uint8_t {
    N,
    Number,
    Not,
    Multiply,
    Divide,
    Modulo,
    Add,
    Subtract,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    Choose
  };
  struct Node {
    Op op = Op::N;
    unsigned long number = 0;
    std::uint16_t a = 0, b = 0, c = 0;  // operands as indices into nodes_, always smaller than the node's own
  };
  struct Reader;

  std::vector<Node> nodes_;  // the last is the root
  unsigned long forms_ = 2;
};

}  // namespace moltact
