#include "engine/language/plural_rule.h"

#include <doctest/doctest.h>

#include <string>

using namespace moltact;

namespace {

PluralRule rule(const char* text) {
  const auto out = PluralRule::parse(text);
  REQUIRE(out);
  return *out;
}

}  // namespace

TEST_CASE("the rules of six languages choose for 0 to 400 what the same expressions in C++ choose") {
  const PluralRule german,
      french = rule("nplurals=2; plural=(n > 1);"), japanese = rule("nplurals=1; plural=0;"),
      polish = rule("nplurals=3; plural=n==1 ? 0 : n%10>=2 && n%10<=4 && (n%100<10 || n%100>=20) ? 1 : 2"),
      latvian = rule("nplurals=3; plural=n%10==1 && n%100!=11 ? 0 : n != 0 ? 1 : 2;"),
      arabic = rule(
          "nplurals=6; plural=n==0 ? 0 : n==1 ? 1 : n==2 ? 2 : n%100>=3 && n%100<=10 ? 3 : "
          "n%100>=11 ? 4 : 5;");
  for (unsigned long n = 0; n <= 400; ++n) {
    CAPTURE(n);
    CHECK(german.form(n) == (n != 1));
    CHECK(french.form(n) == (n > 1));
    CHECK(japanese.form(n) == 0);
    CHECK(polish.form(n) == (n == 1 ? 0 : n % 10 >= 2 && n % 10 <= 4 && (n % 100 < 10 || n % 100 >= 20) ? 1 : 2));
    CHECK(latvian.form(n) == (n % 10 == 1 && n % 100 != 11 ? 0 : n != 0 ? 1 : 2));
    CHECK(arabic.form(n) == (n == 0                          ? 0
                             : n == 1                        ? 1
                             : n == 2                        ? 2
                             : n % 100 >= 3 && n % 100 <= 10 ? 3
                             : n % 100 >= 11                 ? 4
                                                             : 5));
  }
}

TEST_CASE("operators bind as in C: 2+3*4-6/2 is 11, !n is 1 only for 0, a choice in a choice needs no parentheses") {
  CHECK(rule("nplurals=16; plural=2+3*4-6/2;").form(7) == 11);
  CHECK(rule("nplurals=2; plural=!n;").form(0) == 1);
  CHECK(rule("nplurals=2; plural=!n;").form(5) == 0);
  CHECK(rule("nplurals=2; plural=!(n<=1);").form(5) == 1);
  CHECK(rule("nplurals=4; plural=n>=3?3:n<2?n:2").form(1) == 1);
  CHECK(rule("nplurals=4; plural=n>=3?3:n<2?n:2").form(2) == 2);
}

TEST_CASE("a rule that leaves its forms or divides by zero gives form 0") {
  CHECK(rule("nplurals=2; plural=n;").form(1) == 1);
  CHECK(rule("nplurals=2; plural=n;").form(2) == 0);
  CHECK(rule("nplurals=2; plural=7/(n-n);").form(2) == 0);
  CHECK(rule("nplurals=2; plural=7%(n-n);").form(2) == 0);
}

TEST_CASE("invalid rules are rejected: cut off, of no forms or 17, with words, deeper than 40, longer than 200") {
  for (const char* text :
       {"", "nplurals=2", "nplurals=2; plural=", "nplurals=0; plural=0;", "nplurals=17; plural=0;",
        "nplurals=2; plural=n?1", "nplurals=2; plural=(n", "nplurals=2; plural=n==;", "nplurals=2; plural=m;",
        "nplurals=2; plural=n; and more", "nplurals=2; plural=12345678901234567890;"})
    CHECK_FALSE(PluralRule::parse(text));
  const std::string head = "nplurals=2; plural=";
  CHECK_FALSE(PluralRule::parse(head + std::string(100000, '(') + "n" + std::string(100000, ')')));
  CHECK_FALSE(PluralRule::parse(head + std::string(100000, '!') + "n"));
  std::string choices = head + "n";
  for (int k = 0; k < 100000; ++k) choices += "?1:n";
  CHECK_FALSE(PluralRule::parse(choices));
  std::string sum = head + "n";
  for (int k = 0; k < 100000; ++k) sum += "+n";
  CHECK_FALSE(PluralRule::parse(sum));
}
