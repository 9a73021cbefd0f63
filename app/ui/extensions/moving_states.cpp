#include "app/ui/extensions/moving_states.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/molecule/reader.h"

namespace moltact {
namespace {

constexpr int kMotion_ticks = 33;  // about thirty motions per second

Expected<TwoStates> readStates(const SceneSpec& scene, const std::shared_ptr<const Molecule>& molecule,
                               const MoleculeKey& key) {
  try {
    const Expected<Molecule> other = readMolecule(key);
    if (!other) return other.problem();
    return statesOf(scene, *molecule, *other);
  } catch (const std::exception& e) {
    return Problem{key.file.string(), 0, 0, trf("it cannot be opened: {0}", e.what()), tr("check the file")};
  }
}

}  // namespace

void MovingStates::forget() {
  own_.release();
  reading_.drop();
  states_.reset();
  molecule_.reset();
  begins_.reset();
  then_ = {};
  file_.clear();
  share_ = wanted_ = 0.0;
}

void MovingStates::sceneChanged() {
  const LessonSession* session = lesson_.session();
  if (!session || !lesson_.onStage() || session->scene().then.molecule.empty()) return forget();
  const SceneSpec& scene = session->scene();
  const std::shared_ptr<const Molecule>& molecule = scene_.stage().molecule;
  names_ = {stateName(scene, 0), stateName(scene, 1)};
  const bool known = states_ && molecule == molecule_ && then_.molecule == scene.then.molecule &&
                     then_.superposed_on == scene.then.superposed_on;
  then_ = scene.then;
  if (known) {
    // The scene has restarted with the atoms in the first structure.
    begin();
    return;
  }
  forget();
  then_ = scene.then;
  molecule_ = molecule;
  const Expected<MoleculeKey> key = lessonMolecule(lesson_.file(), secondMolecule(scene));
  if (!key) {
    messages_.error(key.problem().text());
    return;
  }
  file_ = key->file;
  reading_.begin(inBackground(readStates, scene, molecule, *key));
  if (options_.clock == ServoClock::Frames) take(*reading_.wait());
}

void MovingStates::take(Expected<TwoStates> states) {
  if (!states) {
    messages_.error(states.problem().text());
    return;
  }
  states_ = std::make_shared<const TwoStates>(*std::move(states));
  double farthest_A = 0.0;
  for (std::size_t i = 0; i < states_->first.size(); ++i)
    if (scene_.stage().spheres->touchable(i))
      farthest_A = std::max(farthest_A, glm::distance(states_->first[i].centre_A, states_->second[i].centre_A));
  per_s_ = farthest_A > 0.0 ? std::min(1.0 / kMin_s, kMaxSpeed_A_per_s / farthest_A) : 1.0 / kMin_s;
  begin();
}

// The scene begins at its share, unless another source moves the atoms.
void MovingStates::begin() {
  share_ = 0.0;
  wanted_ = then_.share;
  if (share_ == wanted_ || !own_.claim() || !place(own_)) return;
  // The same object each time the scene restarts, so that its tasks are kept.
  if (!begins_ || begins_share_ != share_)
    begins_ = std::make_shared<const Molecule>(molecule_->movedTo(states_->at(share_)));
  begins_share_ = share_;
  lesson_.beginFrom(begins_);
}

// The atoms are at the requested share at once.
bool MovingStates::place(const MotionSource& source) {
  if (!scene_.placeAtoms(source, states_->at(wanted_))) return false;
  share_ = wanted_;
  return true;
}

std::optional<AtomsMoved> MovingStates::position() const {
  if (!states_) return std::nullopt;
  return AtomsMoved{{}, file_.filename().string(), then_.superposed_on.text(), share_};
}

void MovingStates::show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& other) {
  SecondState then;
  then.molecule = position.file;
  then.share = std::clamp(position.position, 0.0, 1.0);
  if (!position.detail.empty())
    if (auto atoms = parseSelection(position.detail)) then.superposed_on = *std::move(atoms);
  const std::shared_ptr<const Molecule>& molecule = scene_.stage().molecule;
  const bool known = molecule == molecule_ && file_ == other.file && then_.superposed_on == then.superposed_on;
  if (!known) {
    forget();
    then_ = then;
    file_ = other.file;
    molecule_ = molecule;
    SceneSpec scene;
    scene.then = then;
    reading_.begin(inBackground(readStates, scene, molecule, other));
    if (options_.clock == ServoClock::Frames) take(*reading_.wait());
  }
  if (!states_ || share_ == then.share) return;
  wanted_ = then.share;
  place(source);
}

void MovingStates::goTo(double share) {
  if (std::isfinite(share)) wanted_ = std::clamp(share, 0.0, 1.0);
}

void MovingStates::beforeTicks() {
  if (std::optional<Expected<TwoStates>> read = reading_.take()) take(*std::move(read));
  if (!states_ || share_ == wanted_ || scene_.stage().molecule != molecule_) return;
  const double most = per_s_ * kMotion_ticks * kTick_s, next = share_ + std::clamp(wanted_ - share_, -most, most);
  // A motion can only be queued after the previous one has begun.
  if (own_.claim() && scene_.moveAtoms(own_, states_->at(next), kMotion_ticks)) share_ = next;
}

}  // namespace moltact
