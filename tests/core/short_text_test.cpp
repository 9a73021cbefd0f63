// A ShortText stores the same text as a std::string.
#include "engine/core/short_text.h"

#include <doctest/doctest.h>

#include <utility>
#include <vector>

using moltact::ShortText;

TEST_CASE(
    "a short text of 0 to 40 bytes, and of 100 000, is the text it was made of, through copies, moves and assignments "
    "to itself; 16 bytes") {
  CHECK(sizeof(ShortText) == 16);
  CHECK(ShortText().empty());
  CHECK(ShortText() == "");
  std::vector<std::string> texts;
  for (std::size_t n = 0; n <= 40; ++n) {
    texts.emplace_back();
    for (std::size_t k = 0; k < n; ++k)
      texts.back() += static_cast<char>(k * 7 + n);  // zeros and bytes beyond 127 among them
  }
  texts.emplace_back(100'000, 'x');
  std::vector<ShortText> kept;  // grows, and so moves them
  for (const std::string& text : texts) {
    ShortText one(text);
    kept.push_back(one);
    CHECK(one == text);
    CHECK(one.string() == text);
    CHECK(one.empty() == text.empty());
    ShortText& itself = one;
    one = itself;
    CHECK(one == text);
    ShortText other = std::move(one);
    CHECK(other == text);
    other = ShortText("y");
    CHECK(other == "y");
    other = kept.back();
    CHECK(other == kept.back());
    CHECK_FALSE(other == ShortText(text + 'z'));
  }
  for (std::size_t k = 0; k < texts.size(); ++k) CHECK(kept[k] == texts[k]);
}
