// A scene of the task rank in the window: a row of ions with three ligands in one place above it.
#pragma once

#include <set>
#include <string>

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {

inline std::string pdbIon(int serial, const char* residue, char chain, int number, const Vec3& at) {
  char line[96];
  std::snprintf(line, sizeof line, "HETATM%5d %-4s %3s %c%4d    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n", serial,
                residue, residue, chain, number, at.x, at.y, at.z, residue);
  return line;
}

// A row of ions with three ligands in one place above it: Mg2+, K+ and a pair of ions.
struct RankWindow {
  Scratch scratch;
  std::unique_ptr<ScriptedUser> d;

  RankWindow() {
    std::string pdb;
    int serial = 0;
    const auto ion = [&](const char* name, char chain, const Vec3& at) {
      ++serial;
      pdb += pdbIon(serial, name, chain, serial, at);
    };
    for (int k = -2; k <= 2; ++k) ion(k % 2 ? "NA" : "CL", 'A', {4.0 * k, 0, 0});
    ion("MG", 'B', {0, 0, 3.4});
    ion(" K", 'C', {0, 0.2, 3.6});
    ion("NA", 'D', {0, 0, 3.5});
    ion("CL", 'D', {4, 0, 3.5});
    scratch.file("ions.pdb", pdb);
    d = startWith(scratch
                      .file("mine.md",
                            "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules:\n  - ions\nauthor: A\nlicence: L\n---\n"
                            "## One\n```scene\nmolecule: ions\nin-hand: chain C\nremove: chain B or chain D\n"
                            "forces: electrostatic\ndielectric: vacuum\ncoupling: 100 N/m\n```\n```touch\n"
                            "rank: chain B then chain C then chain D\nfirst: the firmest\nfor: 0.5 s\ngoal: 1\n"
                            "say: Put them in order.\n```\n")
                      .string());
    d->frames(10);
  }
  HapticSession& scene() { return d->app().scene; }
  LessonSession& session() { return *d->app().lesson.session(); }
  bool offers(std::string_view word) {
    for (const TaskButton& b : session().taskAt(0)->buttons())
      if (b.word == word) return true;
    return false;
  }
  PoseA place() { return {*session().taskStage().body_begins, *session().taskStage().body_turned}; }
  double offPlace_A() { return glm::distance(scene().log().latest().hip.A, place().place.A); }

  /// Presses, and leads the ligand aside until it has been felt; calls `seen` meanwhile.
  template <class Seen>
  void feel(Seen seen) {
    d->point("view", 0.5, 0.5);
    d->frames(5);
    d->press();
    for (int n = 0; n < 10; ++n) {
      d->frames(2);
      seen();
    }
    // Sideways, until the hand is 1.5 A off; where a ligand is bound firmly the mouse's hand gives way.
    for (double x = 0.5; x < 0.9 && offPlace_A() < 1.5; x += 0.004) {
      d->point("view", x, 0.5);
      d->frames(2);
    }
    for (int n = 0; n < 60 && !offers("next"); ++n) {
      d->frames(1);
      if (n > 5) seen();
    }
    REQUIRE(offers("next"));
  }

  /// The words in the window now, without figures.
  void read(std::set<std::string>& words) {
    for (const auto& [name, record] : widgets().all()) {
      if (name == "view/force meter" || name == "view/push" || name == "view/force" || name == "view/depth" ||
          name == "plot/force" || record.text.empty())
        continue;
      std::string text = record.text;
      std::erase_if(text, [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == ','; });
      words.insert(name + ": " + text);
    }
  }
};

}  // namespace moltact
