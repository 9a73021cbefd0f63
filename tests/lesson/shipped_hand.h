// Hands for the tasks of the program's lessons: one that slides from atom to atom, one that jabs at them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/shipped_lesson.h"
#include "tests/lesson/task_hand.h"

namespace moltact::test {

/// The first task of this kind in a step; it must exist.
inline const TaskSpec& taskOf(const Lesson& lesson, const std::string& step, std::string_view kind) {
  const auto at = lesson.find(step);
  REQUIRE_MESSAGE(at, step);
  for (const TaskSpec& t : lesson.steps[*at].tasks)
    if (t.kind == kind) return t;
  FAIL(step << " has no task " << kind);
  return lesson.steps[*at].tasks[0];
}

/// The place where a probe rests on the atom as close as possible to the direction `out`; exactly in that direction,
/// above the atom, if there is none.
inline Vec3 restingOn(const ShippedScene& s, const std::string& atom, Vec3 out, double probe_A) {
  const PlacedAtom a = s.atom(atom);
  Vec3 best = a.position.A + out * (a.radius_A + probe_A);
  double most = -2;
  for (const SurfacePlace& p : s.places(atom, probe_A, 600))
    if (glm::dot(p.outward, out) > most) {
      most = glm::dot(p.outward, out);
      best = p.scp_A;
    }
  return best;
}

/// Rests on one atom after the other, on the side of `out`; with `jabbing`, releases between two atoms.
inline void touchInTurn(Task& task, const ShippedScene& s, const std::vector<std::string>& atoms, Vec3 out,
                        bool jabbing, double probe_A = 1.4) {
  Hand hand{task};
  for (const std::string& name : atoms) {
    if (jabbing) hand.away(0.5);
    hand.touch({static_cast<std::int32_t>(s.select(name).at(0))}, 0.3, 0.5, restingOn(s, name, out, probe_A));
  }
}

/// Whether this solves a new task of the lesson.
inline bool passes(const TaskSpec& spec, const ShippedScene& s, const std::vector<std::string>& atoms, Vec3 out,
                   bool jabbing) {
  const std::unique_ptr<Task> task = makeTask(spec, *s.molecule);
  touchInTurn(*task, s, atoms, out, jabbing);
  return task->done();
}

}  // namespace moltact::test
