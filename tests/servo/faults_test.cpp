// Random faults in the whole servo step: 100 seeds by default; MOLTACT_FAULT_SEEDS=10000 sets their number,
// MOLTACT_FAULT_FIRST the first seed; MOLTACT_SOAK_S=600 runs for that many seconds of wall time.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdlib>

#include "tests/servo/fault_run.h"

using namespace moltact::test;

namespace {

std::uint64_t fromEnvironment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoull(text, nullptr, 10) : otherwise;
}

}  // namespace

TEST_CASE(
    "100 seeds of 8 faults in contact: finite, within 3.3 N and 1 N a tick, gone in the tick in which something is "
    "wrong, never growing") {
  const std::uint64_t seeds = fromEnvironment("MOLTACT_FAULT_SEEDS", 100);
  FaultRunResult all;
  const std::uint64_t first = fromEnvironment("MOLTACT_FAULT_FIRST", 1);
  for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
    const FaultRunResult one = runFaults(seed);
    CHECK_MESSAGE(one.broken.empty(), one.broken);
    all.ticks += one.ticks;
    all.contact += one.contact;
    all.turned += one.turned;
    all.exact += one.exact;
    all.faults += one.faults;
    all.cuts += one.cuts;
    all.body_cuts += one.body_cuts;
    all.peak_N = std::max(all.peak_N, one.peak_N);
    all.restless_m_per_s = std::max(all.restless_m_per_s, one.restless_m_per_s);
  }
  MESSAGE(seeds << " seeds, " << all.faults << " faults, " << all.ticks << " ticks, " << all.contact << " in contact, "
                << all.exact << " of them of the exact body, at most " << all.peak_N
                << " N; a second after a fault at most " << all.restless_m_per_s << " m/s, " << all.cuts << " cuts, "
                << all.body_cuts << " of a body pressed beyond the greatest force");
  // The runs must press, or they prove nothing.
  CHECK(all.contact > all.ticks / 4);
  CHECK(all.turned > all.ticks / 20);
  CHECK(all.exact > all.ticks / 50);
  CHECK(all.peak_N > 1.5);
  CHECK(all.restless_m_per_s < 0.03);
  CHECK(all.cuts == 0);
  CHECK(all.body_cuts <= all.faults / 2000);
}

TEST_CASE("the same seed of faults gives the same run") {
  const FaultRunResult first = runFaults(7), second = runFaults(7);
  CHECK(first.ticks == second.ticks);
  CHECK(first.contact == second.contact);
  CHECK(first.peak_N == second.peak_N);
}

TEST_CASE("soak" * doctest::skip(!std::getenv("MOLTACT_SOAK_S"))) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds(fromEnvironment("MOLTACT_SOAK_S", 600));
  double virtual_h = 0;
  std::uint64_t seed = 1'000'000;
  for (; Clock::now() < end; ++seed) {
    const FaultRunResult one = runFaults(seed, 50);
    REQUIRE_MESSAGE(one.broken.empty(), one.broken);
    virtual_h += double(one.ticks) * 0.001 / 3600;
  }
  MESSAGE((seed - 1'000'000) << " runs, " << virtual_h << " virtual hours");
}
