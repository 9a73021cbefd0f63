#include "engine/lesson/quantity.h"

#include <doctest/doctest.h>

using namespace moltact;

namespace {
double value(std::string_view text, Dimension d) {
  const auto v = parseQuantity(text, d);
  REQUIRE_MESSAGE(v, text);
  return *v;
}
std::string quantityReported(std::string_view text, Dimension d) {
  const auto v = parseQuantity(text, d);
  REQUIRE_MESSAGE(!v, text);
  return std::to_string(v.problem().column) + " " + v.problem().text();
}
}  // namespace

TEST_CASE("4 Å, 0.4 nm and 400 pm are 4 A; 2 min is 120 s; 300 mN is 0.3 N; 500 N/m is 0.5 N/mm") {
  for (const char* text : {"4 Å", "4Å", "4 \xE2\x84\xAB", "4 A", "0.4 nm", "400 pm", "+4 Å", " 4.0e0  Å "})
    CHECK(value(text, Dimension::Length) == doctest::Approx(4.0));
  CHECK(value("2 min", Dimension::Time) == 120.0);
  CHECK(value("90 s", Dimension::Time) == 90.0);
  CHECK(value("300 mN", Dimension::Force) == doctest::Approx(0.3));
  CHECK(value("500 N/m", Dimension::Stiffness) == doctest::Approx(0.5));
  CHECK(value("0.5 N/mm", Dimension::Stiffness) == 0.5);
}

TEST_CASE("a bare number is reported with the units that would do") {
  CHECK(quantityReported("4", Dimension::Length) == "1 '4' needs a unit: Å or nm");
  CHECK(quantityReported("0.3", Dimension::Force) == "1 '0.3' needs a unit: N or mN");
  CHECK(quantityReported("90", Dimension::Time) == "1 '90' needs a unit: s or min");
  CHECK(quantityReported("500", Dimension::Stiffness) == "1 '500' needs a unit: N/m or N/mm");
}

TEST_CASE("a wrong, unknown or malformed quantity is reported at its place") {
  CHECK(quantityReported("4 s", Dimension::Length) == "1 '4 s' is a time, but a length is needed: Å or nm");
  CHECK(quantityReported("4 parsec", Dimension::Length) == "3 'parsec' is no unit of length; write Å or nm");
  CHECK(quantityReported("0,3 N", Dimension::Force) == "2 a comma in a number; write the decimal sign as a point: 0.3");
  CHECK(quantityReported("four Å", Dimension::Length) == "1 'four Å' is not a number");
  CHECK(quantityReported("", Dimension::Length) == "1 a number is missing");
  CHECK(quantityReported("nan Å", Dimension::Length) == "1 'nan Å' is not a number");
  CHECK(quantityReported("inf Å", Dimension::Length) == "1 'inf Å' is not a number");
  CHECK(quantityReported("1e999 Å", Dimension::Length) == "1 '1e999' is too large or too small a number");
  CHECK(quantityReported("1e308 nm", Dimension::Length) == "1 '1e308 nm' is too large");
}

TEST_CASE("0.2 N to 0.6 N and 0.2 to 600 mN are ranges; one that ends below its start is not") {
  auto r = parseRange("0.2 N to 0.6 N", Dimension::Force);
  REQUIRE(r);
  CHECK(r->low == 0.2);
  CHECK(r->high == 0.6);
  r = parseRange("200 to 600 mN", Dimension::Force);
  REQUIRE(r);
  CHECK(r->low == doctest::Approx(0.2));
  CHECK(r->high == doctest::Approx(0.6));
  CHECK(parseRange("0.6 N to 0.2 N", Dimension::Force).problem().text() ==
        "the range ends below its start; write the smaller value first");
  const auto bare = parseRange("0.2 N to 0.6", Dimension::Force);
  CHECK(bare.problem().text() == "'0.6' needs a unit: N or mN");
  CHECK(bare.problem().column == 10);
  CHECK(parseRange("0.2 N", Dimension::Force).problem().text() ==
        "'0.2 N' is not a range; write it as '0.2 N to 0.6 N'");
}
