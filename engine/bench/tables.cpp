#include "engine/bench/tables.h"

#include <array>

#include "engine/bench/clock_step.h"
#include "engine/bench/hip_paths.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/scenes.h"

namespace moltact::bench {
namespace {

const TickTimes* rowOf(const std::vector<TickTimes>& rows, std::string_view method) {
  for (const TickTimes& row : rows)
    if (row.method->name == method) return &row;
  return nullptr;
}

// Empty for a zero denominator.
Cell ratio(double a, double b) {
  if (!(b > 0)) return {};
  return a / b;
}

Cell ns(const std::optional<double>& seconds) {
  if (!seconds) return std::string("N/A");
  return 1e9 * *seconds;
}

}  // namespace

std::optional<PaperFigures> paperFigures(const std::string& paper_name) {
  if (paper_name == "Test 1") return PaperFigures{2.19e-6, 5.29e-7, 4.92e-5, 5.07e-6};
  if (paper_name == "Test 2") return PaperFigures{5.86e-6, 5.39e-7, 9.46e-5, 9.89e-6};
  if (paper_name == "5ADH") return PaperFigures{0.00015, 5.32e-7, 0.0013, 6.30e-6};
  if (paper_name == "8TIM") return PaperFigures{0.00033, 5.47e-7, 0.0024, 1.49e-6};
  if (paper_name == "1KBW") return PaperFigures{{}, 0.008, {}, 1.56e-6};
  return std::nullopt;
}

std::vector<TableScene> madeScenes(bool quick, std::uint64_t seed) {
  std::vector<TableScene> out;
  const auto random = [&](std::size_t n, const char* paper) {
    out.push_back({std::to_string(n) + " random spheres", n,
                   [=] { return scenes::cluster(static_cast<int>(n), seed).spheres; }, paper});
  };
  const auto protein = [&](std::size_t n, const char* name, const char* paper) {
    out.push_back({name, n, [=] { return proteinLike(n, static_cast<unsigned>(seed)); }, paper});
  };
  random(50, "Test 1");
  random(150, "Test 2");
  protein(2785, "2 800 protein-like", "5ADH");
  protein(3735, "3 700 protein-like", "8TIM");
  protein(13751, "13 800 protein-like", "1KBW");
  if (quick) {
    protein(100'000, "100 000 protein-like", "");
  } else {
    protein(165'000, "165 000 protein-like", "");
    protein(1'000'000, "1 000 000 protein-like", "");
  }
  return out;
}

std::vector<const Method*> methodsForSize(const std::vector<const Method*>& methods, std::size_t spheres,
                                          std::size_t min_prepared) {
  std::vector<const Method*> out;
  for (const Method* m : methods) {
    const std::size_t max_spheres = limitsOf(*m).max_spheres;
    if (max_spheres == 0 || (spheres <= max_spheres && spheres >= min_prepared)) out.push_back(m);
  }
  return out;
}

std::vector<SceneTimes> measureTables(const std::vector<TableScene>& scenes, const TableOptions& options,
                                      const Progress& progress) {
  std::vector<SceneTimes> out;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const auto at = [&](double part) {
      if (progress) progress((double(k) + part) / double(scenes.size()), scenes[k].name);
    };
    at(0);
    const std::vector<Sphere> spheres = scenes[k].makeSpheres();
    SceneTimes one{scenes[k].name, scenes[k].paper_name, spheres.size(), scenePreparation_s(spheres), {}, {}};
    const auto scene = std::make_shared<const SphereGrid>(spheres);
    const auto contact = contactStrokes(scene, options.probe_A, options.plan);
    at(0.3);
    const std::vector<const Method*> methods = methodsForSize(options.methods, spheres.size(), options.min_prepared);
    one.contact = timeMethods(methods, scene, options.probe_A, contact, options.budget_s);
    at(0.7);
    const auto free = freeStrokes(scene, options.probe_A, options.plan);
    one.free = timeMethods(methods, scene, options.probe_A, free, options.budget_s);
    out.push_back(std::move(one));
  }
  if (progress) progress(1, "");
  return out;
}

ReportTable tickTable(const std::vector<SceneTimes>& times) {
  ReportTable t{"ticks",
                "Time of one tick",
                {{"scene", "scene"},
                 {"spheres", "spheres"},
                 {"motion", "motion"},
                 {"method", "method"},
                 {"mean_ns", "mean (ns)"},
                 {"p50_ns", "p50 (ns)"},
                 {"single_error_ns", "± (ns)"},
                 {"p99_ns", "p99 (ns)"},
                 {"p99.99_ns", "p99.99 (ns)"},
                 {"max_ns", "max (ns)"},
                 {"times_exact", "mean / exact"},
                 {"touching_percent", "touching (%)"},
                 {"ticks", "single ticks"},
                 {"dropped", "strokes dropped"}},
                {},
                ""};
  const double step = clockStep_ns();
  t.note = "Means are over whole strokes. The other figures are from single ticks. The clock has a step of " +
           readable(step) + " ns, so a single tick is known to within that (±). The clock's own cost, " +
           readable(clockCost_ns()) +
           " ns, is subtracted from single ticks. Strokes in which the operating system preempted the thread are "
           "dropped.";
  for (const SceneTimes& scene : times)
    for (const bool contact : {false, true}) {
      const auto& rows = contact ? scene.contact : scene.free;
      const TickTimes* exact = rowOf(rows, referenceMethod().name);
      for (const TickTimes& row : rows)
        t.rows.push_back({scene.scene, double(scene.spheres), std::string(contact ? "contact" : "free"),
                          std::string(row.method->name), row.mean_ns, row.single_ns.p50, step, row.single_ns.p99,
                          row.single_ns.p9999, row.single_ns.max, ratio(row.mean_ns, exact ? exact->mean_ns : 0),
                          100 * row.touching, double(row.single_ns.count), double(row.dropped)});
    }
  return t;
}

ReportTable readyTable(const std::vector<SceneTimes>& times) {
  ReportTable t{"ready",
                "Preparation time and memory",
                {{"scene", "scene"},
                 {"spheres", "spheres"},
                 {"method", "method"},
                 {"scene_ms", "scene (ms)"},
                 {"tracker_ms", "tracker (ms)"},
                 {"first_touch_ms", "first touch (ms)"},
                 {"ready_ms", "touchable after (ms)"},
                 {"bytes", "memory (bytes)"},
                 {"bytes_times_exact", "memory / exact"},
                 {"atoms_modelled", "atoms modelled"},
                 {"modelled_percent", "modelled of loaded (%)"}},
                {},
                "Memory is that of the method after the strokes in contact, without the list of atoms. Atoms modelled "
                "are those for which it stores more than centre and radius."};
  for (const SceneTimes& scene : times) {
    const TickTimes* exact = rowOf(scene.contact, referenceMethod().name);
    for (const TickTimes& row : scene.contact) {
      const double bytes = double(row.memory_usage.bytes), modelled = double(row.memory_usage.atoms_modelled);
      t.rows.push_back({scene.scene, double(scene.spheres), std::string(row.method->name), 1e3 * scene.scene_s,
                        1e3 * row.make_s, 1e3 * row.first_touch_s,
                        1e3 * (scene.scene_s + row.make_s + row.first_touch_s), bytes,
                        ratio(bytes, exact ? double(exact->memory_usage.bytes) : 0), modelled,
                        100 * modelled / double(scene.spheres)});
    }
  }
  return t;
}

ReportTable paperComparisonTable(const std::vector<SceneTimes>& times) {
  ReportTable t{"beside_paper",
                "Comparison with the paper's Tables 1 and 2 (ns per tick; the paper's on hardware of 2008)",
                {{"paper_row", "paper's row"},
                 {"scene", "scene here"},
                 {"spheres", "spheres"},
                 {"motion", "motion"},
                 {"paper_polygons_ns", "paper: polygons"},
                 {"paper_spheres_ns", "paper: spheres"}},
                {},
                "The column heads of the paper's tables say Hz. The figures are seconds per haptic frame, "
                "given here in nanoseconds."};
  const std::array<std::string_view, 4> shown{referenceMethod().name, "paper", "mesh960", "sasmesh05"};
  for (const std::string_view name : shown)
    t.columns.push_back({std::string(name) + "_ns", std::string(name) + " here"});
  for (const SceneTimes& scene : times) {
    const auto figures = paperFigures(scene.paper_name);
    if (!figures) continue;
    for (const bool contact : {false, true}) {
      std::vector<Cell> row{scene.paper_name,
                            scene.scene,
                            double(scene.spheres),
                            std::string(contact ? "contact" : "free"),
                            ns(contact ? figures->contact_polygons_s : figures->free_polygons_s),
                            ns(contact ? figures->contact_spheres_s : figures->free_spheres_s)};
      for (const std::string_view name : shown) {
        const TickTimes* one = rowOf(contact ? scene.contact : scene.free, name);
        row.emplace_back();
        if (one) row.back() = one->mean_ns;
      }
      t.rows.push_back(std::move(row));
    }
  }
  return t;
}

}  // namespace moltact::bench
