#include "engine/language/plural_rule.h"

#include <array>

namespace moltact {
namespace {
constexpr std::size_t kMaxNodes = 200;   // the longest rule in use, Arabic, has 42
constexpr int kMaxDepth = 40;            // of nested parentheses and choices
constexpr unsigned long kMaxForms = 16;  // Arabic has 6
}  // namespace

// Recursive descent in C's order of precedence. After an error nothing more is read.
struct PluralRule::Reader {
  std::string_view text;
  std::vector<Node>& nodes;
  bool failed = false;
  int depth = 0;

  void blank() {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  }

  bool take(std::string_view word) {
    blank();
    if (!text.starts_with(word)) return false;
    text.remove_prefix(word.size());
    return true;
  }

  std::uint16_t add(Node node) {
    if (nodes.size() >= kMaxNodes) failed = true;
    if (failed) return 0;
    nodes.push_back(node);
    return std::uint16_t(nodes.size() - 1);
  }

  unsigned long number() {
    blank();
    unsigned long out = 0;
    std::size_t digits = 0;
    for (; !text.empty() && text.front() >= '0' && text.front() <= '9'; text.remove_prefix(1), ++digits)
      out = out * 10 + static_cast<unsigned long>(text.front() - '0');
    if (digits == 0 || digits > 9) failed = true;
    return out;
  }

  std::uint16_t primary() {
    if (failed || ++depth > kMaxDepth) {
      failed = true;
      return 0;
    }
    std::uint16_t out = 0;
    blank();
    if (text.starts_with('!') && !text.starts_with("!=")) {
      text.remove_prefix(1);
      const std::uint16_t a = primary();
      out = add({Op::Not, 0, a});
    } else if (take("(")) {
      out = choice();
      if (!take(")")) failed = true;
    } else if (take("n")) {
      out = add({Op::N});
    } else {
      const unsigned long value = number();
      out = add({Op::Number, value});
    }
    --depth;
    return out;
  }

  struct Word {
    std::string_view word;
    Op op;
  };

  template <std::size_t N>
  bool operation(const std::array<Word, N>& words, Op& op) {
    for (const Word& w : words)
      if (take(w.word)) {
        op = w.op;
        return true;
      }
    return false;
  }

  // Level 0 has the highest precedence.
  bool operation(int level, Op& op) {
    switch (level) {
      case 0:
        return operation(std::array{Word{"*", Op::Multiply}, Word{"/", Op::Divide}, Word{"%", Op::Modulo}}, op);
      case 1:
        return operation(std::array{Word{"+", Op::Add}, Word{"-", Op::Subtract}}, op);
      case 2:
        return operation(std::array{Word{"<=", Op::LessEqual}, Word{">=", Op::GreaterEqual}, Word{"<", Op::Less},
                                    Word{">", Op::Greater}},
                         op);
      case 3:
        return operation(std::array{Word{"==", Op::Equal}, Word{"!=", Op::NotEqual}}, op);
      case 4:
        return operation(std::array{Word{"&&", Op::And}}, op);
      default:
        return operation(std::array{Word{"||", Op::Or}}, op);
    }
  }

  std::uint16_t binary(int level) {
    if (level < 0) return primary();
    std::uint16_t a = binary(level - 1);
    for (Op op{}; !failed && operation(level, op);) {
      const std::uint16_t b = binary(level - 1);
      a = add({op, 0, a, b});
    }
    return a;
  }

  std::uint16_t choice() {
    if (failed || ++depth > kMaxDepth) {
      failed = true;
      return 0;
    }
    std::uint16_t out = binary(5);
    if (!failed && take("?")) {
      const std::uint16_t yes = choice();
      if (!take(":")) failed = true;
      const std::uint16_t no = choice();
      out = add({Op::Choose, 0, out, yes, no});
    }
    --depth;
    return out;
  }
};

PluralRule::PluralRule() : nodes_{{Op::N}, {Op::Number, 1}, {Op::NotEqual, 0, 0, 1}} {}

std::optional<PluralRule> PluralRule::parse(std::string_view text) {
  PluralRule out;
  out.nodes_.clear();
  Reader reader{text, out.nodes_};
  if (!reader.take("nplurals") || !reader.take("=")) return std::nullopt;
  out.forms_ = reader.number();
  if (reader.failed || out.forms_ < 1 || out.forms_ > kMaxForms) return std::nullopt;
  if (!reader.take(";") || !reader.take("plural") || !reader.take("=")) return std::nullopt;
  reader.choice();
  reader.take(";");
  reader.blank();
  if (reader.failed || !reader.text.empty() || out.nodes_.empty()) return std::nullopt;
  return out;
}

unsigned long PluralRule::form(unsigned long n) const noexcept {
  // Operands precede their operators, so one pass evaluates everything. There are no side effects, so a division by
  // zero in an unselected branch is harmless.
  std::array<unsigned long, kMaxNodes> value{};
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const Node& node = nodes_[k];
    const unsigned long a = value[node.a], b = value[node.b], c = value[node.c];
    unsigned long& out = value[k];
    switch (node.op) {
      case Op::N:
        out = n;
        break;
      case Op::Number:
        out = node.number;
        break;
      case Op::Not:
        out = !a;
        break;
      case Op::Multiply:
        out = a * b;
        break;
      case Op::Divide:
        out = b ? a / b : 0;
        break;
      case Op::Modulo:
        out = b ? a % b : 0;
        break;
      case Op::Add:
        out = a + b;
        break;
      case Op::Subtract:
        out = a - b;
        break;
      case Op::Less:
        out = a < b;
        break;
      case Op::LessEqual:
        out = a <= b;
        break;
      case Op::Greater:
        out = a > b;
        break;
      case Op::GreaterEqual:
        out = a >= b;
        break;
      case Op::Equal:
        out = a == b;
        break;
      case Op::NotEqual:
        out = a != b;
        break;
      case Op::And:
        out = a && b;
        break;
      case Op::Or:
        out = a || b;
        break;
      case Op::Choose:
        out = a ? b : c;
        break;
    }
  }
  const unsigned long form = value[nodes_.size() - 1];
  return form < forms_ ? form : 0;
}

}  // namespace moltact
