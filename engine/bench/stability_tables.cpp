// The tables of stability.h.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/bench/stability.h"

namespace moltact::bench {
namespace {

constexpr double kPer = 10'000;  // ticks of contact to which event counts refer

template <class T, class Rows, class Key>
std::vector<T> inOrder(const Rows& rows, Key key) {
  std::vector<T> out;
  for (const auto& r : rows)
    if (std::find(out.begin(), out.end(), key(r)) == out.end()) out.push_back(key(r));
  return out;
}

std::string fixed(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Thirty draws justify two digits.
std::string brief(double value) {
  return value < 0.005 ? "<0.01" : fixed(value, value >= 9.95 ? 0 : value >= 0.95 ? 1 : 2);
}

std::string withInterval(const MeanOf& m) {
  if (m.mean == 0) return "0";
  if (m.mean < 0.005) return "<0.01";
  return brief(m.mean) + " ± " + fixed(m.half_width, m.mean >= 9.95 ? 0 : m.mean >= 0.95 ? 1 : 2);
}

std::string events(const StabilityCell& c) {
  std::string out;
  const auto add = [&](char letter, double many, std::size_t draws) {
    if (!draws) return;
    out += out.empty() ? "" : ", ";
    out += std::string(1, letter) + ' ' + brief(many) + " (" + std::to_string(draws) + ')';
  };
  add('N', c.broken, c.with_broken);
  add('T', c.tunnelled, c.with_tunnel);
  add('J', c.jumps, c.with_jump);
  add('R', c.jitter_mm, c.with_jitter);
  add('E', 1e6 * c.energy_J, c.with_energy);
  return out.empty() ? "." : out;
}

ReportTable matrix(const std::vector<StabilityCell>& cells, ReportTable t, std::string (*text)(const StabilityCell&)) {
  const auto methods = inOrder<const Method*>(cells, [](const StabilityCell& c) { return c.method; });
  t.columns = {{"scene", "scene"}};
  for (const Method* m : methods) t.columns.push_back({std::string(m->name), std::string(m->name)});
  for (const std::string& scene : inOrder<std::string>(cells, [](const StabilityCell& c) { return c.scene; })) {
    std::vector<Cell> row(methods.size() + 1);
    row[0] = scene;
    for (const StabilityCell& c : cells)
      if (c.scene == scene)
        row[1 + std::size_t(std::find(methods.begin(), methods.end(), c.method) - methods.begin())] = text(c);
    t.rows.push_back(std::move(row));
  }
  return t;
}

}  // namespace

std::vector<StabilityCell> stabilityCells(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  std::vector<StabilityCell> out;
  std::vector<double> off;
  double contact = 0, tunnelled = 0, jumps = 0, broken = 0;
  for (std::size_t k = 0; k < results.size(); ++k) {
    const StabilityResult& r = results[k];
    if (out.empty() || out.back().scene != r.scene || out.back().method != r.method) {
      out.push_back({.scene = r.scene, .method = r.method, .off_percent = {}});
      off.clear();
      contact = tunnelled = jumps = broken = 0;
    }
    StabilityCell& c = out.back();
    ++c.draws;
    off.push_back(r.contact_ticks ? 100.0 * double(r.off) / double(r.contact_ticks) : 0.0);
    contact += double(r.contact_ticks);
    tunnelled += double(r.tunnelled);
    jumps += double(r.jumps);
    broken += double(r.broken);
    c.with_tunnel += r.tunnelled > 0;
    c.with_jump += r.jumps > 0;
    c.with_broken += r.broken > 0;
    c.with_jitter += r.jitter_mm > limits.jitter_mm;
    c.with_energy += r.energy_J > limits.energy_J;
    c.jitter_mm = std::max(c.jitter_mm, r.jitter_mm);
    c.energy_J += r.energy_J;
    const bool last = k + 1 == results.size() || results[k + 1].scene != r.scene || results[k + 1].method != r.method;
    if (!last) continue;
    c.off_percent = meanOf(off);
    const double per_contact = contact > 0 ? kPer / contact : 0;
    c.tunnelled = tunnelled * per_contact, c.jumps = jumps * per_contact, c.broken = broken * per_contact;
    c.energy_J /= double(c.draws);
  }
  return out;
}

ReportTable fidelityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits) {
  const std::size_t draws = cells.empty() ? 0 : cells.front().draws;
  return matrix(
      cells,
      {"fidelity_matrix",
       "Accuracy: ticks in contact whose SCP is off (%)",
       {},
       {},
       "Off: more than " + constant(limits.place_A) + " A from the reference SCP. Each value is the mean of " +
           std::to_string(draws) +
           " draws ± half the 95 % interval of that mean. The columns exact-0.001 and exact-0.02 are exact with a "
           "probe that is smaller by that many angstroms; they show the noise floor."},
      [](const StabilityCell& c) { return withInterval(c.off_percent); });
}

ReportTable stabilityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits) {
  const std::size_t draws = cells.empty() ? 0 : cells.front().draws;
  return matrix(cells,
                {"stability_matrix",
                 "Stability: events, and in how many draws",
                 {},
                 {},
                 "In brackets: in how many of " + std::to_string(draws) +
                     " draws. T: tunnelling, and J: force jumps of over " + constant(limits.step_over_N) +
                     " N more than the true surface's, per 10 000 ticks of contact. E: mean energy created over the "
                     "closed path (uJ; an event if over " +
                     constant(1e6 * limits.energy_J) + "). R: greatest vibration of the held device, if over " +
                     constant(limits.jitter_mm) +
                     " mm (mm). N: answers that are not a number, per 10 000 ticks of contact. A dot: no event, which "
                     "with 95 % confidence is a probability of under " +
                     brief(draws ? 100 * (1 - std::pow(0.05, 1.0 / double(draws))) : 100) + " % per draw."},
                &events);
}

ReportTable stabilitySummary(const std::vector<StabilityResult>& results, const StabilityLimits& limits) {
  ReportTable t{
      "stability_summary",
      "All scenes and draws together",
      {{"method", "method"},
       {"off_percent", "off (%)"},
       {"off_half_width", "± (%)"},
       {"sunk_percent", "sunk (%)"},
       {"lost_percent", "contact lost (%)"},
       {"stuck_percent", "held on nothing (%)"},
       {"penetration_A", "deepest (A)"},
       {"tunnelled", "tunnelled"},
       {"jumps", "jumps"},
       {"jitter_mm", "most shaking (mm)"},
       {"energy_J", "most energy (J)"},
       {"unsound", "runs with an event (%)"}},
      {},
      "Shares are of ticks in contact. \"off\" is the mean over scenes with the 95 % interval over draws. "
      "Contact lost and held on nothing are subsets of it. Sunk also counts ticks without a known reference. "
      "Tunnelled and jumps: per 10 000 ticks of contact. A run is one scene in one draw; events are those of the table "
      "above."};
  const auto cells = stabilityCells(results, limits);
  for (const Method* m : inOrder<const Method*>(results, [](const StabilityResult& r) { return r.method; })) {
    double contact = 0, sunk = 0, lost = 0, stuck = 0, deep = 0, tunnelled = 0, jumps = 0, jitter = 0, energy = 0;
    std::size_t runs = 0, unsound = 0, scenes = 0;
    std::vector<double> by_draw;
    for (const StabilityResult& r : results) {
      if (r.method != m) continue;
      if (r.draw >= by_draw.size()) by_draw.resize(r.draw + 1);
      by_draw[r.draw] += r.contact_ticks ? 100.0 * double(r.off) / double(r.contact_ticks) : 0.0;
      scenes += r.draw == 0;
      contact += double(r.contact_ticks), sunk += double(r.sunk), lost += double(r.lost), stuck += double(r.stuck);
      tunnelled += double(r.tunnelled), jumps += double(r.jumps);
      deep = std::max(deep, r.penetration_A), jitter = std::max(jitter, r.jitter_mm),
      energy = std::max(energy, r.energy_J);
      ++runs;
      unsound += r.broken || r.tunnelled || r.jumps || r.jitter_mm > limits.jitter_mm || r.energy_J > limits.energy_J;
    }
    for (double& one : by_draw) one /= double(std::max<std::size_t>(scenes, 1));
    const MeanOf off = meanOf(by_draw);
    const double per = contact > 0 ? 1 / contact : 0;
    t.rows.push_back({std::string(m->name), off.mean, off.half_width, 100 * sunk * per, 100 * lost * per,
                      100 * stuck * per, deep, kPer * tunnelled * per, kPer * jumps * per, jitter, energy,
                      100.0 * double(unsound) / double(runs)});
  }
  return t;
}

ReportTable deviceTable(const LoopSettings& loop) {
  const DeviceParameters& d = loop.device;
  const auto n = [](double value) { return constant(value); };
  return {
      "device_model",
      "The simulated device",
      {{"part", "part"}, {"figure", "figure"}},
      {{std::string("mass, damping"), n(1e3 * d.mass_kg) + " g, " + n(d.damping_N_s_per_m) + " N s/m"},
       {std::string("friction"), n(d.friction_N) + " N tanh(speed / " + n(1e3 * d.friction_speed_m_per_s) + " mm/s)"},
       {std::string("sensor"), "steps of " + n(d.resolution_mm) + " mm"},
       {std::string("loop"), n(1e-3 / d.tick_s) + " kHz, command held during a tick, delay in ticks: " +
                                 n(d.delay_ticks) + ", clamped to " + n(d.max_force_N) + " N"},
       {std::string("hand"), "a spring of " + n(loop.hand.stiffness_N_per_m) + " N/m with " +
                                 n(loop.hand.damping_N_s_per_m) + " N s/m to its target position"},
       {std::string("spring between HIP and SCP"),
        n(loop.stiffness_N_per_mm) + " N/mm at " + n(loop.workspace.A_per_mm) + " A/mm"}},
      ""};
}

ReportTable stabilityFigures(const std::vector<StabilityResult>& results) {
  ReportTable t{"stability_figures",
                "Every figure of the stability scenes",
                {{"scene", "scene"},
                 {"method", "method"},
                 {"draw", "draw"},
                 {"ticks", "ticks"},
                 {"contact_ticks", "in contact"},
                 {"off", "off"},
                 {"lost", "lost"},
                 {"stuck", "held on nothing"},
                 {"sunk", "sunk"},
                 {"penetration_A", "penetration (A)"},
                 {"tunnelled", "tunnelled"},
                 {"jumps", "jumps"},
                 {"broken", "no number"},
                 {"step_N", "step (N)"},
                 {"step_over_N", "over the true (N)"},
                 {"jitter_mm", "shaking (mm)"},
                 {"energy_J", "energy made (J)"},
                 {"loop_energy_J", "in the loop (J)"},
                 {"sampling_J", "sampling bound (J)"}},
                {},
                ""};
  for (const StabilityResult& r : results)
    t.rows.push_back({r.scene, std::string(r.method->name), double(r.draw), double(r.ticks), double(r.contact_ticks),
                      double(r.off), double(r.lost), double(r.stuck), double(r.sunk), std::max(0.0, r.penetration_A),
                      double(r.tunnelled), double(r.jumps), double(r.broken), r.step_N, r.step_over_N, r.jitter_mm,
                      r.energy_J, r.loop_energy_J, r.sampling_J});
  return t;
}

}  // namespace moltact::bench
