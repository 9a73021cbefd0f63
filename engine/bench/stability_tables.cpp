// The tables of stability.h.
#include <algorithm>

#include "engine/bench/stability.h"

namespace moltact::bench {
namespace {

template <class T, class Key>
std::vector<T> inOrder(const std::vector<StabilityResult>& results, Key key) {
  std::vector<T> out;
  for (const StabilityResult& r : results)
    if (std::find(out.begin(), out.end(), key(r)) == out.end()) out.push_back(key(r));
  return out;
}

}  // namespace

std::string failures(const StabilityResult& r, const StabilityLimits& limits) {
  std::string out;
  if (r.broken) out += 'N';
  if (r.tunnelled) out += 'T';
  if (r.lost) out += 'L';
  if (r.stuck) out += 'H';
  if (r.penetration_A > limits.penetration_A) out += 'P';
  if (r.step_over_N > limits.step_over_N) out += 'J';
  if (r.jitter_mm > limits.jitter_mm) out += 'R';
  if (r.energy_J > limits.energy_J) out += 'E';
  return out;
}

ReportTable stabilityMatrix(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  ReportTable t{
      "stability_matrix",
      "Where methods fail",
      {{"scene", "scene"}},
      {},
      "T tunnelling; L contact lost; H held where nothing is; P the SCP sinks into a sphere by more than " +
          readable(limits.penetration_A) + " A; J the force jumps by " + readable(limits.step_over_N) +
          " N more than the true surface's; R the held device shakes by over " + readable(limits.jitter_mm) +
          " mm; E energy over " + readable(limits.energy_J) +
          " J made; N an answer that is no number; . sound."};
  const auto methods = inOrder<const Method*>(results, [](const StabilityResult& r) { return r.method; });
  for (const Method* m : methods) t.columns.push_back({std::string(m->name), std::string(m->name)});
  for (const std::string& scene :
       inOrder<std::string>(results, [](const StabilityResult& r) { return r.scene; })) {
    std::vector<Cell> row(methods.size() + 1);
    row[0] = scene;
    for (const StabilityResult& r : results) {
      if (r.scene != scene) continue;
      const std::string letters = failures(r, limits);
      row[1 + std::size_t(std::find(methods.begin(), methods.end(), r.method) - methods.begin())] =
          letters.empty() ? "." : letters;
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

ReportTable stabilityFigures(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  ReportTable t{"stability_figures",
                "Every figure of the stability scenes",
                {{"scene", "scene"},
                 {"method", "method"},
                 {"failures", "failures"},
                 {"ticks", "ticks"},
                 {"contact_ticks", "in contact"},
                 {"tunnelled", "tunnelled"},
                 {"lost", "lost"},
                 {"stuck", "held on nothing"},
                 {"astray", "astray"},
                 {"penetration_A", "penetration (A)"},
                 {"step_N", "step (N)"},
                 {"step_over_N", "over the true (N)"},
                 {"jitter_mm", "jitter (mm)"},
                 {"energy_J", "energy made (J)"},
                 {"loop_energy_J", "in the loop (J)"},
                 {"sampling_J", "sampling bound (J)"},
                 {"stiffest_N_per_mm", "stiffest (N/mm)"}},
                {},
                ""};
  for (const StabilityResult& r : results) {
    t.rows.push_back({r.scene, std::string(r.method->name), failures(r, limits), double(r.ticks),
                      double(r.contact_ticks), double(r.tunnelled), double(r.lost), double(r.stuck),
                      double(r.astray), std::max(0.0, r.penetration_A), r.step_N, r.step_over_N, r.jitter_mm,
                      r.energy_J, r.loop_energy_J, r.sampling_J, Cell{}});
    if (r.stiffest_N_per_mm) t.rows.back().back() = *r.stiffest_N_per_mm;
  }
  return t;
}

ReportTable stiffnessTable(const std::vector<StabilityResult>& results, double wall_N_per_mm) {
  ReportTable t{"stiffness",
                "The greatest stiffness that stays stable (N/mm)",
                {{"scene", "scene"}, {"plain_wall", "plain wall"}},
                {},
                "Pressed with a light hand (100 N/m, 2 N s/m) and struck with 4 mN s; stable when the device "
                "comes to rest in contact; 0 where it never does, 20 is the most that is tried. A scene is missing where "
                "nothing can be pressed."};
  const auto methods = inOrder<const Method*>(results, [](const StabilityResult& r) { return r.method; });
  for (const Method* m : methods) t.columns.push_back({std::string(m->name), std::string(m->name)});
  for (const std::string& scene :
       inOrder<std::string>(results, [](const StabilityResult& r) { return r.scene; })) {
    std::vector<Cell> row(methods.size() + 2);
    row[0] = scene;
    row[1] = wall_N_per_mm;
    bool asked = false;
    for (const StabilityResult& r : results) {
      if (r.scene != scene || !r.stiffest_N_per_mm) continue;
      row[2 + std::size_t(std::find(methods.begin(), methods.end(), r.method) - methods.begin())] = *r.stiffest_N_per_mm;
      asked = true;
    }
    if (asked) t.rows.push_back(std::move(row));
  }
  return t;
}

}  // namespace moltact::bench
