// Small pieces of text that the readers share.
#include <charconv>
#include <cmath>

#include "engine/molecule/parsed_structure.h"

namespace moltact {

bool parseNumber(std::string_view text, double& value) {
  text = trimmed(text);
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && std::isfinite(value);
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t kLongest = 24;
  std::string out = "'";
  for (char c : text.substr(0, kLongest)) out += (c >= ' ' && c <= '~') ? c : '?';
  if (text.size() > kLongest) out += "...";
  return out + "'";
}

Problem noSuchModel(const std::string& file, int asked, int models) {
  return {file, 0, 0,
          "there is no model " + std::to_string(asked) + "; the file has " + std::to_string(models) +
              (models == 1 ? " model" : " models"),
          models == 1 ? "ask for model 1" : "ask for a model from 1 to " + std::to_string(models)};
}

}  // namespace moltact
