#include "engine/language/quantity_text.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>

#include "engine/language/catalogue.h"

using namespace moltact;

namespace {

struct Sign {
  explicit Sign(DecimalSign sign) { setDecimalSign(sign); }
  ~Sign() { setDecimalSign(DecimalSign::OfLanguage); }
};

// Shown in these while it lives.
struct Units {
  explicit Units(const UnitSet& set) { setShownUnits(set); }
  ~Units() { setShownUnits({}); }
};

}  // namespace

TEST_CASE("a number and its unit, parted by a space at which no line breaks; degrees by none") {
  CHECK(quantityText(1.4, Dimension::Length) == "1.40\u00a0Å");
  CHECK(quantityText(1.4, Dimension::Length, decimals(1)) == "1.4\u00a0Å");
  CHECK(quantityText(0.426, Dimension::Force) == "0.43\u00a0N");
  CHECK(quantityText(3.25, Dimension::Time) == "3.2\u00a0s");
  CHECK(quantityText(0.5, Dimension::Stiffness) == "0.50\u00a0N/mm");
  CHECK(quantityText(-12.04, Dimension::HandLength) == "-12.0\u00a0mm");
  CHECK(quantityText(0.29, Dimension::Share) == "29\u00a0%");
  CHECK(quantityText(12.34, Dimension::Angle) == "12.3°");
  CHECK(quantityText(1000.2, Dimension::Frequency) == "1000\u00a0Hz");
  CHECK(quantityText(1.5, Dimension::None) == "1.5");
  CHECK(quantityNumber(1.4, Dimension::Length, decimals(1)) == "1.4");
  CHECK(unitText(Dimension::Force) == "N");
  CHECK(unitText(Dimension::None).empty());
}

TEST_CASE("another unit of the same dimension where a place asks for one; its decimals are that unit's") {
  CHECK(quantityText(0.0000123, Dimension::Time, {decimals(0), "µs"}) == "12\u00a0µs");
  CHECK(quantityText(0.0000123, Dimension::Time, {decimals(1), "µs"}) == "12.3\u00a0µs");
  CHECK(quantityText(90, Dimension::Time, {plain(), "min"}) == "1.5\u00a0min");
  CHECK(quantityText(0.5, Dimension::Stiffness, {decimals(0), "N/m"}) == "500\u00a0N/m");
  CHECK(quantityText(1.4, Dimension::Length, {decimals(1), "N"}) == "1.4\u00a0Å");  // no unit of a length
}

TEST_CASE("digits that count, digits behind the sign, and as many as it takes") {
  CHECK(numberText(0.2512, significant(2)) == "0.25");
  CHECK(numberText(4.0, significant(2)) == "4.0");
  CHECK(numberText(9.96, significant(2)) == "10");
  CHECK(numberText(123.0, significant(2)) == "120");
  CHECK(numberText(0.000123, significant(2)) == "0.00012");
  CHECK(numberText(0.0, significant(2)) == "0");
  CHECK(numberText(2.0) == "2");
  CHECK(numberText(0.125) == "0.125");
  CHECK(numberText(-0.01, decimals(1)) == "0.0");
  CHECK(numberText(1.25, plain(2)) == "1.2");
  CHECK(numberText(2.0, plain(2)) == "2");
  CHECK(quantityText(0.291, Dimension::Share, decimals(3)) == "29.1\u00a0%");
  CHECK(quantityIn(3.14159, "Å", decimals(2)) == "3.14\u00a0Å");
  CHECK(quantityIn(2.0, "atoms", plain()) == "2\u00a0atoms");
  CHECK(quantityIn(2.0, "", plain()) == "2");
  // Energies and forces between atoms keep the unit of their literature.
  CHECK(quantityIn(-26.17, "kcal/mol", decimals(1)) == "-26.2\u00a0kcal/mol");
  CHECK(quantityIn(961.2, "pN", decimals(0)) == "961\u00a0pN");
  CHECK(numberText(std::numeric_limits<double>::quiet_NaN()) == "–");
  CHECK(quantityText(std::numeric_limits<double>::infinity(), Dimension::Force) == "–\u00a0N");
  CHECK(numberText(1e300, decimals(2)) == "1e300");
  // A number, but none in the unit that is shown.
  CHECK(quantityText(1e307, Dimension::Share) == "–\u00a0%");
  CHECK(quantityText(-1e307, Dimension::Share, significant(2)) == "–\u00a0%");
  CHECK(quantityText(1.7e308, Dimension::Share, plain()) == "–\u00a0%");
  CHECK(quantityText(5e-324, Dimension::Share, significant(2)) == "0.000000000000\u00a0%");
}

TEST_CASE("10 000 random numbers are rounded as the C library's printf does it; seed 3") {
  std::mt19937_64 random(3);
  for (int k = 0; k < 10000; ++k) {
    const double value = std::ldexp(double(std::int64_t(random())), int(random() % 60) - 90);
    const int count = int(random() % 5);
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", count, value);
    std::string expected = text;
    if (expected.starts_with('-') && expected.find_first_not_of("-0.") == std::string::npos) expected.erase(0, 1);
    CHECK(numberText(value, decimals(count)) == expected);
    std::snprintf(text, sizeof text, "%g", value);
    CHECK(std::strtod(numberText(value).c_str(), nullptr) == std::strtod(text, nullptr));
  }
}

TEST_CASE("the decimal sign is the language's, or the one that the person prefers") {
  CHECK(decimalSign() == '.');
  REQUIRE_FALSE(setLanguage("qq", MOLTACT_TEST_CATALOGUES "/little"));
  CHECK(quantityText(1.4, Dimension::Length) == "1,40\u00a0Å");
  {
    const Sign point(DecimalSign::Point);
    CHECK(numberText(1.4) == "1.4");
  }
  setLanguage("en", {});
  const Sign comma(DecimalSign::Comma);
  CHECK(numberText(-1234.5, decimals(2)) == "-1234,50");
}

TEST_CASE("a number as it was typed is read with either sign, and a comma before three digits by the preference") {
  CHECK(numberAsTyped("1,76") == "1.76");
  CHECK(numberAsTyped("1.76") == "1.76");
  CHECK(numberAsTyped("1,760") == "1,760");
  const Sign comma(DecimalSign::Comma);
  CHECK(numberAsTyped("1,760") == "1.760");
  CHECK(numberAsTyped("0,8") == "0.8");
}

TEST_CASE("in prose a number stays with its unit and not with a word") {
  CHECK(withUnitsKept("by 0.08 Å and 26 N/m; 20 % of 3 atoms, 2 s.") ==
        "by 0.08\u00a0Å and 26\u00a0N/m; 20\u00a0% of 3 atoms, 2\u00a0s.");
  CHECK(withUnitsKept("5 more, 7 nmr") == "5 more, 7 nmr");
}

TEST_CASE(
    "every dimension but two is shown in a unit of its own, and the code counts in one of them or in a part of 1") {
  for (std::size_t k = 0; k < kDimensions; ++k) {
    const auto d = Dimension(k);
    const bool plain_number = d == Dimension::None || d == Dimension::Other;
    REQUIRE(bool(shownUnit(d)) != plain_number);
    if (plain_number) continue;
    CHECK(shownUnit(d)->dimension == d);
    CHECK((shownUnit(d)->use & kShowable) != 0);
    if (d == Dimension::Share) continue;
    REQUIRE(unitNamed(codeUnit(d), d));
    CHECK(unitNamed(codeUnit(d), d)->in_code_units == 1.0);
  }
  CHECK(codeUnit(Dimension::Length) == "Å");
  CHECK(codeUnit(Dimension::Stiffness) == "N/mm");
  CHECK(codeUnit(Dimension::Share).empty());
  CHECK(codeUnit(Dimension::None).empty());
}

TEST_CASE(
    "with nm and mN chosen 1.4 Å is 0.14 nm and 0.43 N is 430 mN, with as many digits as before, until others are") {
  UnitSet set;
  REQUIRE(set.choose(Dimension::Length, "nm"));
  REQUIRE(set.choose(Dimension::Force, "mN"));
  CHECK_FALSE(set.choose(Dimension::Length, "N"));        // no length
  CHECK_FALSE(set.choose(Dimension::Force, "pN"));        // only in prose
  CHECK_FALSE(set.choose(Dimension::Length, "furlong"));  // none at all
  CHECK(set.of(Dimension::Length)->symbol == "nm");
  CHECK(quantityText(1.4, Dimension::Length, decimals(1)) == "1.4\u00a0Å");  // nothing is shown in them yet
  {
    const Units shown(set);
    CHECK(quantityText(1.4, Dimension::Length, decimals(1)) == "0.14\u00a0nm");
    CHECK(quantityText(1.4, Dimension::Length) == "0.140\u00a0nm");
    CHECK(quantityText(0.43, Dimension::Force, decimals(2)) == "430\u00a0mN");
    CHECK(quantityText(0.43, Dimension::Force, {decimals(2), "N"}) == "0.43\u00a0N");
    CHECK(quantityIn(3.14159, "Å", decimals(2)) == "0.314\u00a0nm");
    CHECK(unitText(Dimension::Length) == "nm");
    CHECK(quantityText(2.0, Dimension::Time) == "2.0\u00a0s");
  }
  CHECK(quantityText(1.4, Dimension::Length, decimals(1)) == "1.4\u00a0Å");
}

TEST_CASE("energies by Avogadro's number: 1 kcal/mol is 4.184 kJ/mol and 6.948 zJ for each contact") {
  const double one_kcal_per_mol_J = 4184.0 / 6.02214076e23;
  const std::pair<const char*, const char*> written[] = {
      {"kcal/mol", "1.00\u00a0kcal/mol"}, {"kJ/mol", "4.18\u00a0kJ/mol"}, {"zJ", "6.95\u00a0zJ"}};
  for (const auto& [symbol, text] : written) {
    UnitSet set;
    REQUIRE(set.choose(Dimension::Energy, symbol));
    const Units shown(set);
    CHECK(quantityText(one_kcal_per_mol_J, Dimension::Energy, significant(3)) == text);
  }
  CHECK(quantityText(0.0109, Dimension::Energy) == "10.90\u00a0mJ");
}

TEST_CASE("a power of ten is written without signs and zeros that say nothing") {
  CHECK(numberText(1e9) == "1e9");
  CHECK(numberText(1.5e-12) == "1.5e-12");
  CHECK(numberText(1e-7) == "1e-7");
  CHECK(numberText(1e300) == "1e300");
  CHECK(numberText(-1e300, decimals(2)) == "-1e300");
  CHECK(quantityText(1e15, Dimension::Force) == "1e15\u00a0N");
  CHECK(quantityText(9e14, Dimension::Force, decimals(0)) == "900000000000000\u00a0N");
}
