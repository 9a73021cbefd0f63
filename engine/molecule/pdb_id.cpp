#include "engine/molecule/pdb_id.h"

#include <algorithm>
#include <cctype>

#include "engine/core/text.h"

namespace moltact {
namespace {

bool isLetterOrDigit(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string pdbId(const std::string& text) {
  if (!std::all_of(text.begin(), text.end(), [](char c) { return isLetterOrDigit(c) || c == '_'; })) return {};
  std::string upper = text;
  const std::string small = lower(text);
  for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (text.size() == 4) return isDigit(text[0]) && text.find('_') == std::string::npos ? upper : std::string();
  if (text.size() != 12 || small.compare(0, 4, "pdb_") != 0 || small.find('_', 4) != std::string::npos) return {};
  if (small.compare(4, 4, "0000") == 0) return isDigit(upper[8]) ? upper.substr(8) : std::string();
  return small;
}

}  // namespace moltact
