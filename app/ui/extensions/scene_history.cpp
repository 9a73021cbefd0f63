#include "app/ui/extensions/scene_history.h"

#include <imgui.h>

#include "app/ui/extensions/scene_change.h"

namespace moltact {

SceneHistory::Choices SceneHistory::choices() const {
  return {scene_.touch(), scene_.view().fit.by_hand, scene_.look.shown, scene_.look.atoms, scene_.look.colour_by};
}

bool SceneHistory::Choices::operator==(const Choices& other) const {
  AtomsLook here = look;
  if (here.colouring && other.look.colouring && here.colouring->scheme == other.look.colouring->scheme)
    here.colouring = other.look.colouring;
  return touch == other.touch && magnified == other.magnified && shown == other.shown && here == other.look &&
         colour_by == other.colour_by;
}

void SceneHistory::apply(const Choices& c, const std::optional<Camera>& camera) {
  scene_.setTouch(c.touch);
  scene_.look.shown = c.shown;
  scene_.look.atoms = c.look;
  scene_.look.colour_by = c.colour_by;
  const Camera seen = scene_.camera;
  scene_.view().magnify(c.magnified);
  if (camera) {
    scene_.camera = *camera;
    change_.glide(seen);
  }
  current_ = c;
}

void SceneHistory::undo() {
  if (done_.empty()) return;
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  apply(undone_.back().before, undone_.back().camera_before);
}

void SceneHistory::redo() {
  if (undone_.empty()) return;
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  apply(done_.back().after, done_.back().camera_after);
}

// Undo restores the camera before the reset, or the destination of its glide.
void SceneHistory::viewReset(const Camera& seen) {
  const Camera before = change_.bound(seen);
  if (!(before == scene_.camera)) view_ = {before, scene_.camera};
}

void SceneHistory::afterPanels() {
  if (ImGui::IsAnyMouseDown()) return;
  Choices now = choices();
  if (!current_) current_ = now;
  const auto view = std::exchange(view_, std::nullopt);
  if (now == *current_ && !view) return;
  Change change{*current_, now, {}, {}};
  if (view) {
    change.camera_before = view->first;
    change.camera_after = view->second;
  }
  done_.push_back(std::move(change));
  if (done_.size() > kMax) done_.erase(done_.begin());
  undone_.clear();
  current_ = std::move(now);
}

void SceneHistory::begin() {
  done_.clear();
  undone_.clear();
  view_.reset();
  current_.reset();
}

}  // namespace moltact
