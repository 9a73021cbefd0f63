#include "engine/bench/clock_step.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/core/units.h"

namespace moltact::bench {
namespace {

constexpr double kWidest_ns = 200.0;  // a coarser clock is useless here
constexpr double kReach_ns = 2000.0;  // longer differences are dominated by interruptions

}  // namespace

double stepOf(const std::vector<double>& differences_ns) {
  // Measures how well the differences fit multiples of a step: the length of the mean of exp(2 pi i d / step). It is 1
  // if all are multiples. Rounding to whole nanoseconds reduces it to sinc^2(1 / step); it would be 0 if half of them
  // were half a step off.
  double shortest = kWidest_ns;  // the step is at most the shortest difference
  for (const double d : differences_ns)
    if (d > 0) shortest = std::min(shortest, d + 1.0);
  for (double step = shortest; step > 1.5; step *= 1.0 - 2e-4) {
    std::complex<double> sum = 0;
    std::size_t count = 0;
    for (const double d : differences_ns) {
      if (d <= 0 || d > kReach_ns) continue;
      sum += std::polar(1.0, kTwoPi * d / step);
      ++count;
    }
    if (count == 0) return 1.0;
    const double x = std::numbers::pi / step, sinc = std::sin(x) / x;
    const std::complex<double> mean = sum / double(count);
    if (mean.real() < 0.93 * sinc * sinc) continue;
    // On the slope of a peak: climb to its maximum.
    double best = step, largest = mean.real();
    for (double finer = step; finer > 0.97 * step; finer *= 1.0 - 5e-5) {
      double real = 0;
      for (const double d : differences_ns)
        if (d > 0 && d <= kReach_ns) real += std::cos(kTwoPi * d / finer);
      if (real / double(count) > largest) largest = real / double(count), best = finer;
    }
    return best;
  }
  return 1.0;
}

double clockStep_ns() {
  using Clock = std::chrono::steady_clock;
  std::vector<double> differences;
  volatile unsigned work = 0;
  for (unsigned k = 0; k < 1500; ++k) {
    const auto begin = Clock::now();
    for (unsigned j = 0; j < k % 97; ++j) work = work + j;  // varies the length of the differences
    differences.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
  }
  return stepOf(differences);
}

}  // namespace moltact::bench
