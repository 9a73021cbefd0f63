// The tables and sentences of field_matrix.h.
#include <algorithm>
#include <map>

#include "engine/bench/energies/field_matrix.h"

namespace moltact::bench {
namespace {

struct FieldCriterion {
  char letter;
  const char* fails;
  double (*value)(const FieldResult&);
};
constexpr FieldCriterion kFieldCriteria[] = {
    {'O', "goes into an atom", [](const FieldResult& r) { return r.overlap_A; }},
    {'E', "makes energy", [](const FieldResult& r) { return 1e6 * r.made_J; }},
    {'S', "steps", [](const FieldResult& r) { return r.step_N; }},
    {'J', "vibrates", [](const FieldResult& r) { return r.jitter_mm; }},
    {'N', "gives no number", [](const FieldResult& r) { return double(r.broken); }},
};

std::vector<std::string> sceneNames(const std::vector<FieldResult>& results) {
  std::vector<std::string> out;
  for (const FieldResult& r : results)
    if (std::find(out.begin(), out.end(), r.scene) == out.end()) out.push_back(r.scene);
  return out;
}

}  // namespace

ReportTable fieldMatrix(const std::vector<FieldResult>& results, const FieldLimits& limits) {
  std::size_t draws = 0;
  for (const FieldResult& r : results) draws = std::max(draws, r.draw + 1);
  ReportTable t{"field_matrix", "Forces between atoms: failures by scene", {{"scene", "scene"}}, {}, ""};
  t.note = "O: the probe is more than " + constant(limits.overlap_A) +
           " A inside an atom (A). E: energy made at the device, over " + constant(1e6 * limits.made_J) +
           " uJ more than sampling a spring of the loop's stiffness can make (uJ). S: the force steps by over " +
           constant(limits.step_N) + " N in a tick of a slow hand (N). J: the held device vibrates by over " +
           constant(limits.jitter_mm) +
           " mm (mm). N: not a number (ticks). Each with the greatest value, and in brackets in how many of " +
           std::to_string(draws) + " draws. \"sound\": none in any draw.";
  for (const std::string_view m : kFieldMethods) t.columns.push_back({std::string(m), std::string(m)});
  for (const std::string& scene : sceneNames(results)) {
    std::vector<Cell> row{scene};
    for (const std::string_view m : kFieldMethods) {
      std::string text;
      for (const FieldCriterion& c : kFieldCriteria) {
        std::size_t failed = 0;
        double greatest = 0;
        for (const FieldResult& r : results) {
          if (r.scene != scene || r.method != m) continue;
          failed += failuresOf(r, limits).find(c.letter) != std::string::npos;
          greatest = std::max(greatest, c.value(r));
        }
        if (failed)
          text += (text.empty() ? "" : ", ") + std::string(1, c.letter) + ' ' + readable(greatest) + " (" +
                  std::to_string(failed) + ')';
      }
      row.push_back(text.empty() ? "sound" : text);
    }
    t.rows.push_back(std::move(row));
  }
  return t;
}

ReportTable fieldScenesTable() {
  ReportTable t{
      "field_scenes", "Forces between atoms: the scenes", {{"scene", "scene"}, {"question", "question"}}, {}, ""};
  for (const FieldScene& s : fieldScenes(1, 0)) t.rows.push_back({s.name, s.question});
  return t;
}

std::string fieldMatrixSentences(const std::vector<FieldResult>& results, const FieldLimits& limits) {
  const std::vector<std::string> scenes = sceneNames(results);
  std::string out;
  for (const std::string_view m : kFieldMethods) {
    std::size_t sound = 0;
    std::map<char, std::vector<std::string>> failing;
    for (const std::string& scene : scenes) {
      std::string letters;
      for (const FieldResult& r : results)
        if (r.scene == scene && r.method == m) letters += failuresOf(r, limits);
      sound += letters.empty();
      for (const FieldCriterion& c : kFieldCriteria)
        if (letters.find(c.letter) != std::string::npos) failing[c.letter].push_back(scene);
    }
    out += "* `" + std::string(m) + "` is sound in " + std::to_string(sound) + " of " + std::to_string(scenes.size()) +
           " scenes.";
    for (const FieldCriterion& c : kFieldCriteria)
      if (const auto found = failing.find(c.letter); found != failing.end())
        out += std::string(" It ") + c.fails + " in " +
               (found->second.size() == scenes.size() ? "all of them." : listed(found->second) + ".");
    out += '\n';
  }
  return out;
}

}  // namespace moltact::bench
