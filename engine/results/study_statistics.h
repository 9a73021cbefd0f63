// The statistics of a study. Pure functions; any thread but the haptic one. docs/study.md states each formula with its
// reference, and tests/results/study_oracle.py computes the same with SciPy.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace moltact {

/// Mean and standard deviation with n - 1; the deviation is 0 for one value.
struct Spread {
  std::size_t n = 0;
  double mean = 0.0, sd = 0.0;
};
Spread spreadOf(std::span<const double> values);

/// The half width of the confidence interval of a mean, t(1 - a/2, n - 1) s / sqrt(n). No value for n < 2.
std::optional<double> meanHalfWidth(const Spread& spread, double confidence = 0.95);

/// The distribution function of Student's t with `df` degrees of freedom and noncentrality `delta` (R. V. Lenth, Appl.
/// Statist. 38, 185, 1989, algorithm AS 243).
double noncentralTCdf(double t, double df, double delta);
/// The quantile of Student's t, for 0 < p < 1.
double tQuantile(double p, double df);

/// The power of the two-sided t test of two groups whose means differ by `delta` standard deviations.
double twoGroupPower(std::size_t n1, std::size_t n2, double delta, double alpha = 0.05);

/// Normalised gain of a group from its mean shares of right answers, (post - pre) / (1 - pre) (R. R. Hake, Am. J. Phys.
/// 66, 64, 1998). No value if the mean before is 1.
std::optional<double> normalisedGain(double pre, double post);

/// Standardised difference of two independent groups, x minus y. `g` is d of the pooled standard deviation times
/// Hedges' exact correction J(n1 + n2 - 2); `low` and `high` are the limits of the population's difference from the
/// noncentral t distribution (L. V. Hedges and I. Olkin, Statistical Methods for Meta-Analysis, 1985, chapter 5).
struct EffectSize {
  double difference = 0.0;  ///< of the means, in the units of the values
  double g = 0.0, low = 0.0, high = 0.0;
  double t = 0.0, p = 1.0;  ///< of the two-sided t test with pooled variance
  std::size_t n1 = 0, n2 = 0;
};
/// No value with fewer than two values in a group, or without variance.
std::optional<EffectSize> hedgesG(std::span<const double> x, std::span<const double> y, double confidence = 0.95);

/// The answers to a test: a row of equal length for each student, 1 for a right answer.
using AnswerMatrix = std::vector<std::vector<char>>;

/// The figures of one item of a test.
struct ItemFigures {
  double difficulty = 0.0;  ///< share of right answers
  /// Correlation of the item with the total of the other items. No value for fewer than 5 students or without variance.
  std::optional<double> point_biserial;
  /// Share right among the best 27 % of the students minus that among the worst 27 % (T. L. Kelley, J. Educ. Psychol.
  /// 30, 17, 1939). Students with equal totals at a border enter with equal weight. No value for fewer than 10 students.
  std::optional<double> upper_lower;
};
std::vector<ItemFigures> itemFigures(const AnswerMatrix& answers);

/// Cronbach's alpha, for right and wrong answers the same as Kuder and Richardson's formula 20. No value for fewer than
/// two students or items, or without variance of the totals.
std::optional<double> cronbachAlpha(const AnswerMatrix& answers);

}  // namespace moltact
