// Generates sentences from the stability tables in every run, so that they cannot disagree with the tables.
#include <algorithm>
#include <functional>
#include <map>

#include "engine/bench/stability.h"

namespace moltact::bench {
namespace {

struct Sums {
  const Method* method = nullptr;
  std::size_t runs = 0, tunnelled = 0, jumps = 0, broken = 0, with_tunnel = 0, with_jump = 0, with_energy = 0,
              with_jitter = 0;
  double off_sum = 0;                            // sum over the runs of the fractions of ticks that are off (%)
  std::map<std::string, double> off_in;          // the same by scene
  std::map<std::string, std::size_t> energy_in;  // by scene: runs that generated energy
  double energy_J = 0, jitter_mm = 0, step_over_N = 0;
  double off_percent() const { return runs ? off_sum / double(runs) : 0; }  // as in the summary table
};

std::vector<Sums> sumsOf(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  std::vector<Sums> out;
  for (const StabilityResult& r : results) {
    auto at = std::find_if(out.begin(), out.end(), [&](const Sums& s) { return s.method == r.method; });
    if (at == out.end()) {
      out.emplace_back();
      at = out.end() - 1;
      at->method = r.method;
    }
    ++at->runs;
    const double off = r.contact_ticks ? 100.0 * double(r.off) / double(r.contact_ticks) : 0;
    at->off_sum += off, at->off_in[r.scene] += off;
    at->tunnelled += r.tunnelled, at->jumps += r.jumps, at->broken += r.broken;
    at->with_tunnel += r.tunnelled > 0, at->with_jump += r.jumps > 0;
    at->with_jitter += r.jitter_mm > limits.jitter_mm;
    if (r.energy_J > limits.energy_J) ++at->with_energy, ++at->energy_in[r.scene];
    at->energy_J = std::max(at->energy_J, r.energy_J), at->jitter_mm = std::max(at->jitter_mm, r.jitter_mm);
    at->step_over_N = std::max(at->step_over_N, r.step_over_N);
  }
  return out;
}

std::string quoted(const Method* m) { return "`" + std::string(m->name) + "`"; }
std::string count(std::size_t n, const char* one, const char* many) {
  return readable(double(n)) + (n == 1 ? one : many);
}

// The reference, possibly with another probe.
bool ofReference(const Sums& sums) { return sums.method->family.name == referenceMethod().family.name; }

}  // namespace

std::string stabilitySentences(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  const std::vector<Sums> all = sumsOf(results, limits);
  if (all.empty()) return {};
  const std::size_t runs = all.front().runs;
  std::string out;

  for (const Sums& s : all) {
    if (!ofReference(s)) continue;
    out += "* " + quoted(s.method) + " is off in " + readable(s.off_percent()) +
           " % of the ticks in contact, averaged over scenes, and has " +
           count(s.tunnelled + s.jumps + s.broken, " event", " events") + " in " + readable(double(runs)) +
           " runs. It creates at most " + readable(1e6 * s.energy_J) + " uJ.";
    const auto largest = std::max_element(s.off_in.begin(), s.off_in.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    if (s.off_sum > 0 && largest != s.off_in.end())
      out += " The scene \"" + largest->first + "\" contributes " + readable(100.0 * largest->second / s.off_sum) +
             " % of this share.";
    out += '\n';
  }

  // The other methods, ordered by accuracy.
  std::vector<const Sums*> others;
  for (const Sums& s : all)
    if (!ofReference(s)) others.push_back(&s);
  std::stable_sort(others.begin(), others.end(),
                   [](const Sums* a, const Sums* b) { return a->off_percent() < b->off_percent(); });
  std::vector<std::string> order, tunnels, jumps, quiet, energy;
  std::size_t broken = 0, jitter = 0;
  for (const Sums* s : others) {
    order.push_back(quoted(s->method) + " (" + readable(s->off_percent()) + ")");
    if (s->tunnelled) tunnels.push_back(quoted(s->method) + " (" + readable(double(s->with_tunnel)) + ")");
    if (s->jumps)
      jumps.push_back(quoted(s->method) + " (" + readable(double(s->with_jump)) + ")");
    else
      quiet.push_back(quoted(s->method));
    if (s->with_energy) {
      const auto largest = std::max_element(s->energy_in.begin(), s->energy_in.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
      energy.push_back(quoted(s->method) + " (in " + readable(double(s->with_energy)) + " runs of " +
                       count(s->energy_in.size(), " scene", " scenes") + ", most often \"" + largest->first +
                       "\"; at most " + readable(1e6 * s->energy_J) + " uJ)");
    }
  }
  double max_jitter = 0;
  const Sums* shakiest = nullptr;
  for (const Sums& s : all) {
    broken += s.broken;
    jitter += s.with_jitter;
    if (s.jitter_mm > max_jitter) max_jitter = s.jitter_mm, shakiest = &s;
  }
  const std::string in_runs = "* Number of runs, of " + readable(double(runs)) + ", in which the ";
  out += "* Share of ticks that are off, in percent, averaged over scenes, the most accurate first: " + listed(order) +
         ".\n";
  out += in_runs + "HIP tunnels: " + listed(tunnels) + ".\n";
  out += in_runs + "force jumps: " + listed(jumps) + ". Never: " + listed(quiet) + ".\n";
  out += "* Methods that create more than " + constant(1e6 * limits.energy_J) +
         " uJ on a closed path: " + listed(energy) + ".\n";
  out += "* " + (broken ? count(broken, " answer was", " answers were") + " not a number."
                        : std::string("Every answer was a number."));
  if (shakiest)
    out += " The strongest vibration of the held device was " + readable(max_jitter) + " mm, with " +
           quoted(shakiest->method) + ". It exceeded one step of the sensor, " + constant(limits.jitter_mm) +
           " mm, in " + (jitter ? count(jitter, " run.", " runs.") : std::string("no run."));
  return out + '\n';
}

}  // namespace moltact::bench
