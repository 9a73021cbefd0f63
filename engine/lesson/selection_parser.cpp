#include <charconv>
#include <optional>

#include "engine/language/catalogue.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/selection.h"
#include "engine/lesson/selection_node.h"
#include "engine/lesson/selection_slips.h"
#include "engine/lesson/source_text.h"
#include "engine/lesson/suggestion.h"
#include "engine/molecule/elements.h"

namespace moltact {
namespace {

using Node = SelectionNode;
using NodePtr = std::shared_ptr<const Node>;
using Takes = SelectionWord::Takes;

constexpr std::string_view kJoiners[] = {"and", "or", "not", "within", "of", "bonded", "to"};

struct Token {
  std::string_view text;
  std::size_t at = 0;  // offset in the text (unit: byte)
  bool quoted = false;
  bool end() const { return !quoted && text.empty(); }
  bool is(std::string_view word) const { return !quoted && text == word; }
};

const SelectionWord* findWord(const Token& token) {
  if (token.quoted) return nullptr;
  for (const SelectionWord& w : selectionWords())
    if (w.word == token.text) return &w;
  return nullptr;
}

/// An example of the argument, for messages about a missing one.
std::string_view exampleFor(Takes takes) {
  switch (takes) {
    case Takes::Names:
      return "A";
    case Takes::OptionalNames:
      return "HEM";
    case Takes::Residues:
      return "52";
    case Takes::Indices:
      return "0";
    case Takes::Elements:
      return "O";
    case Takes::Nothing:
      break;
  }
  return {};
}

bool isJoiner(const Token& token) {
  for (std::string_view j : kJoiners)
    if (token.is(j)) return true;
  return token.is("(") || token.is(")");
}

std::uint8_t atomicNumber(std::string_view symbol) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  for (int number = 1; number <= kElementCount; ++number) {
    const std::string_view known = element(number).symbol;
    if (known.size() != symbol.size()) continue;
    bool same = true;
    for (std::size_t i = 0; i < known.size(); ++i) same = same && lower(known[i]) == lower(symbol[i]);
    if (same) return static_cast<std::uint8_t>(number);
  }
  return 0;
}

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) { advance(); }

  Expected<Selection> parse() {
    if (next_.end()) return problem(next_, tr("a selection is missing"), tr("for example: resname HEM"));
    NodePtr root = readOr(0);
    if (root && !next_.end()) {
      if (next_.is(")"))
        fail(next_, tr("a closing bracket without its opening one"), tr("take it out"));
      else
        fail(next_, trf("'{0}' does not belong here", next_.text), tr("join two selections with 'and' or 'or'"));
    }
    if (problem_) return *problem_;
    return Selection(std::string(stripped(text_)), std::move(root));
  }

 private:
  Problem problem(const Token& at, std::string message, std::string remedy) const {
    return {{}, 0, columnOf(at), std::move(message), std::move(remedy)};
  }
  std::size_t columnOf(const Token& token) const { return characterCount(text_.substr(0, token.at)) + 1; }
  NodePtr fail(const Token& at, std::string message, std::string remedy) {
    if (!problem_) problem_ = problem(at, std::move(message), std::move(remedy));
    return nullptr;
  }

  void advance() {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; };
    while (at_ < text_.size() && isSpace(text_[at_])) ++at_;
    next_ = {text_.substr(at_, 0), at_, false};
    if (at_ == text_.size()) return;
    if (text_[at_] == '(' || text_[at_] == ')') {
      next_.text = text_.substr(at_++, 1);
      return;
    }
    if (text_[at_] == '"') {
      const std::size_t close = std::min(text_.find('"', at_ + 1), text_.size());
      next_ = {text_.substr(at_ + 1, close - at_ - 1), at_, true};
      if (close == text_.size()) fail(next_, tr("a quotation mark without its partner"), tr("close the name with \""));
      at_ = std::min(close + 1, text_.size());
      return;
    }
    const std::size_t start = at_;
    while (at_ < text_.size() && !isSpace(text_[at_]) && text_[at_] != '(' && text_[at_] != ')' && text_[at_] != '"')
      ++at_;
    next_.text = text_.substr(start, at_ - start);
  }

  NodePtr join(SelectionKind kind, NodePtr left, NodePtr right) {
    Node node;
    node.kind = kind;
    node.left = std::move(left);
    node.right = std::move(right);
    return std::make_shared<const Node>(std::move(node));
  }

  NodePtr readOr(int depth) {
    NodePtr left = readAnd(depth);
    while (left && next_.is("or")) {
      if (++joined_ > kMaxJoined)
        return fail(next_, tr("the selection is too long"), tr("use ranges or several names: residue 10-20 25"));
      advance();
      NodePtr right = readAnd(depth);
      if (!right) return nullptr;
      left = join(SelectionKind::Or, std::move(left), std::move(right));
    }
    return left;
  }

  NodePtr readAnd(int depth) {
    NodePtr left = readNot(depth);
    while (left && next_.is("and")) {
      if (++joined_ > kMaxJoined)
        return fail(next_, tr("the selection is too long"), tr("join fewer parts with 'and'"));
      advance();
      NodePtr right = readNot(depth);
      if (!right) return nullptr;
      left = join(SelectionKind::And, std::move(left), std::move(right));
    }
    return left;
  }

  NodePtr readNot(int depth) {
    if (depth >= kDeepestSelection)
      return fail(next_, tr("the selection is nested too deeply"), tr("use fewer brackets"));
    if (next_.is("not")) {
      advance();
      NodePtr inner = readNot(depth + 1);
      return inner ? join(SelectionKind::Not, std::move(inner), nullptr) : nullptr;
    }
    if (next_.is("within")) return readWithin(depth);
    if (next_.is("bonded")) return readBonded(depth);
    if (next_.is("(")) {
      const Token open = next_;
      advance();
      NodePtr inner = readOr(depth + 1);
      if (!inner) return nullptr;
      if (!next_.is(")")) return fail(open, tr("an opening bracket without its closing one"), tr("add ')'"));
      advance();
      return inner;
    }
    return readWord();
  }

  NodePtr readWithin(int depth) {
    advance();
    const std::size_t start = next_.at;
    while (!next_.end() && !next_.is("of") && !next_.is("(") && !next_.is(")")) advance();
    if (!next_.is("of"))
      return fail(next_, tr("'within' needs a distance and 'of'"), tr("write: within 5 Å of (resname HEM)"));
    const std::string_view written = text_.substr(start, next_.at - start);
    const auto distance = parseQuantity(written, Dimension::Length);
    if (!distance) {
      Problem p = distance.problem();
      p.column += characterCount(text_.substr(0, start));
      if (!problem_) problem_ = std::move(p);
      return nullptr;
    }
    if (*distance < 0.0)
      return fail({written, start, false}, tr("a distance below zero"), tr("write: within 5 Å of (resname HEM)"));
    advance();
    NodePtr inner = readNot(depth + 1);
    if (!inner) return nullptr;
    Node node;
    node.kind = SelectionKind::Within;
    node.distance_A = *distance;
    node.left = std::move(inner);
    return std::make_shared<const Node>(std::move(node));
  }

  NodePtr readBonded(int depth) {
    advance();
    if (!next_.is("to")) return fail(next_, tr("'bonded' needs 'to'"), tr("write: bonded to (element Fe)"));
    advance();
    NodePtr inner = readNot(depth + 1);
    return inner ? join(SelectionKind::BondedTo, std::move(inner), nullptr) : nullptr;
  }

  NodePtr readWord() {
    const Token token = next_;
    const SelectionWord* word = findWord(token);
    if (!word) {
      if (token.end() || isJoiner(token))
        return fail(
            token,
            token.end() ? tr("the selection ends too early") : trf("a selection is missing before '{0}'", token.text),
            tr("for example: resname HEM"));
      std::vector<std::string_view> known;
      for (const SelectionWord& w : selectionWords()) known.push_back(w.word);
      for (const std::string_view j : kJoiners)
        if (j != "of" && j != "to") known.push_back(j);
      std::string_view rest = stripped(text_.substr(at_));
      std::string remedy = otherLanguage(token.text, rest.substr(0, rest.find_first_of(" \t,()")));
      if (remedy.empty()) remedy = suggest(token.text, known, tr("words"));
      return fail(token, trf("'{0}' is no word of a selection", token.text), std::move(remedy));
    }
    advance();
    Node node;
    node.kind = word->kind;
    node.column = columnOf(token);
    node.atom_class = word->atom_class;
    if (word->takes == Takes::Nothing) return std::make_shared<const Node>(std::move(node));
    std::size_t count = 0;
    for (; !next_.end() && !isJoiner(next_) && !findWord(next_); ++count) {
      node.columns.push_back(columnOf(next_));
      if (!readItem(*word, node)) return nullptr;
      advance();
    }
    if (count == 0 && word->takes != Takes::OptionalNames) {
      return fail(next_, trf("'{0}' needs something after it", word->word),
                  trf("for example: {0}", std::string(word->word) + ' ' + std::string(exampleFor(word->takes))));
    }
    return std::make_shared<const Node>(std::move(node));
  }

  bool readItem(const SelectionWord& word, Node& node) {
    switch (word.takes) {
      case Takes::Names:
      case Takes::OptionalNames:
        node.names.emplace_back(next_.text);
        return true;
      case Takes::Elements: {
        const std::uint8_t number = atomicNumber(next_.text);
        if (number == 0)
          fail(next_, trf("'{0}' is no chemical element", next_.text), tr("write its symbol: C, N, O, Fe"));
        node.elements.push_back(number);
        return number != 0;
      }
      case Takes::Residues:
      case Takes::Indices:
        return readRange(word, node);
      case Takes::Nothing:
        break;
    }
    return false;
  }

  bool readRange(const SelectionWord& word, Node& node) {
    const char* at = next_.text.data();
    const char* end = at + next_.text.size();
    NumberRange range;
    bool good = false;
    if (auto [p, e] = std::from_chars(at, end, range.first); e == std::errc{}) {
      range.last = range.first;
      good = p == end;
      if (!good && *p == '-') {
        const auto [q, e2] = std::from_chars(p + 1, end, range.last);
        good = e2 == std::errc{} && q == end && range.last >= range.first;
      } else if (!good && word.takes == Takes::Residues && p + 1 == end && *p >= 'A' && *p <= 'Z') {
        range.insertion = *p;
        good = true;
      }
    }
    if (good && word.takes == Takes::Indices && range.first < 0) good = false;
    if (!good && next_.text.find('+') != std::string_view::npos)
      fail(next_, trf("'{0}' is no {1} number", next_.text, word.word),
           didYouMean(std::string(word.word) + ' ' + withBlanks(next_.text)));
    else if (!good)
      fail(next_, trf("'{0}' is no {1} number", next_.text, word.word),
           word.takes == Takes::Residues ? tr("write 52, 10-20 or 52A")
                                         : tr("atoms are counted from 0: write 3 or 0-5"));
    node.numbers.push_back(range);
    return good;
  }

  // A chain of `or` gives a tree of the same depth, which is evaluated recursively.
  static constexpr int kMaxJoined = 500;

  std::string_view text_;
  std::size_t at_ = 0;
  int joined_ = 0;
  Token next_;
  std::optional<Problem> problem_;
};

}  // namespace

const std::vector<SelectionWord>& selectionWords() {
  using K = SelectionKind;
  static const std::vector<SelectionWord> words = [] {
    std::vector<SelectionWord> out{
        {"all", K::All, Takes::Nothing, "every atom"},
        {"chain", K::Chain, Takes::Names, "chains by name: chain A B"},
        {"residue", K::Residue, Takes::Residues, "residues by number: residue 52, residue 10-20, residue 52A"},
        {"resname", K::Resname, Takes::Names, "residues by name: resname ASP"},
        {"name", K::Name, Takes::Names, "atoms by name: name CA"},
        {"element", K::Element, Takes::Elements, "atoms by element symbol: element O"},
        {"atom", K::AtomIndex, Takes::Indices, "atoms by index from 0: atom 3, atom 0-5"},
        {"ligand", K::Ligand, Takes::OptionalNames, "bound small molecules: ligand, ligand HEM"},
    };
    for (const AtomClass& c : atomClasses()) out.push_back({c.word, K::Class, Takes::Nothing, c.meaning, &c});
    return out;
  }();
  return words;
}

Expected<Selection> parseSelection(std::string_view text) { return Parser(text).parse(); }

}  // namespace moltact
