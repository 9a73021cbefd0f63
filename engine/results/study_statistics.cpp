#include "engine/results/study_statistics.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace moltact {
namespace {

double normalCdf(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

// The continued fraction of the incomplete beta function (Abramowitz and Stegun 26.5.8) by Lentz's method.
double betaFraction(double x, double a, double b) {
  constexpr double kTiny = 1e-300;
  const auto kept = [](double v) { return std::abs(v) < kTiny ? kTiny : v; };
  double c = 1.0, d = 1.0 / kept(1.0 - (a + b) * x / (a + 1.0)), f = d;
  for (int m = 1; m < 10000; ++m) {
    const double k = m;
    for (const double term : {k * (b - k) * x / ((a + 2 * k - 1) * (a + 2 * k)),
                              -(a + k) * (a + b + k) * x / ((a + 2 * k) * (a + 2 * k + 1))}) {
      d = 1.0 / kept(1.0 + term * d);
      c = kept(1.0 + term / c);
      f *= c * d;
    }
    if (std::abs(c * d - 1.0) < 1e-15) break;
  }
  return f;
}

// The regularised incomplete beta function I_x(a, b).
double incompleteBeta(double x, double a, double b) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  const double front =
      std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
  if (x < (a + 1.0) / (a + b + 2.0)) return front * betaFraction(x, a, b) / a;
  return 1.0 - front * betaFraction(1.0 - x, b, a) / b;
}

// The argument at which an ascending function takes a value.
double solved(const std::function<double(double)>& f, double value, double low, double high) {
  while (f(low) > value) low -= high - low;
  while (f(high) < value) high += high - low;
  for (int k = 0; k < 200 && high - low > 1e-12 * (1.0 + std::abs(low)); ++k) {
    const double middle = 0.5 * (low + high);
    (f(middle) < value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

// Hedges' exact correction, J(m).
double correction(double m) {
  return std::exp(std::lgamma(0.5 * m) - std::lgamma(0.5 * (m - 1.0))) / std::sqrt(0.5 * m);
}

std::optional<double> correlation(std::span<const double> x, std::span<const double> y) {
  const Spread a = spreadOf(x), b = spreadOf(y);
  if (!(a.sd > 1e-12) || !(b.sd > 1e-12)) return std::nullopt;
  double sum = 0.0;
  for (std::size_t k = 0; k < x.size(); ++k) sum += (x[k] - a.mean) * (y[k] - b.mean);
  return sum / (double(x.size() - 1) * a.sd * b.sd);
}

// The weights of the `wanted` students with the greatest totals. Those with equal totals at the border share the rest.
std::vector<double> weightsOfBest(const std::vector<double>& totals, double wanted) {
  std::vector<double> sorted = totals, out;
  std::sort(sorted.rbegin(), sorted.rend());
  const double border = sorted[std::size_t(wanted) - 1];
  const auto above = double(std::count_if(totals.begin(), totals.end(), [&](double t) { return t > border; }));
  const auto at = double(std::count(totals.begin(), totals.end(), border));
  for (const double t : totals) out.push_back(t > border ? 1.0 : t == border ? (wanted - above) / at : 0.0);
  return out;
}

}  // namespace

Spread spreadOf(std::span<const double> values) {
  Spread out{values.size(), 0.0, 0.0};
  if (values.empty()) return out;
  for (const double v : values) out.mean += v / double(values.size());
  double squares = 0.0;
  for (const double v : values) squares += (v - out.mean) * (v - out.mean);
  if (values.size() > 1) out.sd = std::sqrt(squares / double(values.size() - 1));
  return out;
}

double noncentralTCdf(double t, double df, double delta) {
  if (t < 0.0) return 1.0 - noncentralTCdf(-t, df, -delta);
  const double x = t * t / (df + t * t), half = 0.5 * delta * delta;
  double sum = 0.0;
  if (half == 0.0) {
    sum = incompleteBeta(x, 0.5, 0.5 * df);
  } else {
    // The terms of a Poisson distribution that exceed 1e-17 of the whole.
    const double reach = 9.0 * std::sqrt(half) + 25.0;
    for (double j = std::max(0.0, std::floor(half - reach)); j <= half + reach; j += 1.0) {
      const double p = std::exp(-half + j * std::log(half) - std::lgamma(j + 1.0));
      const double q = delta / std::numbers::sqrt2 * std::exp(-half + j * std::log(half) - std::lgamma(j + 1.5));
      sum += p * incompleteBeta(x, j + 0.5, 0.5 * df) + q * incompleteBeta(x, j + 1.0, 0.5 * df);
    }
  }
  return std::clamp(normalCdf(-delta) + 0.5 * sum, 0.0, 1.0);
}

double tQuantile(double p, double df) {
  return solved([df](double t) { return noncentralTCdf(t, df, 0.0); }, p, -10.0, 10.0);
}

std::optional<double> meanHalfWidth(const Spread& spread, double confidence) {
  if (spread.n < 2) return std::nullopt;
  return tQuantile(0.5 + 0.5 * confidence, double(spread.n - 1)) * spread.sd / std::sqrt(double(spread.n));
}

double twoGroupPower(std::size_t n1, std::size_t n2, double delta, double alpha) {
  const double df = double(n1 + n2) - 2.0, ncp = delta * std::sqrt(double(n1) * double(n2) / double(n1 + n2));
  const double critical = tQuantile(1.0 - 0.5 * alpha, df);
  return 1.0 - noncentralTCdf(critical, df, ncp) + noncentralTCdf(-critical, df, ncp);
}

std::optional<double> normalisedGain(double pre, double post) {
  if (!(pre < 1.0)) return std::nullopt;
  return (post - pre) / (1.0 - pre);
}

std::optional<EffectSize> hedgesG(std::span<const double> x, std::span<const double> y, double confidence) {
  if (x.size() < 2 || y.size() < 2) return std::nullopt;
  const Spread a = spreadOf(x), b = spreadOf(y);
  const double n1 = double(x.size()), n2 = double(y.size()), df = n1 + n2 - 2.0;
  const double pooled = std::sqrt(((n1 - 1.0) * a.sd * a.sd + (n2 - 1.0) * b.sd * b.sd) / df);
  if (!(pooled > 1e-12)) return std::nullopt;
  EffectSize out{.difference = a.mean - b.mean, .n1 = x.size(), .n2 = y.size()};
  const double d = out.difference / pooled, root = std::sqrt(n1 * n2 / (n1 + n2));
  out.g = correction(df) * d;
  out.t = d * root;
  out.p = 2.0 * noncentralTCdf(-std::abs(out.t), df, 0.0);
  // The distribution function falls with the noncentrality.
  const auto limit = [&](double p) {
    return solved([&](double delta) { return -noncentralTCdf(out.t, df, delta); }, -p, out.t - 5.0, out.t + 5.0) / root;
  };
  out.low = limit(0.5 + 0.5 * confidence);
  out.high = limit(0.5 - 0.5 * confidence);
  return out;
}

std::vector<ItemFigures> itemFigures(const AnswerMatrix& answers) {
  constexpr std::size_t kLeastForCorrelation = 5, kLeastForGroups = 10;
  constexpr double kKelley = 0.27;
  if (answers.empty()) return {};
  const std::size_t n = answers.size();
  std::vector<double> totals;
  for (const auto& row : answers) totals.push_back(double(std::count(row.begin(), row.end(), char(1))));
  std::vector<double> best, worst;
  const double wanted = std::round(kKelley * double(n));
  if (n >= kLeastForGroups) {
    best = weightsOfBest(totals, wanted);
    std::vector<double> negative = totals;
    for (double& t : negative) t = -t;
    worst = weightsOfBest(negative, wanted);
  }
  std::vector<ItemFigures> out(answers.front().size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    std::vector<double> item, others;
    double difference = 0.0;
    for (std::size_t s = 0; s < n; ++s) {
      item.push_back(answers[s][i]);
      others.push_back(totals[s] - answers[s][i]);
      if (!best.empty()) difference += (best[s] - worst[s]) * answers[s][i];
    }
    out[i].difficulty = spreadOf(item).mean;
    if (n >= kLeastForCorrelation) out[i].point_biserial = correlation(item, others);
    if (!best.empty()) out[i].upper_lower = difference / wanted;
  }
  return out;
}

std::optional<double> cronbachAlpha(const AnswerMatrix& answers) {
  if (answers.size() < 2 || answers.front().size() < 2) return std::nullopt;
  const std::size_t k = answers.front().size();
  std::vector<double> totals;
  for (const auto& row : answers) totals.push_back(double(std::count(row.begin(), row.end(), char(1))));
  const double total = std::pow(spreadOf(totals).sd, 2);
  if (!(total > 1e-12)) return std::nullopt;
  double items = 0.0;
  for (std::size_t i = 0; i < k; ++i) {
    std::vector<double> item;
    for (const auto& row : answers) item.push_back(row[i]);
    items += std::pow(spreadOf(item).sd, 2);
  }
  return double(k) / double(k - 1) * (1.0 - items / total);
}

}  // namespace moltact
