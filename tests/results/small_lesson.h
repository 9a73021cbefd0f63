// A lesson of 3 steps with 2 tasks and 2 questions, and a hand that touches an atom. For the tests of this folder.
#pragma once

#include <doctest/doctest.h>

#include <memory>

#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"
#include "tests/lesson/small_molecules.h"

namespace moltact {

inline std::shared_ptr<const Lesson> smallLesson() {
  LessonReading read = readLessonText(
      "lessons/small.md",
      "---\ntitle: Small\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n"
      "## One\n```scene\nmolecule: mix\n```\n```touch\nreach: atom 0\nsay: S\npraise: P.\n```\n"
      "```touch\nreach: atom 1\nsay: Then this.\n```\n"
      "### Question: Which?\n- [x] yes → Good\n- [ ] no → Bad\n"
      "## Two\n### Question: How long?\n```answer\nnumber: 1.4 Å\ntolerance: 0.1 Å\nwrong: Measure again.\n```\n"
      "## Three\nThe end.\n");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

inline TouchSample touching(std::int32_t atom, double time_s, double force_N = 0.5) {
  TouchSample s;
  s.time_s = time_s;
  s.contact.feature = Feature::Sphere;
  s.contact.atoms[0] = atom;
  s.force.N = {0, 0, force_N};
  return s;
}

/// Touches an atom for 0.15 s.
inline void touchFor150ms(LessonSession& session, std::int32_t atom, double from_s) {
  for (int i = 0; i <= 150; ++i) session.feed(touching(atom, from_s + i * 0.001));
}

}  // namespace moltact
