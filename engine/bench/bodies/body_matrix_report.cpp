// The tables and sentences of body_matrix.h.
#include "engine/bench/bodies/body_matrix.h"
#include "engine/bench/failure_matrix.h"

namespace moltact::bench {
namespace {

constexpr FailureCriterion<BodyResult> kBodyCriteria[] = {
    {'O', "overlaps the scene", [](const BodyResult& r) { return r.overlap_A; }},
    {'T', "tunnels", [](const BodyResult& r) { return double(r.tunnelled); }},
    {'E', "makes energy", [](const BodyResult& r) { return r.energy_NA; }},
    {'U', "is not at rest under a standing hand", [](const BodyResult& r) { return double(r.unrested); }},
    {'F', "gives a wrong force", [](const BodyResult& r) { return r.force_N; }},
    {'J', "jitters under a standing hand", [](const BodyResult& r) { return r.jitter_N; }},
    {'N', "gives no number", [](const BodyResult& r) { return double(r.broken); }},
};

FailureMatrix<BodyResult> bodyRuns(const std::vector<BodyResult>& results, const BodyLimits& limits) {
  return {results, kBodyCriteria, [](const BodyResult& r) { return r.method->name; },
          [limits](const BodyResult& r) { return failuresOf(r, limits); }};
}

}  // namespace

ReportTable bodyMatrix(const std::vector<BodyResult>& results, const BodyLimits& limits) {
  const FailureMatrix<BodyResult> runs = bodyRuns(results, limits);
  ReportTable t{"body_matrix", "Rigid bodies: failures by scene", {{"scene", "scene"}}, {}, ""};
  t.note = "O: overlap of over " + constant(limits.overlap_A) +
           " A (A). T: tunnelling (events). E: energy made in a tick, over " + constant(limits.energy_NA) +
           " N A (N A). U: not at rest, or moving by over " + constant(limits.rest_A) +
           " A a tick, in the last 100 ticks of a standing hand (ticks). F: rms error of the force of over " +
           constant(limits.force_N) + " N, with a spring of 1 N per A (N). J: jitter of the force of over " +
           constant(limits.jitter_N) +
           " N in these 100 ticks (N). N: not a number. Each with the greatest value, and in brackets in how many of " +
           std::to_string(runs.draws()) + " draws. \"sound\": none in any draw.";
  runs.addTo(t);
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
  const FailureMatrix<BodyResult> runs = bodyRuns(results, {});
  for (const std::string& scene : runs.scenes())
    for (const std::string& m : runs.methods()) {
      const auto greatest = [&](double (*value)(const BodyResult&)) { return runs.greatest(scene, m, value); };
      t.rows.push_back({scene, m, greatest([](const BodyResult& r) { return double(r.ticks); }),
                        greatest([](const BodyResult& r) { return double(r.contact_ticks); }),
                        greatest([](const BodyResult& r) { return double(r.judged); }),
                        greatest([](const BodyResult& r) { return r.overlap_A; }),
                        greatest([](const BodyResult& r) { return double(r.tunnelled); }),
                        greatest([](const BodyResult& r) { return r.energy_NA; }),
                        greatest([](const BodyResult& r) { return double(r.unrested); }),
                        greatest([](const BodyResult& r) { return r.force_N; }),
                        greatest([](const BodyResult& r) { return r.torque_NA; }),
                        greatest([](const BodyResult& r) { return r.position_A; }),
                        greatest([](const BodyResult& r) { return r.jitter_N; })});
    }
  return t;
}

ReportTable bodyScenesTable() {
  ReportTable t{"body_scenes", "Rigid bodies: the scenes", {{"scene", "scene"}, {"question", "question"}}, {}, ""};
  for (const BodyScene& s : bodyScenes(1)) t.rows.push_back({s.name, s.question});
  return t;
}

std::string bodyMatrixSentences(const std::vector<BodyResult>& results, const BodyLimits& limits) {
  return bodyRuns(results, limits).sentences();
}

}  // namespace moltact::bench
