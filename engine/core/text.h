// Small text functions shared by readers and commands. ASCII; any thread except the haptic one.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// `text` without whitespace (spaces, tabs, line ends) at both ends.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

/// `text` with A-Z in lower case, independent of the locale; other bytes are unchanged.
inline std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

}  // namespace moltact
