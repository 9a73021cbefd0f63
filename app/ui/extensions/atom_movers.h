// All movers of atoms: passes the window's events to them, and finds the one that moves the atoms of the open scene or
// of a recorded position. Window's thread.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/ui/extensions/atom_mover.h"

namespace moltact {

// All movers of the program, by their class. Of two that could move the atoms of a scene, the first one does. For each, a
// file of app/ui/panels defines draw<Class>Section(Application&), its part of the tab Motion (motion_sections.h).
#define MOLTACT_ATOM_MOVERS(MOVER) \
  MOVER(MovingStates)              \
  MOVER(PlayedTrajectory)          \
  MOVER(LiveMolecule)              \
  MOVER(ElasticMolecule)

class AtomMovers : public Extension {
 public:
  /// Makes the movers of the program.
  explicit AtomMovers(const MoverParts& parts);

  /// Adds a mover of this class.
  template <class Mover>
  Mover& add() {
    auto made = std::make_unique<Mover>(parts_);
    Mover& out = *made;
    all_.push_back(std::move(made));
    return out;
  }
  /// The mover of this class, which must have been added.
  template <class Mover>
  Mover& get() const {
    for (const auto& mover : all_)
      if (auto* found = dynamic_cast<Mover*>(mover.get())) return *found;
    std::terminate();
  }

  /// The mover of this kind; null if there is none, as for an attempt of a later version.
  AtomMover* ofKind(std::string_view kind) const;
  /// The mover of the open scene: the one that owns the atoms, else the first that has a position; null if there is
  /// none.
  const AtomMover* present() const;
  /// Its position, with its kind; empty if nothing moves the atoms of the open scene.
  std::optional<AtomsMoved> position() const;

  /// Ends what the other movers do, because this one starts (AtomMover::start).
  void endOthers(const AtomMover& chosen);

  // Every event of an Extension.
  void atStart() override;
  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  void lessonEvents(std::span<const SessionEvent> events) override;
  void afterPanels() override;
  void beforeOpening(FileKind kind) override;
  bool open(FileKind kind, const std::filesystem::path& file) override;
  void lessonRefused(const std::filesystem::path& file) override;
  void sceneChanged() override;
  void lessonChanged() override;
  void stepChanged() override;
  void viewReset(const Camera& seen) override;
  void atEnd() override;
  bool live() const override;
  bool leadsHand() const override;
  bool hidesLesson() const override;

 private:
  MoverParts parts_;
  std::vector<std::unique_ptr<AtomMover>> all_;
};

}  // namespace moltact
