// A logarithmic axis over a set of values: decades, ticks, and at most one shortened gap. Plain arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace moltact::bench {

class LogAxis {
 public:
  /// Covers the positive values with a margin, drawn from `begin` to `end` (unit: pixel). If two neighbouring values
  /// are more than three decades apart and `may_cut` is true, the gap between them is drawn as one decade.
  LogAxis(const std::vector<double>& values, double begin, double end, bool may_cut) : begin_(begin), end_(end) {
    std::vector<double> logs;
    for (const double v : values)
      if (v > 0 && std::isfinite(v)) logs.push_back(std::log10(v));
    if (logs.empty()) logs.push_back(0);
    std::sort(logs.begin(), logs.end());
    low_ = std::floor(logs.front() - 0.12);
    high_ = std::ceil(logs.back() + 0.12);
    if (!may_cut) return;
    for (std::size_t k = 1; k < logs.size(); ++k) {
      const double from = std::ceil(logs[k - 1] + 0.12), to = std::floor(logs[k] - 0.12);
      if (to - from > 3 && to - from > cut_to_ - cut_from_) cut_from_ = from, cut_to_ = to;
    }
  }

  bool cut() const { return cut_to_ > cut_from_; }
  double at(double value) const { return atLog(std::log10(value)); }
  double cutMiddle() const { return 0.5 * (atLog(cut_from_) + atLog(cut_to_)); }

  /// The exponents of the labelled decades, thinned out if there are many.
  std::vector<int> decades() const {
    std::vector<int> out;
    const int all = static_cast<int>(length()), step = all > 14 ? 3 : all > 9 ? 2 : 1;
    for (int e = static_cast<int>(low_); e <= static_cast<int>(high_); ++e)
      if (!hidden(e) && (step == 1 || e % step == 0)) out.push_back(e);
    return out;
  }
  bool hidden(double log) const { return cut() && log > cut_from_ && log < cut_to_; }
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double length() const { return high_ - low_ - (cut() ? cut_to_ - cut_from_ - 1 : 0); }
  double atLog(double log) const {
    double past = log - low_;
    if (cut() && log >= cut_to_)
      past -= cut_to_ - cut_from_ - 1;
    else if (cut() && log > cut_from_)
      past = cut_from_ - low_ + (log - cut_from_) / (cut_to_ - cut_from_);
    return begin_ + (end_ - begin_) * past / length();
  }

  double begin_, end_, low_ = 0, high_ = 1, cut_from_ = 0, cut_to_ = 0;
};

}  // namespace moltact::bench
