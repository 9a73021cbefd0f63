// Small pictures of molecules for the welcome page, drawn by the program itself: one at a time, read in the background,
// and kept in the cache folder under what they show, so that the next start finds them. Window's thread, with the GL
// context.
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

/// The contents of a picture: a molecule as a lesson's scene turns and marks it.
struct CardSubject {
  MoleculeKey molecule;
  SceneSpec scene;
};

class CardPictures : public Extension {
 public:
  CardPictures(const Settings& settings, const ApplicationOptions& options);
  ~CardPictures() override;

  static constexpr int kWidth_px = 512, kHeight_px = 288;

  /// The picture as a texture, its first row at the top; null until it has been drawn. Asking for it puts it in the
  /// queue.
  ImTextureID find(const CardSubject& subject);

  void afterPanels() override;
  bool live() const override { return !queue_.empty() || job_.valid(); }

  /// Drawn since the start and not taken from the cache.
  std::size_t drawn() const { return drawn_; }

 private:
  const Settings& settings_;
  const ApplicationOptions& options_;
  // The background's result for a picture: found in the cache, or the molecule read for drawing.
  struct Job {
    std::string key;
    CardSubject subject;
    std::filesystem::path kept;  // where it belongs in the cache; empty: nowhere
    std::optional<Picture> picture;
    std::optional<ViewScene> scene;  // what is to be drawn, but for the colours
  };
  struct Card;

  void finish(Job job);

  std::map<std::string, std::unique_ptr<Card>> cards_;  // by what was asked for in this look
  std::vector<std::pair<std::string, CardSubject>> queue_;
  std::future<Job> job_;
  std::unique_ptr<Renderer> renderer_;
  std::string look_;
  std::size_t drawn_ = 0;
};

}  // namespace moltact
