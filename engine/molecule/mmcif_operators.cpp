#include "engine/molecule/mmcif_operators.h"

#include <charconv>
#include <system_error>
#include <utility>

#include "engine/core/text.h"

namespace moltact {
namespace {

/// The names in one bracket of an operator expression: "1,3-5,P".
std::vector<std::string> operatorNames(std::string_view list) {
  std::vector<std::string> out;
  while (!list.empty() && out.size() < kMaxOperators) {
    const std::size_t comma = list.find(',');
    const std::string_view item = trimmed(list.substr(0, comma));
    list.remove_prefix(comma == std::string_view::npos ? list.size() : comma + 1);
    const std::size_t dash = item.find('-');
    int first = 0, last = 0;
    if (dash != std::string_view::npos && parseInteger(item.substr(0, dash), first) &&
        parseInteger(item.substr(dash + 1), last)) {
      for (long n = first; n <= last && out.size() < kMaxOperators; ++n) out.push_back(std::to_string(n));
    } else if (!item.empty()) {
      out.emplace_back(item);
    }
  }
  return out;
}

constexpr std::size_t kMaxProducts = 4 * kMaxCopies;

std::vector<ParsedOperator> tooMany() { return std::vector<ParsedOperator>(kMaxCopies + 1); }

}  // namespace

bool parseInteger(std::string_view word, int& value) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

std::vector<ParsedOperator> operatorsOf(std::string_view expression, const MmcifOperators& known) {
  std::vector<ParsedOperator> out;
  std::size_t made = 0;  // over all brackets: a million copies in each of many brackets would take for ever
  bool first = true;
  while (!expression.empty()) {
    std::string_view list = expression;
    if (expression.front() == '(') {
      const std::size_t close = expression.find(')');
      list = expression.substr(1, close == std::string_view::npos ? close : close - 1);
      expression.remove_prefix(close == std::string_view::npos ? expression.size() : close + 1);
    } else {
      list = expression.substr(0, expression.find('('));
      expression.remove_prefix(list.size());
    }
    std::vector<ParsedOperator> bracket;
    for (const std::string& name : operatorNames(list))
      if (const auto found = known.find(name); found != known.end()) bracket.push_back(found->second);
    if (first) {
      out = std::move(bracket);
    } else {
      if (out.size() * bracket.size() > kMaxCopies) return tooMany();
      std::vector<ParsedOperator> product;
      product.reserve(out.size() * bracket.size());
      for (const ParsedOperator& p : out)
        for (const ParsedOperator& q : bracket)
          product.push_back({p.rotation * q.rotation, p.rotation * q.shift_A + p.shift_A});
      out = std::move(product);
      made += out.size();
      if (made > kMaxProducts) return tooMany();
    }
    first = false;
    if (out.empty()) break;  // the product is empty
  }
  return out;
}

}  // namespace moltact
