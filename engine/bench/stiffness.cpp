#include "engine/bench/stiffness.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/bench/many_threads.h"
#include "engine/bench/statistics.h"
#include "engine/core/quantile.h"
#include "engine/servo/plain_trackers.h"

namespace moltact::bench {
namespace {

// Vibration at 200 Hz below this speed moves the hand by less than 0.01 mm.
constexpr double kRest_m_per_s = 0.006;
constexpr double kOut_A = 0.8, kIn_A = 1.0;
constexpr double kCreep_A = 0.002;
constexpr double kHeld_A = 0.75;  // at a greater depth the hand and not the surface stops the device
constexpr double kMin_N_per_mm = 0.02, kMax_N_per_mm = 20;
constexpr double kDistinguishable = 1.03;  // minimum ratio of different limits: the search's last step

double inflated(const scenes::Scene& s, std::size_t k) { return s.spheres[k].radius_A + s.probe_A; }

// A rotation that maps the device's axis `device` to `scene`.
glm::dmat3 turnTo(const Vec3& device, const Vec3& scene) {
  const auto frame = [](const Vec3& z) {
    const Vec3 x = glm::normalize(glm::cross(std::abs(z.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), z));
    return glm::dmat3(x, glm::cross(z, x), z);
  };
  return frame(scene) * glm::transpose(frame(device));
}

std::string fixed(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", value >= 9.95 ? 1 : 2, value);
  return text;
}

}  // namespace

std::vector<StiffnessPlace> stiffnessPlaces() {
  std::vector<StiffnessPlace> out;
  const scenes::Scene one = scenes::oneSphere();
  out.push_back({"one sphere", one, Vec3(0, 0, inflated(one, 0)), Vec3(0, 0, 1), false});

  const scenes::Scene bond = scenes::bond();
  const double a = inflated(bond, 0), b = inflated(bond, 1), d = bond.spheres[1].centre_A.x;
  const double x = (d * d - b * b + a * a) / (2 * d);
  out.push_back({"crease", bond, Vec3(x, 0, std::sqrt(a * a - x * x)), Vec3(0, 0, 1), false});

  const scenes::Scene pit = scenes::pit();
  const double side = pit.spheres[1].centre_A.x, R = inflated(pit, 0);
  out.push_back({"pit of three", pit, Vec3(side / 2, side * std::sqrt(3.0) / 6, std::sqrt(R * R - side * side / 3)),
                 Vec3(0, 0, 1)});

  const scenes::Scene cube = scenes::cube();
  const double edge = 1.57, r = inflated(cube, 0);
  Vec3 low(1e300), high(-1e300);
  for (const Sphere& sphere : cube.spheres)
    low = glm::min(low, sphere.centre_A), high = glm::max(high, sphere.centre_A);
  const Vec3 middle = 0.5 * (low + high);
  out.push_back(
      {"pit of four", cube, middle + Vec3(0, 0, edge / 2 + std::sqrt(r * r - edge * edge / 2)), Vec3(0, 0, 1)});

  // The probe stops where it touches all six: the ring's spheres meet the axis there.
  const scenes::Scene ring = scenes::ring(6, -0.05);
  const double circle = glm::length(ring.spheres[0].centre_A), rr = inflated(ring, 0);
  out.push_back(
      {"hole too narrow", ring, Vec3(0, 0, std::sqrt(std::max(0.0, rr * rr - circle * circle))), Vec3(0, 0, 1)});
  return out;
}

std::vector<StiffnessSetup> stiffnessSetups() {
  const DeviceParameters device;
  DeviceParameters smooth;
  smooth.friction_N = 0;
  const HandParameters light{100, 2};
  return {{"friction and hand", device, light, 0, 0.004, 1600, 2.0},
          {"hand alone", smooth, light, 0, 0.004, 1600, 0.5},
          {"friction alone", device, kNoHand, 0.5, 0.004, 1600, 1.5},
          {"neither", smooth, kNoHand, 0.1, 0.001, 4000, 0.07}};
}

double stiffestStable(const std::function<std::unique_ptr<Tracker>()>& make, const Vec3& surface, const Vec3& out,
                      const glm::dmat3& turn, const StiffnessSetup& setup) {
  LoopSettings loop;
  loop.device = setup.device;
  loop.workspace.rotation = turn;
  loop.workspace.centre_A = surface;
  const Vec3 from = surface + out * kOut_A, in = surface - out * kIn_A;
  // A constant push is modelled as a hand so soft that no motion of the device changes its force.
  constexpr double kSoft_N_per_m = 0.1;
  const bool pushed = setup.push_N > 0;
  loop.hand = pushed ? HandParameters{kSoft_N_per_m, 0} : setup.hand;
  const Vec3 push = from - out * (loop.workspace.A_per_mm * 1e3 * setup.push_N / kSoft_N_per_m);
  const auto rests = [&](double stiffness) {  // and the surface stops it
    loop.stiffness_N_per_mm = stiffness;
    const auto tracker = make();
    // The hand brings the device in; with a push alone it starts where the spring balances the push.
    Vec3 start = from;
    if (pushed)
      for (double at = kOut_A; at > -kIn_A; at -= kCreep_A) {
        start = surface + out * at;
        if (glm::length(springForce(loop, tracker->step({start}), setup.device.max_force_N).N) >= setup.push_N) break;
      }
    ClosedLoop device(loop, {start});
    double fastest_m_per_s = 0;
    int touching = 0;
    constexpr int kIn = 300, kStruck = 600, kWatched = 400;
    for (int k = 0; k < setup.ticks; ++k) {
      const Vec3 target = from + (in - from) * std::min(1.0, double(k) / kIn);
      if (k == kStruck) device.device().strike(glm::transpose(turn) * -out * setup.strike_N_s);
      const LoopTick tick = device.tick(*tracker, {pushed ? push : target});
      if (k < setup.ticks - kWatched) continue;
      fastest_m_per_s = std::max(fastest_m_per_s, glm::length(device.device().velocity_m_per_s()));
      touching += tick.contact.touching();
    }
    const double depth_A = glm::dot(surface - loop.workspace.toMolecule(device.device().position()).A, out);
    return touching > kWatched / 2 && fastest_m_per_s < kRest_m_per_s && depth_A < kHeld_A;
  };
  constexpr double kStep = 1.15;
  double stable = setup.begin_N_per_mm;
  if (rests(stable)) {
    while (stable < kMax_N_per_mm && rests(stable * kStep)) stable *= kStep;
    if (stable >= kMax_N_per_mm) return kMax_N_per_mm;
  } else {
    do {
      stable /= kStep;
      if (stable < kMin_N_per_mm) return 0;
    } while (!rests(stable));
  }
  for (double unstable = stable * kStep; unstable / stable > 1.03;) {
    const double middle = std::sqrt(stable * unstable);
    (rests(middle) ? stable : unstable) = middle;
  }
  return stable;
}

std::vector<Stiffness> measureStiffness(const StiffnessOptions& options, const Progress& progress) {
  const std::vector<StiffnessPlace> places = stiffnessPlaces();
  const std::vector<StiffnessSetup> setups = stiffnessSetups();
  // Along the device's three axes, then in random directions.
  std::vector<Vec3> directions{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  directions.resize(std::min<std::size_t>(3, options.directions));
  scenes::Random random(options.seed);
  while (directions.size() < options.directions) directions.push_back(random.direction());

  std::vector<std::vector<double>> wall(setups.size(), std::vector<double>(directions.size()));
  inManyThreads(wall.size() * directions.size(), [&](std::size_t k) {
    const std::size_t s = k / directions.size(), d = k % directions.size();
    wall[s][d] = stiffestStable([] { return std::make_unique<WallTracker>(0.0); }, Vec3(0), Vec3(0, 0, 1),
                                turnTo(directions[d], Vec3(0, 0, 1)), setups[s]);
  });

  std::vector<Stiffness> out;
  for (std::size_t s = 0; s < setups.size(); ++s) {
    out.push_back({setups[s].name, "plain wall", nullptr, wall[s], std::vector<double>(directions.size(), 1.0)});
    for (const StiffnessPlace& place : places)
      for (const Method* method : options.methods)
        if (place.holds || setups[s].push_N == 0)
          out.push_back({setups[s].name, place.name, method, std::vector<double>(directions.size()),
                         std::vector<double>(directions.size())});
  }
  const auto named = [](const auto& all, const std::string& name) {
    return std::size_t(std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; }) -
                       all.begin());
  };
  inManyThreads(
      out.size() * directions.size(),
      [&](std::size_t k) {
        const std::size_t row = k / directions.size(), d = k % directions.size(), s = named(setups, out[row].setup);
        if (!out[row].method) return;
        const StiffnessPlace& place = places[named(places, out[row].place)];
        const auto spheres = std::make_shared<const SphereGrid>(place.scene.spheres);
        const double at_wall = wall[s][d];
        const double limit = stiffestStable([&] { return out[row].method->make(spheres, place.scene.probe_A); },
                                            place.surface, place.out, turnTo(directions[d], place.out), setups[s]);
        out[row].limit_N_per_mm[d] = limit;
        out[row].of_wall[d] = at_wall > 0 ? limit / at_wall : 0;
      },
      [&](std::size_t done) {
        if (progress) progress(double(done) / double(out.size() * directions.size()), "stiffness");
      });
  return out;
}

ReportTable stiffnessTable(const std::vector<Stiffness>& rows) {
  ReportTable t{"stiffness",
                "The greatest stiffness that stays stable (N/mm)",
                {{"setup", "set-up"}, {"place", "place"}, {"plain_wall", "plain wall"}},
                {},
                ""};
  std::vector<const Method*> methods;
  for (const Stiffness& r : rows)
    if (r.method && std::find(methods.begin(), methods.end(), r.method) == methods.end()) methods.push_back(r.method);
  for (const Method* m : methods) t.columns.push_back({std::string(m->name), std::string(m->name)});
  const auto shown = [](const Stiffness& r) {
    std::vector<double> sorted = r.limit_N_per_mm;
    std::sort(sorted.begin(), sorted.end());
    return fixed(percentile(sorted, 0.5)) + " (" + fixed(sorted.empty() ? 0 : sorted.front()) + ")";
  };
  std::string wall;
  std::size_t directions = 0;
  for (const Stiffness& r : rows) {
    directions = r.limit_N_per_mm.size();
    if (!r.method) {
      wall = shown(r);
      continue;
    }
    if (t.rows.empty() || t.rows.back()[0] != Cell{r.setup} || t.rows.back()[1] != Cell{r.place}) {
      t.rows.push_back(std::vector<Cell>(3 + methods.size()));
      t.rows.back()[0] = r.setup, t.rows.back()[1] = r.place, t.rows.back()[2] = wall;
    }
    t.rows.back()[3 + std::size_t(std::find(methods.begin(), methods.end(), r.method) - methods.begin())] = shown(r);
  }
  t.note = "Median over " + std::to_string(directions) +
           " directions of the device, with the minimum in brackets. 0: the device never comes to rest in contact.";
  return t;
}

ReportTable stiffnessSetupsTable() {
  ReportTable t{"stiffness_setups",
                "How the device is pressed",
                {{"setup", "set-up"},
                 {"friction_N", "friction (N)"},
                 {"pressed", "pressed by"},
                 {"strike_mN_s", "struck with (mN s)"},
                 {"seconds", "at rest after (s)"}},
                {},
                ""};
  for (const StiffnessSetup& s : stiffnessSetups()) {
    const std::string by = s.push_N > 0 ? constant(s.push_N) + " N, without a hand"
                                        : "a hand of " + constant(s.hand.stiffness_N_per_m) + " N/m and " +
                                              constant(s.hand.damping_N_s_per_m) + " N s/m, with its target " +
                                              constant(kIn_A) + " A under the surface";
    t.rows.push_back({s.name, s.device.friction_N, by, 1e3 * s.strike_N_s, 1e-3 * s.ticks});
  }
  return t;
}

ReportTable stiffnessFigures(const std::vector<Stiffness>& rows) {
  ReportTable t{"stiffness_figures",
                "The greatest stable stiffness by direction",
                {{"setup", "set-up"},
                 {"place", "place"},
                 {"method", "method"},
                 {"direction", "direction"},
                 {"limit_N_per_mm", "limit (N/mm)"},
                 {"of_wall", "of the wall's"}},
                {},
                ""};
  for (const Stiffness& r : rows)
    for (std::size_t d = 0; d < r.limit_N_per_mm.size(); ++d)
      t.rows.push_back({r.setup, r.place, std::string(r.method ? r.method->name : "plain wall"), double(d),
                        r.limit_N_per_mm[d], r.of_wall[d]});
  return t;
}

std::string stiffnessSentences(const std::vector<Stiffness>& rows) {
  // Along one direction two limits count as different if they differ by more than the search's last step.
  std::vector<std::string> above, never;
  double wall_low = kMax_N_per_mm, wall_high = 0, straight = 0, exact_ratio = 0;
  std::size_t compared = 0, exact_rows = 0;
  for (const Stiffness& r : rows) {
    if (!r.method) {
      if (r.setup == rows.front().setup && !r.limit_N_per_mm.empty()) {
        straight = r.limit_N_per_mm.front();
        for (const double limit : r.limit_N_per_mm)
          wall_low = std::min(wall_low, limit), wall_high = std::max(wall_high, limit);
      }
      continue;
    }
    ++compared;
    const MeanOf ratio = meanOf(r.of_wall);
    const std::string what = "`" + std::string(r.method->name) + "` at \"" + r.place + "\" (" + r.setup + ")";
    if (isReference(*r.method)) exact_ratio += ratio.mean, ++exact_rows;
    if (ratio.mean - ratio.half_width > kDistinguishable)
      above.push_back(what + ": " + readable(ratio.mean) + " ± " + readable(ratio.half_width));
    if (*std::max_element(r.limit_N_per_mm.begin(), r.limit_N_per_mm.end()) == 0) never.push_back(what);
  }
  std::string out = "* With " + rows.front().setup + ", the limit of a plain wall pressed straight along an axis is " +
                    readable(straight) + " N/mm; along other directions it is " + readable(wall_low) + " to " +
                    readable(wall_high) + ". Only the direction differs: the sensor's steps lie along its axes.\n";
  if (exact_rows)
    out += "* The limit of `exact` is " + readable(exact_ratio / double(exact_rows)) +
           " times the wall's along the same directions, averaged over places and set-ups.\n";
  out +=
      "* Limits above the plain wall's along the same directions, by more than the 95 % interval of the mean ratio "
      "and the search's step of 3 %: " +
      (above.empty() ? "none of " + readable(double(compared)) : listed(above) + ", which this page does not explain") +
      ". Larger medians in the table are within that uncertainty.\n";
  out += "* Never at rest: " + listedApart(never) + ".";
  return out + '\n';
}

}  // namespace moltact::bench
