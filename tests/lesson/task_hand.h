// Creates tasks from keys, and a hand that passes synthetic samples to them, at 1 kHz by default.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "engine/lesson/key_lines.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/small_molecules.h"

namespace moltact {

using Keys = std::vector<std::pair<std::string, std::string>>;

/// The reader's result for a touch block with these keys, and its problems.
inline TaskSpec specOf(const std::string& kind, const Keys& keys, std::vector<Problem>& problems) {
  const TaskKind* found = findTaskKind(kind);
  REQUIRE(found);
  std::vector<KeyLine> lines{{"say", "Do it.", {}, {}, {}}};
  for (const auto& [k, v] : keys) lines.push_back({k, v, {}, {1, 1}, {}});
  std::vector<const KeySpec*> specs = pointersTo(found->keys);
  for (const KeySpec& k : keysOf(KeyBlock::Touch)) specs.push_back(&k);
  TaskSpec spec{kind, readKeyValues(lines, specs, "touch", {}, problems), {}, {}};
  if (problems.empty() && found->check) found->check(spec, problems);
  return spec;
}

/// The first problem's message; empty if there is none.
inline std::string problemOf(const std::string& kind, const Keys& keys) {
  std::vector<Problem> problems;
  specOf(kind, keys, problems);
  return problems.empty() ? std::string() : problems.front().message;
}

inline std::unique_ptr<Task> task(const std::string& kind, const Keys& keys,
                                  const Molecule& molecule = mixedMolecule()) {
  std::vector<Problem> problems;
  const TaskSpec spec = specOf(kind, keys, problems);
  REQUIRE_MESSAGE(problems.empty(), problems.front().text());
  return makeTask(spec, molecule);
}

inline double figure(const Task& task, std::string_view name) {
  for (const TaskFigure& f : task.figures())
    if (f.name == name) return f.value;
  return std::nan("");
}

/// A hand that touches atoms for a while.
struct Hand {
  Task& task;
  double time_s = 0.0, dt_s = 0.001;

  void touch(std::vector<std::int32_t> atoms, double seconds, double force_N = 0.5, Vec3 scp = {0, 0, 0},
             double depth_A = 0.5) {
    TouchSample s;
    s.contact.scp = {scp};
    s.hip.A = scp - Vec3(0, 0, depth_A);
    s.force.N = {0, 0, force_N};
    for (std::size_t i = 0; i < atoms.size(); ++i) s.contact.atoms[i] = atoms[i];
    s.contact.feature = static_cast<Feature>(atoms.size());
    if (s.contact.touching()) stretchToScp(s.contact, s.hip);
    for (int i = 0, n = static_cast<int>(seconds / dt_s + 0.5); i < n; ++i) {
      s.time_s = time_s += dt_s;
      task.feed(s);
    }
  }
  void away(double seconds) { touch({}, seconds, 0.0); }
  /// Slides the contact point in a straight line at 1 A/s.
  void slide(std::vector<std::int32_t> atoms, Vec3 from, Vec3 to, double force_N = 0.5) {
    const int ticks = std::max(1, int(glm::distance(from, to) * 1000.0));
    for (int k = 0; k <= ticks; ++k) touch(atoms, dt_s, force_N, from + (to - from) * (double(k) / ticks));
  }
};

}  // namespace moltact
