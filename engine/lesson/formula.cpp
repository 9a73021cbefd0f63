#include "engine/lesson/formula.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/letters.h"

namespace moltact {
namespace {

struct Command {
  std::string_view name, text;
};

// Blanks surround relations; operators that bind more tightly have none.
constexpr Command kSigns[] = {{"cdot", " · "},
                              {"times", " × "},
                              {"pm", " ± "},
                              {"mp", " ∓ "},
                              {"approx", " ≈ "},
                              {"sim", " ∼ "},
                              {"le", " ≤ "},
                              {"leq", " ≤ "},
                              {"ge", " ≥ "},
                              {"geq", " ≥ "},
                              {"ne", " ≠ "},
                              {"neq", " ≠ "},
                              {"equiv", " ≡ "},
                              {"propto", " ∝ "},
                              {"to", " → "},
                              {"rightarrow", " → "},
                              {"leftarrow", " ← "},
                              {"leftrightarrow", " ↔ "},
                              {"rightleftharpoons", " ⇌ "},
                              {"infty", "∞"},
                              {"degree", "°"},
                              {"circ", "°"},
                              {"AA", "Å"},
                              {"partial", "∂"},
                              {"nabla", "∇"},
                              {"sum", "∑"},
                              {"int", "∫"},
                              {"prime", "′"},
                              {"ldots", "…"},
                              {"dots", "…"},
                              {"quad", "  "},
                              {"left", ""},
                              {"right", ""},
                              {"min", " min "},
                              {"max", " max "},
                              {"sin", " sin "},
                              {"cos", " cos "},
                              {"tan", " tan "},
                              {"exp", " exp "},
                              {"ln", " ln "},
                              {"log", " log "},
                              {"Gamma", "Γ"},
                              {"Delta", "Δ"},
                              {"Theta", "Θ"},
                              {"Lambda", "Λ"},
                              {"Xi", "Ξ"},
                              {"Pi", "Π"},
                              {"Sigma", "Σ"},
                              {"Phi", "Φ"},
                              {"Psi", "Ψ"},
                              {"Omega", "Ω"}};
constexpr Command kSlanted[] = {{"alpha", "α"},      {"beta", "β"},   {"gamma", "γ"}, {"delta", "δ"}, {"epsilon", "ε"},
                                {"varepsilon", "ε"}, {"zeta", "ζ"},   {"eta", "η"},   {"theta", "θ"}, {"iota", "ι"},
                                {"kappa", "κ"},      {"lambda", "λ"}, {"mu", "μ"},    {"nu", "ν"},    {"xi", "ξ"},
                                {"pi", "π"},         {"rho", "ρ"},    {"sigma", "σ"}, {"tau", "τ"},   {"upsilon", "υ"},
                                {"phi", "φ"},        {"varphi", "φ"}, {"chi", "χ"},   {"psi", "ψ"},   {"omega", "ω"}};

constexpr int kDeepest = 8;  // nesting of braces

const Command* findIn(std::span<const Command> table, std::string_view name) {
  const auto at = std::find_if(table.begin(), table.end(), [&](const Command& c) { return c.name == name; });
  return at == table.end() ? nullptr : &*at;
}

class FormulaReader {
 public:
  FormulaReader(std::string_view formula, Place place, std::vector<Problem>& problems)
      : all_(formula), place_(place), problems_(problems) {}

  RichText read() {
    while (at_ < all_.size()) {
      if (all_[at_] == '}') {
        tell(at_, tr("'}' in this formula closes nothing"), tr("take it out, or open it with '{' before"));
        ++at_;
        continue;
      }
      term(Script::None, false, 0);
    }
    return std::move(out_);
  }

 private:
  void tell(std::size_t at, std::string message, std::string remedy) {
    problems_.push_back(
        {{}, place_.line, place_.column + characterCount(all_.substr(0, at)), std::move(message), std::move(remedy)});
  }

  void add(std::string_view text, bool slanted, Script script) {
    // Collapses blanks and removes them at the beginning.
    std::string words;
    for (const char c : text) {
      const char before = !words.empty() ? words.back() : !out_.empty() ? out_.back().text.back() : ' ';
      if (c != ' ' || before != ' ') words += c;
    }
    if (words.empty()) return;
    if (!out_.empty() && out_.back().italic == slanted && out_.back().script == script)
      out_.back().text += words;
    else
      out_.push_back({.text = std::move(words), .italic = slanted, .script = script, .place = place_});
  }

  static bool isDigit(char c) { return c >= '0' && c <= '9'; }

  // Whether the last item is a letter, a number or a bracket, so that a following minus is binary.
  bool isOperand() const {
    if (out_.empty()) return false;
    const std::string& last = out_.back().text;
    return endsInLetter(last) || last.back() == ')';
  }

  // "10^-9" and "x^12" mean the whole number, although LaTeX would use only its first character.
  bool signedNumber(Script script) {
    std::size_t end = at_;
    if (all_[end] == '-' || all_[end] == '+') ++end;
    const std::size_t digits = end;
    while (end < all_.size() && isDigit(all_[end])) ++end;
    if (end == digits) return false;
    add(all_[at_] == '-' ? "−" + std::string(all_.substr(digits, end - digits))
                         : std::string(all_.substr(at_, end - at_)),
        false, script);
    at_ = end;
    return true;
  }

  // Parses the next item: a character, a command, or a group in braces.
  void term(Script script, bool upright, int depth) {
    const char c = all_[at_];
    if (c == '{' && depth < kDeepest) {
      const std::size_t open = at_++;
      while (at_ < all_.size() && all_[at_] != '}') term(script, upright, depth + 1);
      if (at_ == all_.size())
        tell(open, tr("'{' in this formula is not closed"), tr("close it with '}'"));
      else
        ++at_;
    } else if (c == '\\') {
      command(script, upright, depth);
    } else if (c == '^' || c == '_') {
      const std::size_t at = at_++;
      if (script != Script::None)
        tell(at, tr("a script within a script cannot be shown"), tr("write it beside the line once, as in x_{ab}"));
      const Script to = script != Script::None ? script : c == '^' ? Script::Super : Script::Sub;
      while (at_ < all_.size() && all_[at_] == ' ') ++at_;
      if (at_ == all_.size() || all_[at_] == '}')
        tell(at, trf("nothing follows '{0}' in this formula", std::string(1, c)),
             tr("write what stands beside the line: x^2"));
      else if (!signedNumber(to))
        term(to, upright, depth);
    } else {
      const CodePoint p = firstCodePoint(all_.substr(at_));
      const std::string_view sign = all_.substr(at_, p.bytes);
      at_ += p.bytes;
      if (sign == "-")
        add(script == Script::None && isOperand() ? " − " : "−", false, script);
      else if (script == Script::None && (c == '=' || c == '+' || c == '<' || c == '>'))
        add(" " + std::string(sign) + " ", false, script);
      else
        add(sign, !upright && p.valid && isLetter(p.code) && !isDigit(c), script);
    }
  }

  // Parses the argument of a command: a group in braces, or the next character.
  void argument(Script script, bool upright, int depth, std::size_t command_at) {
    while (at_ < all_.size() && all_[at_] == ' ') ++at_;
    if (at_ == all_.size() || all_[at_] == '}')
      tell(command_at, tr("this command of the formula needs something in braces"), tr("write it behind: \\sqrt{x}"));
    else
      term(script, upright, depth + 1);
  }

  static std::string withoutBreaks(const std::string& text) {
    std::string out;
    for (const char c : text) out += c == ' ' ? std::string("\u00A0") : std::string(1, c);
    return out;
  }

  // "a" or "a^2" needs no parentheses on one line; "a + b" does.
  void bracketed(Script script, bool upright, int depth, std::size_t command_at) {
    const std::size_t from = at_;
    RichText before = std::exchange(out_, {});
    argument(script, upright, depth, command_at);
    RichText inner = std::exchange(out_, std::move(before));
    const std::string_view written = all_.substr(from, at_ - from);
    const bool sum =
        written.find_first_of("+-/ ") != std::string_view::npos || written.find("\\frac") != std::string_view::npos ||
        std::any_of(inner.begin(), inner.end(),
                    [](const TextRun& r) { return r.script == Script::None && r.text.find(' ') != std::string::npos; });
    if (sum) add("(", false, script);
    // Text in parentheses stays on one line.
    for (const TextRun& run : inner) add(withoutBreaks(run.text), run.italic, run.script);
    if (sum) add(")", false, script);
  }

  void command(Script script, bool upright, int depth) {
    const std::size_t at = at_++;
    if (at_ == all_.size()) {
      add("\\", false, script);
      return;
    }
    std::size_t end = at_;
    while (end < all_.size() && ((all_[end] >= 'a' && all_[end] <= 'z') || (all_[end] >= 'A' && all_[end] <= 'Z')))
      ++end;
    if (end == at_) {  // "\," is a narrow blank, "\%" the character itself
      const char c = all_[at_++];
      if (c == ',' || c == ';' || c == ' ' || c == ':')
        add("\u00A0", false, script);
      else if (c != '!')
        add(std::string(1, c), false, script);
      return;
    }
    const std::string name(all_.substr(at_, end - at_));
    at_ = end;
    if (const Command* sign = findIn(kSigns, name)) {
      const bool tight = script != Script::None && sign->text.starts_with(' ');
      add(tight ? sign->text.substr(1, sign->text.size() - 2) : sign->text, false, script);
      // Blanks end a command's name.
      while (at_ < all_.size() && all_[at_] == ' ' && !sign->text.ends_with(' ')) ++at_;
    } else if (const Command* letter = findIn(kSlanted, name)) {
      add(letter->text, !upright, script);
      while (at_ < all_.size() && all_[at_] == ' ') ++at_;
    } else if (name == "text" || name == "mathrm" || name == "mathsf" || name == "operatorname") {
      argument(script, true, depth, at);
    } else if (name == "frac" || name == "tfrac" || name == "dfrac") {
      bracketed(script, upright, depth, at);
      add("/", false, script);
      bracketed(script, upright, depth, at);
    } else if (name == "sqrt") {
      add("√", false, script);
      bracketed(script, upright, depth, at);
    } else {
      tell(at, trf("a formula here knows no '\\{0}'", name),
           tr("write the sign itself, or in words; what is known: Greek letters, \\frac, \\sqrt, \\cdot, \\times, "
              "\\text, ^ and _"));
      add("\\" + name, false, script);
    }
  }

  std::string_view all_;
  std::size_t at_ = 0;
  Place place_;
  std::vector<Problem>& problems_;
  RichText out_;
};

}  // namespace

RichText formulaText(std::string_view formula, Place place, std::vector<Problem>& problems) {
  return FormulaReader(formula, place, problems).read();
}

}  // namespace moltact
