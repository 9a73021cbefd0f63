#include "app/ui/extensions/scene_history.h"

#include <imgui.h>

#include "app/ui/application/application.h"
#include "app/ui/extensions/scene_change.h"

namespace moltact {

SceneHistory::Choices SceneHistory::choicesOf(const Application& app) {
  return {app.scene.touch(), app.scene.magnifiedByHand(), app.scene.shown, app.scene.look, app.scene.colour_by};
}

void SceneHistory::apply(Application& app, const Choices& c, const std::optional<Camera>& camera) {
  app.scene.setTouch(c.touch);
  app.scene.shown = c.shown;
  app.scene.look = c.look;
  app.scene.colour_by = c.colour_by;
  const Camera seen = app.scene.camera;
  app.scene.magnify(c.magnified);
  if (camera) {
    app.scene.camera = *camera;
    change_.glide(app, seen);
  }
  current_ = c;
}

void SceneHistory::undo(Application& app) {
  if (done_.empty()) return;
  undone_.push_back(std::move(done_.back()));
  done_.pop_back();
  apply(app, undone_.back().before, undone_.back().camera_before);
}

void SceneHistory::redo(Application& app) {
  if (undone_.empty()) return;
  done_.push_back(std::move(undone_.back()));
  undone_.pop_back();
  apply(app, done_.back().after, done_.back().camera_after);
}

// Undo brings back the camera as it was, or where it was on its way to.
void SceneHistory::viewReset(Application& app, const Camera& seen) {
  const Camera before = change_.bound(seen);
  if (!(before == app.scene.camera)) view_ = {before, app.scene.camera};
}

void SceneHistory::afterPanels(Application& app) {
  if (ImGui::IsAnyMouseDown()) return;
  Choices now = choicesOf(app);
  if (!current_) current_ = now;
  const auto view = std::exchange(view_, std::nullopt);
  if (now == *current_ && !view) return;
  Change change{*current_, now, {}, {}};
  if (view) {
    change.camera_before = view->first;
    change.camera_after = view->second;
  }
  done_.push_back(std::move(change));
  if (done_.size() > kMost) done_.erase(done_.begin());
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
