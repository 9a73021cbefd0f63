#include "app/ui/extensions/atom_movers.h"

#include <algorithm>

#include "app/ui/extensions/elastic_molecule.h"
#include "app/ui/extensions/live_molecule.h"
#include "app/ui/extensions/moving_states.h"
#include "app/ui/extensions/played_trajectory.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/language/catalogue.h"

namespace moltact {

AtomMovers::AtomMovers(const MoverParts& parts) : parts_(parts) {
  parts_.movers = this;
#define MOLTACT_ADD(Mover) add<Mover>();
  MOLTACT_ATOM_MOVERS(MOLTACT_ADD)
#undef MOLTACT_ADD
}

std::string AtomMover::unavailable() const {
  const LessonSession* session = lesson_.session();
  if (session && lesson_.onStage() && !session->scene().then.molecule.empty())
    return tr("The slider moves the atoms of this scene.");
  return {};
}

bool AtomMover::start() {
  if (!unavailable().empty()) return false;
  if (movers_) movers_->endOthers(*this);
  onStart();
  return true;
}

AtomMover* AtomMovers::ofKind(std::string_view kind) const {
  for (const auto& mover : all_)
    if (mover->kind() == kind) return mover.get();
  return nullptr;
}

const AtomMover* AtomMovers::present() const {
  const AtomMover* first = nullptr;
  for (const auto& mover : all_) {
    if (!mover->position()) continue;
    if (mover->owns()) return mover.get();
    if (!first) first = mover.get();
  }
  return first;
}

std::optional<AtomsMoved> AtomMovers::position() const {
  const AtomMover* mover = present();
  if (!mover) return std::nullopt;
  std::optional<AtomsMoved> out = mover->position();
  out->by = mover->kind();
  return out;
}

void AtomMovers::atStart() {
  for (const auto& mover : all_) mover->atStart();
}

void AtomMovers::endOthers(const AtomMover& chosen) {
  for (const auto& mover : all_)
    if (mover.get() != &chosen) mover->end();
}

void AtomMovers::beforeTicks() {
  for (const auto& mover : all_) mover->beforeTicks();
}

void AtomMovers::ticks(const FeltTicks& felt) {
  for (const auto& mover : all_) mover->ticks(felt);
}

void AtomMovers::lessonEvents(std::span<const SessionEvent> events) {
  for (const auto& mover : all_) mover->lessonEvents(events);
}

void AtomMovers::afterPanels() {
  for (const auto& mover : all_) mover->afterPanels();
}

void AtomMovers::beforeOpening(FileKind kind) {
  for (const auto& mover : all_) mover->beforeOpening(kind);
}

bool AtomMovers::open(FileKind kind, const std::filesystem::path& file) {
  return std::any_of(all_.begin(), all_.end(), [&](const auto& mover) { return mover->open(kind, file); });
}

void AtomMovers::lessonRefused(const std::filesystem::path& file) {
  for (const auto& mover : all_) mover->lessonRefused(file);
}

void AtomMovers::sceneChanged() {
  for (const auto& mover : all_) mover->sceneChanged();
}

void AtomMovers::lessonChanged() {
  for (const auto& mover : all_) mover->lessonChanged();
}

void AtomMovers::stepChanged() {
  for (const auto& mover : all_) mover->stepChanged();
}

void AtomMovers::viewReset(const Camera& seen) {
  for (const auto& mover : all_) mover->viewReset(seen);
}

void AtomMovers::atEnd() {
  for (const auto& mover : all_) mover->atEnd();
}

bool AtomMovers::live() const {
  return std::any_of(all_.begin(), all_.end(), [](const auto& mover) { return mover->live(); });
}

bool AtomMovers::leadsHand() const {
  return std::any_of(all_.begin(), all_.end(), [](const auto& mover) { return mover->leadsHand(); });
}

bool AtomMovers::hidesLesson() const {
  return std::any_of(all_.begin(), all_.end(), [](const auto& mover) { return mover->hidesLesson(); });
}

}  // namespace moltact
