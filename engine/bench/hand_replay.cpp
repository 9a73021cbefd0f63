#include "engine/bench/hand_replay.h"

#include <algorithm>

namespace moltact::bench {

std::vector<HandReplay> replayHands(const std::vector<HandOnMolecule>& hands, const std::vector<const Method*>& methods,
                                    const std::vector<const Method*>& timed, double budget_s,
                                    const Progress& progress) {
  std::vector<HandReplay> out;
  for (const HandOnMolecule& hand : hands) {
    if (progress) progress(double(out.size()) / double(hands.size()), hand.path.name);
    HandReplay one{hand.path.name,
                   hand.path.label("device"),
                   hand.path.label("hand"),
                   hand.path.label("stroke"),
                   hand.molecule,
                   0,
                   0,
                   {},
                   {}};
    const std::vector<Vec3>& places = hand.path.places;
    one.seconds = 1e-3 * double(places.size());
    const Stroke stroke{{}, places};
    for (const Method* m : methods)
      one.felt.push_back(feltOn(hand.path.name, *m, hand.scene, hand.path.probe_A, {stroke}));
    if (!places.empty() && !one.felt.empty()) one.touching = double(one.felt.front().ticks) / double(places.size());
    one.tick_ns.resize(methods.size());
    // Every second replay is timed as a whole; the first position is the approach.
    if (places.size() > 1) {
      const Stroke again{{places.front()}, {places.begin() + 1, places.end()}};
      const auto times = timeMethods(timed, hand.scene, hand.path.probe_A, std::vector<Stroke>(6, again), budget_s);
      for (const TickTimes& t : times)
        for (std::size_t k = 0; k < methods.size(); ++k)
          if (methods[k] == t.method) one.tick_ns[k] = t.mean_ns;
    }
    out.push_back(std::move(one));
  }
  if (progress) progress(1, "");
  return out;
}

std::vector<FeltErrors> feltOverAll(const std::vector<HandReplay>& hands) {
  std::vector<FeltErrors> out;
  if (hands.empty()) return out;
  for (std::size_t m = 0; m < hands.front().felt.size(); ++m) {
    std::vector<FeltErrors> parts;
    for (const HandReplay& h : hands) parts.push_back(h.felt[m]);
    out.push_back(together("all hands", parts));
  }
  return out;
}

ReportTable handsTable(const std::vector<HandReplay>& hands) {
  ReportTable t{"hands",
                "The recorded hands",
                {{"name", "recording"},
                 {"device", "device"},
                 {"hand", "hand"},
                 {"stroke", "stroke"},
                 {"molecule", "molecule"},
                 {"seconds", "length (s)"},
                 {"touching_percent", "touching (%)"}},
                {},
                ""};
  for (const HandReplay& h : hands)
    t.rows.push_back({h.name, h.device, h.hand, h.stroke, h.molecule, h.seconds, 100 * h.touching});
  return t;
}

ReportTable handsFeltTable(const std::vector<HandReplay>& hands) {
  const std::vector<FeltErrors> all = feltOverAll(hands);
  std::vector<double> ns(all.size());
  for (std::size_t m = 0; m < all.size(); ++m) {
    double ticks = 0;
    for (const HandReplay& h : hands) {
      ns[m] += h.tick_ns[m] * h.seconds;
      ticks += h.seconds;
    }
    ns[m] = ticks > 0 ? ns[m] / ticks : 0;
  }
  ReportTable t = feltTable("hands_felt", "Every method along the recorded hands", all, ns);
  t.note +=
      " Median and p99 are means over the recordings, weighted by ticks. The time covers all ticks, including free "
      "ones.";
  return t;
}

ReportTable handsFigures(const std::vector<HandReplay>& hands) {
  ReportTable t{"hands_figures", "Every method along every recorded hand", {{"name", "recording"}}, {}, ""};
  for (const HandReplay& h : hands) {
    const ReportTable one = feltTable("", "", h.felt, h.tick_ns);
    if (t.columns.size() == 1) t.columns.insert(t.columns.end(), one.columns.begin(), one.columns.end());
    for (const auto& row : one.rows) {
      t.rows.push_back({h.name});
      t.rows.back().insert(t.rows.back().end(), row.begin(), row.end());
    }
  }
  return t;
}

}  // namespace moltact::bench
