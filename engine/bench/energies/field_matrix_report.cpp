// The tables and sentences of field_matrix.h.
#include "engine/bench/energies/field_matrix.h"
#include "engine/bench/failure_matrix.h"

namespace moltact::bench {
namespace {

constexpr FailureCriterion<FieldResult> kFieldCriteria[] = {
    {'O', "goes into an atom", [](const FieldResult& r) { return r.overlap_A; }},
    {'E', "makes energy", [](const FieldResult& r) { return 1e6 * r.made_J; }},
    {'S', "steps", [](const FieldResult& r) { return r.step_N; }},
    {'J', "vibrates", [](const FieldResult& r) { return r.jitter_mm; }},
    {'N', "gives no number", [](const FieldResult& r) { return double(r.broken); }},
};

FailureMatrix<FieldResult> fieldRuns(const std::vector<FieldResult>& results, const FieldLimits& limits) {
  return {results, kFieldCriteria, [](const FieldResult& r) { return r.method; },
          [limits](const FieldResult& r) { return failuresOf(r, limits); }};
}

}  // namespace

ReportTable fieldMatrix(const std::vector<FieldResult>& results, const FieldLimits& limits) {
  const FailureMatrix<FieldResult> runs = fieldRuns(results, limits);
  ReportTable t{"field_matrix", "Forces between atoms: failures by scene", {{"scene", "scene"}}, {}, ""};
  t.note = "O: the probe is more than " + constant(limits.overlap_A) +
           " A inside an atom (A). E: energy made at the device, over " + constant(1e6 * limits.made_J) +
           " uJ more than sampling a spring of the loop's stiffness can make (uJ). S: the force steps by over " +
           constant(limits.step_N) + " N in a tick of a slow hand (N). J: the held device vibrates by over " +
           constant(limits.jitter_mm) +
           " mm (mm). N: not a number (ticks). Each with the greatest value, and in brackets in how many of " +
           std::to_string(runs.draws()) + " draws. \"sound\": none in any draw.";
  runs.addTo(t);
  return t;
}

ReportTable fieldScenesTable() {
  ReportTable t{
      "field_scenes", "Forces between atoms: the scenes", {{"scene", "scene"}, {"question", "question"}}, {}, ""};
  for (const FieldScene& s : fieldScenes(1, 0)) t.rows.push_back({s.name, s.question});
  return t;
}

std::string fieldMatrixSentences(const std::vector<FieldResult>& results, const FieldLimits& limits) {
  return fieldRuns(results, limits).sentences();
}

}  // namespace moltact::bench
