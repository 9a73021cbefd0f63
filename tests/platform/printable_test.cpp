// Oracle: the control characters of ECMA-48 and Unicode, listed here.
#include "engine/core/printable.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "engine/core/problem.h"
#include "engine/core/saturated.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

std::string utf8(std::uint32_t c) {
  if (c < 0x80) return {char(c)};
  if (c < 0x800) return {char(0xC0 | c >> 6), char(0x80 | (c & 63))};
  return {char(0xE0 | c >> 12), char(0x80 | (c >> 6 & 63)), char(0x80 | (c & 63))};
}

TEST_CASE(
    "of the 63 488 code points of two and three bytes and of ASCII only C0, C1, DEL and 9 of direction are replaced") {
  std::size_t replaced = 0;
  for (std::uint32_t c = 0; c < 0x10000; ++c) {
    if (c >= 0xD800 && c < 0xE000) continue;
    const std::string text = "a" + utf8(c) + "b";
    const bool control = (c < 32 && c != 9 && c != 10) || (c >= 127 && c < 160) || (c >= 0x202A && c <= 0x202E) ||
                         (c >= 0x2066 && c <= 0x2069);
    const std::string clean = printable(text);
    if (clean != (control ? "a\xEF\xBF\xBD"
                            "b"
                          : text)) {
      CAPTURE(c);
      CHECK(false);
    }
    replaced += control;
  }
  CHECK(replaced == 30 + 33 + 9);
}

TEST_CASE("bytes that are no UTF-8 become one sign each: overlong, surrogates, cut short, alone") {
  CHECK(printable("\xC0\x9B") == "\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(printable("\x9B"
                  "31m") ==
        "\xEF\xBF\xBD"
        "31m");
  CHECK(printable("\xED\xA0\x80").size() == 9);
  CHECK(printable("x\xE2\x80") == "x\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(oneLine("a\nb\tc\rd\ve") ==
        "a b c d\xEF\xBF\xBD"
        "e");
  CHECK(Problem{"a\nb\x1b[2J", 3, 4, "bad \x07 thing", "mend\nit"}.text() ==
        "a b\xEF\xBF\xBD[2J:3:4: bad \xEF\xBF\xBD thing; mend it");
}

TEST_CASE("20 000 random bytes, in pieces of any size, give text that holds nothing that steers") {
  const unsigned seed = std::random_device{}();
  MESSAGE("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 200; ++round) {
    std::string bytes(100, ' ');
    for (char& c : bytes) c = char(random() % 3 ? random() : "\x1b\xc2\x9b\xe2\x80\xae\x7f"[random() % 7]);
    std::string_view left = bytes;
    const std::string clean = printable(bytes);
    for (left = clean; !left.empty(); left.remove_prefix(firstCodePoint(left).bytes)) {
      REQUIRE(firstCodePoint(left).valid);
      REQUIRE_FALSE(isTerminalControl(firstCodePoint(left).code));
    }
  }
}

TEST_CASE("numbers of every size have a whole number and a float") {
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(saturateToInteger<int>(1e300) == std::numeric_limits<int>::max());
  CHECK(saturateToInteger<int>(-inf) == std::numeric_limits<int>::min());
  CHECK(saturateToInteger<int>(nan) == 0);
  CHECK(saturateToInteger<int>(-3.9) == -3);
  CHECK(saturateToInteger<int>(2147483647.0) == 2147483647);
  CHECK(saturateToInteger<int>(2147483648.0) == 2147483647);
  CHECK(saturateToInteger<int>(2147483648.0f) == 2147483647);
  CHECK(saturateToInteger<std::int64_t>(9.3e18) == std::numeric_limits<std::int64_t>::max());
  CHECK(saturateToInteger<std::size_t>(-1.0) == 0);
  CHECK(saturateToFloat(1e300) == std::numeric_limits<float>::max());
  CHECK(saturateToFloat(-inf) == -std::numeric_limits<float>::max());
  CHECK(saturateToFloat(nan) == 0.0f);
  CHECK(saturateToFloat(0.1) == 0.1f);
}

TEST_CASE("a home that is not named from the root counts as none") {
  const char* before = std::getenv("HOME");
  const std::string kept = before ? before : "";
  const char* data = std::getenv("XDG_DATA_HOME");
  const std::string kept_data = data ? data : "";
  ::unsetenv("XDG_DATA_HOME");
  for (const char* home : {"", "here", "./here", "../here"}) {
    ::setenv("HOME", home, 1);
    CHECK(userDataFolder().empty());
    CHECK(folderFromEnvironment("HOME").empty());
  }
  ::setenv("HOME", "/root/of", 1);
  CHECK(userDataFolder() == "/root/of/.local/share/moltact");
  ::setenv("XDG_DATA_HOME", "rel", 1);
  CHECK(userDataFolder() == "/root/of/.local/share/moltact");
  if (before) ::setenv("HOME", kept.c_str(), 1);
  if (data)
    ::setenv("XDG_DATA_HOME", kept_data.c_str(), 1);
  else
    ::unsetenv("XDG_DATA_HOME");
}

}  // namespace
}  // namespace moltact
