// The tables and sentences of body_matrix.h.
#include <algorithm>
#include <map>

#include "engine/bench/bodies/body_matrix.h"

namespace moltact::bench {
namespace {

// A criterion, its name in sentences and its value.
struct Criterion {
  char letter;
  const char* fails;
  double (*value)(const BodyResult&);
};
constexpr Criterion kCriteria[] = {
    {'O', "overlaps the scene", [](const BodyResult& r) { return r.overlap_A; }},
    {'T', "tunnels", [](const BodyResult& r) { return double(r.tunnelled); }},
    {'E', "makes energy", [](const BodyResult& r) { return r.energy_NA; }},
    {'U', "is not at rest under a standing hand", [](const BodyResult& r) { return double(r.unrested); }},
    {'F', "gives a wrong force", [](const BodyResult& r) { return r.force_N; }},
    {'J', "jitters under a standing hand", [](const BodyResult& r) { return r.jitter_N; }},
    {'N', "gives no number", [](const BodyResult& r) { return double(r.broken); }},
};

// Runs of one scene and method.
using Runs = std::vector<const BodyResult*>;

Runs runsOf(const std::vector<BodyResult>& results, const std::string& scene, const BodyMethod* method) {
  Runs out;
  for (const BodyResult& r : results)
    if (r.scene == scene && r.method == method) out.push_back(&r);
  return out;
}

template <class Key>
auto inOrder(const std::vector<BodyResult>& results, Key key) {
  std::vector<decltype(key(results.front()))> out;
  for (const BodyResult& r : results)
    if (std::find(out.begin(), out.end(), key(r)) == out.end()) out.push_back(key(r));
  return out;
}
std::vector<std::string> scenesOf(const std::vector<BodyResult>& results) {
  return inOrder(results, [](const BodyResult& r) { return r.scene; });
}
std::vector<const BodyMethod*> methodsOf(const std::vector<BodyResult>& results) {
  return inOrder(results, [](const BodyResult& r) { return r.method; });
}

double greatest(const Runs& runs, double (*value)(const BodyResult&)) {
  double out = 0;
  for (const BodyResult* r : runs) out = std::max(out, value(*r));
  return out;
}

}  // namespace

ReportTable bodyMatrix(const std::vector<BodyResult>& results, const BodyLimits& limits) {
  std::size_t draws = 0;
  for (const BodyResult& r : results) draws = std::max(draws, r.draw + 1);
  ReportTable t{"body_matrix", "Rigid bodies: failures by scene", {{"scene", "scene"}}, {}, ""};
  t.note = "O: overlap of over " + constant(limits.overlap_A) +
           " A (A). T: tunnelling (events). E: energy made in a tick, over " + constant(limits.energy_NA) +
           " N A (N A). U: not at rest, or moving by over " + constant(limits.rest_A) +
           " A a tick, in the last 100 ticks of a standing hand (ticks). F: rms error of the force of over " +
           constant(limits.force_N) + " N, with a spring of 1 N per A (N). J: jitter of the force of over " +
           constant(limits.jitter_N) +
           " N in these 100 ticks (N). N: not a number. Each with the greatest value, and in brackets in how many of " +
           std::to_string(draws) + " draws. \"sound\": none in any draw.";
  const auto methods = methodsOf(results);
  for (const BodyMethod* m : methods) t.columns.push_back({std::string(m->name), std::string(m->name)});
  for (const std::string& scene : scenesOf(results)) {
    std::vector<Cell> row{scene};
    for (const BodyMethod* m : methods) {
      const Runs runs = runsOf(results, scene, m);
      std::string text;
      for (const Criterion& c : kCriteria) {
        const auto failed = std::count_if(runs.begin(), runs.end(), [&](const BodyResult* r) {
          return failuresOf(*r, limits).find(c.letter) != std::string::npos;
        });
        if (!failed) continue;
        text += (text.empty() ? "" : ", ") + std::string(1, c.letter) + ' ' + readable(greatest(runs, c.value)) + " (" +
                std::to_string(failed) + ')';
      }
      row.push_back(text.empty() ? "sound" : text);
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

ReportTable bodyMatrixFigures(const std::vector<BodyResult>& results) {
  ReportTable t{"body_matrix_values",
                "Rigid bodies: the greatest value of the draws",
                {{"scene", "scene"},
                 {"method", "method"},
                 {"ticks", "ticks"},
                 {"contact_ticks", "in contact"},
                 {"judged", "force judged"},
                 {"overlap_A", "overlap (A)"},
                 {"tunnelled", "tunnelled"},
                 {"energy_NA", "energy made (N A)"},
                 {"unrested", "not at rest"},
                 {"force_N", "force error, rms (N)"},
                 {"torque_NA", "torque error, rms (N A)"},
                 {"position_A", "position error, rms (A)"},
                 {"jitter_N", "jitter (N)"}},
                {},
                ""};
  for (const std::string& scene : scenesOf(results))
    for (const BodyMethod* m : methodsOf(results)) {
      const Runs runs = runsOf(results, scene, m);
      t.rows.push_back({scene, std::string(m->name),
                        greatest(runs, [](const BodyResult& r) { return double(r.ticks); }),
                        greatest(runs, [](const BodyResult& r) { return double(r.contact_ticks); }),
                        greatest(runs, [](const BodyResult& r) { return double(r.judged); }),
                        greatest(runs, [](const BodyResult& r) { return r.overlap_A; }),
                        greatest(runs, [](const BodyResult& r) { return double(r.tunnelled); }),
                        greatest(runs, [](const BodyResult& r) { return r.energy_NA; }),
                        greatest(runs, [](const BodyResult& r) { return double(r.unrested); }),
                        greatest(runs, [](const BodyResult& r) { return r.force_N; }),
                        greatest(runs, [](const BodyResult& r) { return r.torque_NA; }),
                        greatest(runs, [](const BodyResult& r) { return r.position_A; }),
                        greatest(runs, [](const BodyResult& r) { return r.jitter_N; })});
    }
  return t;
}

ReportTable bodyScenesTable() {
  ReportTable t{"body_scenes", "Rigid bodies: the scenes", {{"scene", "scene"}, {"question", "question"}}, {}, ""};
  for (const BodyScene& s : bodyScenes(1)) t.rows.push_back({s.name, s.question});
  return t;
}

std::string bodyMatrixSentences(const std::vector<BodyResult>& results, const BodyLimits& limits) {
  const auto scenes = scenesOf(results);
  std::string out;
  for (const BodyMethod* m : methodsOf(results)) {
    std::size_t sound = 0;
    std::map<char, std::vector<std::string>> failing;
    for (const std::string& scene : scenes) {
      std::string letters;
      for (const BodyResult* r : runsOf(results, scene, m)) letters += failuresOf(*r, limits);
      sound += letters.empty();
      for (const Criterion& c : kCriteria)
        if (letters.find(c.letter) != std::string::npos) failing[c.letter].push_back(scene);
    }
    out += "* `" + std::string(m->name) + "` is sound in " + std::to_string(sound) + " of " +
           std::to_string(scenes.size()) + " scenes.";
    for (const Criterion& c : kCriteria)
      if (const auto found = failing.find(c.letter); found != failing.end())
        out += std::string(" It ") + c.fails + " in " +
               (found->second.size() == scenes.size() ? "all of them." : listed(found->second) + ".");
    out += '\n';
  }
  return out;
}

}  // namespace moltact::bench
