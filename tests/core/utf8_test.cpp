// UTF-8 against the table of RFC 3629, section 3, and a round trip through all of Unicode.
#include "engine/core/utf8.h"

#include <doctest/doctest.h>

using namespace moltact;

TEST_CASE("every code point but the surrogates is encoded in UTF-8 and decoded again, 1 112 064 of them") {
  int wrong = 0, sound = 0;
  for (char32_t c = 0; c <= 0x10FFFF; ++c) {
    const bool surrogate = c >= 0xD800 && c < 0xE000;
    const std::string bytes = utf8Of(c);
    const CodePoint back = firstCodePoint(bytes);
    wrong += back.valid == surrogate || (back.valid && (back.code != c || back.bytes != bytes.size()));
    sound += back.valid;
  }
  CHECK(wrong == 0);
  CHECK(sound == 1'112'064);
}

TEST_CASE("of all pairs and triples of bytes as many are one code point as RFC 3629 has: 1 920 and 61 440") {
  int pairs = 0, triples = 0;
  for (int a = 0; a < 256; ++a)
    for (int b = 0; b < 256; ++b) {
      const char two[] = {char(a), char(b)};
      const CodePoint first = firstCodePoint({two, 2});
      pairs += first.valid && first.bytes == 2;
      for (int c = 0; c < 256; c += a < 0xE0 || a > 0xEF ? 256 : 1) {
        const char three[] = {char(a), char(b), char(c)};
        const CodePoint whole = firstCodePoint({three, 3});
        triples += whole.valid && whole.bytes == 3;
      }
    }
  CHECK(pairs == 0x800 - 0x80);
  CHECK(triples == 0x10000 - 0x800 - 0x800);
}

TEST_CASE("a text gives its characters, and bytes that are not UTF-8 give none") {
  CHECK(charactersOf("aÅ中\U0001F600") == std::vector<char32_t>{U'a', U'Å', U'中', U'\U0001F600'});
  CHECK(charactersOf("\xff"
                     "b\xe4\xb8") == std::vector<char32_t>{U'b'});
  CHECK(charactersOf("").empty());
  CHECK(characterCount("aÅ中") == 3);
}

TEST_CASE("the first byte that is no UTF-8 is reported: an overlong form, a surrogate, above U+10FFFF, cut off") {
  CHECK(firstNotUtf8("aÅ中") == std::string_view::npos);
  CHECK(firstNotUtf8("ab\xc0\x80") == 2);
  CHECK(firstNotUtf8("ab\xe0\x80\x80") == 2);
  CHECK(firstNotUtf8("ab\xed\xa0\x80") == 2);
  CHECK(firstNotUtf8("ab\xf4\x90\x80\x80") == 2);
  CHECK(firstNotUtf8("ab\xe4\xb8") == 2);
}
