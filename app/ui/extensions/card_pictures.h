// Small pictures of molecules for the welcome page, rendered by the program. Molecules are read one at a time in the
// background. The pictures are stored in the cache folder under their contents, so that the next start finds them.
// Window's thread, with the GL context.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/extension.h"
#include "engine/lesson/lesson.h"
#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct ApplicationOptions;
struct Settings;

class Renderer;

/// The contents of a picture: a molecule with the view and the marks of a lesson's scene.
struct CardSubject {
  MoleculeKey molecule;
  SceneSpec scene;
};

class CardPictures : public Extension {
 public:
  CardPictures(const Settings& settings, const ApplicationOptions& options);
  ~CardPictures() override;

  static constexpr int kWidth_px = 512, kHeight_px = 288;

  /// The picture as a texture, first row at the top; null until it has been drawn. Call in each frame that shows the
  /// card: only pictures that were asked for in the present frame are drawn, one at a time.
  ImTextureID find(const CardSubject& subject);

  void afterPanels() override;
  bool live() const override { return waiting_ || job_.valid(); }

  /// The number of pictures drawn since the start, not taken from the cache.
  std::size_t drawn() const { return drawn_; }

 private:
  const Settings& settings_;
  const ApplicationOptions& options_;
  // The result of the background job: the picture from the cache, or the molecule to draw.
  struct Job {
    std::string key;
    CardSubject subject;
    std::filesystem::path kept;  // its path in the cache; empty: not cached
    std::optional<Picture> picture;
    std::optional<ViewScene> scene;  // the scene to draw, without colours
  };
  struct Card;

  void finish(Job job);

  std::map<std::string, std::unique_ptr<Card>> cards_;       // by their subjects, in the present theme
  std::vector<std::pair<std::string, CardSubject>> wanted_;  // of this frame, not begun
  bool waiting_ = false;                                     // pictures were wanted in the last frame
  std::future<Job> job_;
  std::unique_ptr<Renderer> renderer_;
  std::string look_;
  std::size_t drawn_ = 0;
};

}  // namespace moltact
