#include "engine/bench/trade_off_sentences.h"

#include <algorithm>

#include "engine/bench/methods/bench_methods.h"

namespace moltact::bench {
namespace {

std::string quotedName(const Method* m) { return "`" + std::string(m->name) + "`"; }

std::string bytes(std::size_t n) {
  if (n < 1'000'000) return readable(1e-3 * double(n)) + " kB";
  return readable(1e-6 * double(n)) + " MB";
}

std::string seconds(double s) { return s < 1 ? readable(1e3 * s) + " ms" : readable(s) + " s"; }

}  // namespace

std::string tradeOffSentences(const std::vector<TradeOff>& points) {
  const auto exact =
      std::find_if(points.begin(), points.end(), [](const TradeOff& p) { return isReference(*p.method); });
  if (exact == points.end() || points.size() < 2 || !(exact->tick_ns > 0)) return "";
  std::vector<TradeOff> others;
  for (const TradeOff& p : points)
    if (!isReference(*p.method)) others.push_back(p);
  std::sort(others.begin(), others.end(), [](const TradeOff& a, const TradeOff& b) { return a.tick_ns < b.tick_ns; });

  std::string out = "* Accuracy: the error of `exact` against the oracle is at most " +
                    readable(exact->accuracy.scp_A.max) + " A. The rms errors of the others are:";
  std::vector<TradeOff> by_error = others;
  std::sort(by_error.begin(), by_error.end(),
            [](const TradeOff& a, const TradeOff& b) { return a.accuracy.scp_A.rms < b.accuracy.scp_A.rms; });
  for (std::size_t k = 0; k < by_error.size(); ++k)
    out += (k ? "; " : " ") + quotedName(by_error[k].method) + " " + readable(by_error[k].accuracy.scp_A.rms) +
           " A and " + readable(by_error[k].accuracy.direction_deg.rms) + " degrees";
  out += ".\n* Time of a tick in contact, relative to `exact`'s " + readable(exact->tick_ns) + " ns:";
  for (std::size_t k = 0; k < others.size(); ++k)
    out +=
        (k ? "; " : " ") + quotedName(others[k].method) + " " + readable(others[k].tick_ns / exact->tick_ns) + " times";
  std::vector<std::string> faster;
  for (const TradeOff& p : others)
    if (p.tick_ns < exact->tick_ns)
      faster.push_back(quotedName(p.method) + " (" + readable(p.tick_ns / exact->tick_ns) + " times its time, off by " +
                       readable(p.accuracy.scp_A.rms) + " A)");
  out += ".\n* Faster than `exact`: " + listed(faster) + ".\n* Memory after these strokes, relative to `exact`'s " +
         bytes(exact->memory_usage.bytes) + ":";
  for (std::size_t k = 0; k < others.size(); ++k)
    out += (k ? "; " : " ") + quotedName(others[k].method) + " " +
           readable(double(others[k].memory_usage.bytes) / double(exact->memory_usage.bytes)) + " times";
  return out + ".\n";
}

std::string coldCacheSentences(const std::vector<ColdCacheTimes>& cool) {
  const auto exact =
      std::find_if(cool.begin(), cool.end(), [](const ColdCacheTimes& c) { return isReference(*c.method); });
  if (exact == cool.end() || exact->sleeping_ns.count == 0) return "";
  std::string out = "With one tick per millisecond, a tick of `exact` takes " + readable(exact->sleeping_ns.p50) +
                    " ns. After other work has emptied the caches it takes " + readable(1e-3 * exact->thrashed_ns.p50) +
                    " us, " + readable(1e-4 * exact->thrashed_ns.p50) + " % of the millisecond.";
  const auto slowest = std::max_element(cool.begin(), cool.end(), [](const ColdCacheTimes& a, const ColdCacheTimes& b) {
    return a.thrashed_ns.p50 < b.thrashed_ns.p50;
  });
  if (slowest != exact)
    out += " The slowest other method, " + quotedName(slowest->method) + ", then takes " +
           readable(1e-3 * slowest->thrashed_ns.p50) + " us.";
  return out + "\n";
}

std::string sizeSentences(const std::vector<SceneTimes>& times) {
  const auto referenceIn = [](const std::vector<TickTimes>& rows) -> const TickTimes* {
    for (const TickTimes& row : rows)
      if (isReference(*row.method)) return &row;
    return nullptr;
  };
  const SceneTimes *smallest = nullptr, *largest = nullptr, *prepared = nullptr;
  for (const SceneTimes& s : times) {
    const TickTimes* row = referenceIn(s.contact);
    if (!row || !(row->mean_ns > 0)) continue;
    if (!smallest || s.spheres < smallest->spheres) smallest = &s;
    if (!largest || s.spheres > largest->spheres) largest = &s;
    const bool any = std::any_of(s.contact.begin(), s.contact.end(),
                                 [](const TickTimes& t) { return limitsOf(*t.method).max_spheres > 0; });
    if (any && (!prepared || s.spheres > prepared->spheres)) prepared = &s;
  }
  if (!smallest) return "";
  std::string out;
  if (largest != smallest) {
    const double few = referenceIn(smallest->contact)->mean_ns, many = referenceIn(largest->contact)->mean_ns;
    out += "* Scale: from " + readable(double(smallest->spheres)) + " to " + readable(double(largest->spheres)) +
           " spheres, `exact`'s tick in contact changes from " + readable(few) + " to " + readable(many) + " ns (" +
           readable(many / few) + " times), its memory per sphere from " +
           readable(double(referenceIn(smallest->contact)->memory_usage.bytes) / double(smallest->spheres)) + " to " +
           readable(double(referenceIn(largest->contact)->memory_usage.bytes) / double(largest->spheres)) + " bytes.\n";
  }
  if (!prepared) return out;
  const TickTimes* exact = referenceIn(prepared->contact);
  const auto ready = [&](const TickTimes& t) { return prepared->scene_s + t.make_s + t.first_touch_s; };
  out += "* Preparation on " + readable(double(prepared->spheres)) + " spheres: `exact` is ready after " +
         seconds(ready(*exact)) + ", with " + bytes(exact->memory_usage.bytes) + " after the strokes";
  for (const TickTimes& t : prepared->contact)
    if (limitsOf(*t.method).max_spheres > 0)
      out += "; " + quotedName(t.method) + ", which preprocesses the whole scene for one probe, after " +
             seconds(ready(t)) + " (" + readable(ready(t) / ready(*exact)) + " times), with " +
             bytes(t.memory_usage.bytes) + " (" +
             readable(double(t.memory_usage.bytes) / double(exact->memory_usage.bytes)) + " times)";
  return out + ".\n";
}

}  // namespace moltact::bench
