#include "app/ui/number_text.h"

namespace moltact {
namespace {

bool g_comma = false;

bool digit(char c) { return c >= '0' && c <= '9'; }

std::string exchanged(std::string text, char from, char to) {
  for (std::size_t k = 1; k + 1 < text.size(); ++k)
    if (text[k] == from && digit(text[k - 1]) && digit(text[k + 1])) text[k] = to;
  return text;
}

}  // namespace

void setDecimalComma(bool on) { g_comma = on; }

std::string localNumbers(std::string text) { return g_comma ? exchanged(std::move(text), '.', ',') : text; }

std::string plainNumbers(std::string text) { return g_comma ? exchanged(std::move(text), ',', '.') : text; }

}  // namespace moltact
