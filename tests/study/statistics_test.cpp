// Oracle: NumPy and SciPy (tests/study/oracle.py), which share no code with the statistics.
#include <doctest/doctest.h>

#include <cmath>
#include <string_view>

#include "engine/results/study_statistics.h"
#include "tests/study/oracle_values.h"

namespace moltact {
namespace {

AnswerMatrix matrixOf(const oracle::Test& test) {
  AnswerMatrix out;
  for (const std::string_view row : test.answers) {
    out.emplace_back();
    for (const char c : row) out.back().push_back(char(c - '0'));
  }
  return out;
}

}  // namespace

TEST_CASE("Hedges' g, its interval, t and p agree with SciPy to 1e-7 for six pairs of groups") {
  for (const oracle::Groups& of : oracle::kGroups) {
    const auto effect = hedgesG(of.x, of.y);
    REQUIRE(effect);
    CHECK(effect->g == doctest::Approx(of.g).epsilon(1e-10));
    CHECK(effect->low == doctest::Approx(of.low).epsilon(1e-7));
    CHECK(effect->high == doctest::Approx(of.high).epsilon(1e-7));
    CHECK(effect->t == doctest::Approx(of.t).epsilon(1e-10));
    CHECK(effect->p == doctest::Approx(of.p).epsilon(1e-7));
    const auto reversed = hedgesG(of.y, of.x);
    CHECK(reversed->g == doctest::Approx(-of.g).epsilon(1e-10));
    CHECK(reversed->low == doctest::Approx(-of.high).epsilon(1e-7));
  }
  CHECK_FALSE(hedgesG(std::vector{1.0}, std::vector{1.0, 2.0}));
  CHECK_FALSE(hedgesG(std::vector{2.0, 2.0}, std::vector{1.0, 1.0}));
}

TEST_CASE(
    "the noncentral t distribution, its quantiles, the power of a test and the interval of a mean agree with SciPy") {
  for (const oracle::NoncentralT& at : oracle::kNoncentralT)
    CHECK(noncentralTCdf(at.t, at.df, at.delta) == doctest::Approx(at.cdf).epsilon(1e-9).scale(1.0));
  for (const oracle::Quantile& at : oracle::kQuantiles)
    CHECK(tQuantile(at.p, at.df) == doctest::Approx(at.t).epsilon(1e-8).scale(1.0));
  for (const oracle::Power& at : oracle::kPowers)
    CHECK(twoGroupPower(std::size_t(at.n1), std::size_t(at.n2), at.delta) == doctest::Approx(at.power).epsilon(1e-8));
  CHECK(meanHalfWidth(spreadOf(oracle::kValues)).value() == doctest::Approx(oracle::kHalfWidth).epsilon(1e-9));
  CHECK_FALSE(meanHalfWidth(spreadOf(std::vector{1.0})));
}

TEST_CASE(
    "difficulty, point-biserial, upper minus lower 27 % and alpha agree with SciPy for tests of 14, 40 and 101 "
    "students") {
  for (const oracle::Test& of : oracle::kTests) {
    const AnswerMatrix answers = matrixOf(of);
    const std::vector<ItemFigures> items = itemFigures(answers);
    REQUIRE(items.size() == of.items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      CHECK(items[i].difficulty == doctest::Approx(of.items[i][0]).epsilon(1e-12));
      CHECK(items[i].point_biserial.value() == doctest::Approx(of.items[i][1]).epsilon(1e-10));
      CHECK(items[i].upper_lower.value() == doctest::Approx(of.items[i][2]).epsilon(1e-10).scale(1.0));
    }
    CHECK(cronbachAlpha(answers).value() == doctest::Approx(of.alpha).epsilon(1e-10));
  }
}

TEST_CASE("few students, equal answers and full marks before give no figure instead of a false one") {
  const AnswerMatrix four(4, std::vector<char>{1, 0});
  CHECK(itemFigures(four)[0].difficulty == 1.0);
  CHECK_FALSE(itemFigures(four)[0].point_biserial);
  CHECK_FALSE(itemFigures(four)[0].upper_lower);
  CHECK_FALSE(cronbachAlpha(four));
  CHECK(itemFigures({}).empty());
  CHECK_FALSE(normalisedGain(1.0, 1.0));
  // Hake's own definition: of the 60 % that could be gained, 30 % were.
  CHECK(normalisedGain(0.4, 0.7).value() == doctest::Approx(0.5));
  CHECK(normalisedGain(0.5, 0.25).value() == doctest::Approx(-0.5));
}

}  // namespace moltact
