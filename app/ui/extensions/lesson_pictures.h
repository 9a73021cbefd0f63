// The open lesson's pictures as textures. Each is read when it is first needed, one at a time in the background.
// Window's thread, with the GL context.
#pragma once

#include <imgui.h>

#include <deque>
#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/ui/application/extension.h"
#include "engine/core/problem.h"
#include "engine/lesson/lesson_picture.h"

namespace moltact {

struct ApplicationOptions;

class LessonPictures : public Extension {
 public:
  LessonPictures(const ApplicationOptions& options, const FrameTime& time);
  ~LessonPictures() override;

  struct Shown {
    ImTextureID texture{};            ///< first row at the top; null until it has been read
    int width_px = 0, height_px = 0;  ///< of the picture in the file
    std::string fault;                ///< why it cannot be shown; empty if it can or is not yet known
  };
  /// The first call for a file puts its picture into the queue.
  const Shown& find(const std::filesystem::path& file);

  void afterPanels() override;
  /// The files may have changed with the lesson.
  void lessonChanged() override;
  bool live() const override { return !queue_.empty() || job_.valid(); }

 private:
  const ApplicationOptions& options_;
  const FrameTime& time_;
  struct Kept;
  struct Job {
    std::filesystem::path file;
    std::optional<LessonPicture> picture;
    int width_px = 0, height_px = 0;
    std::string fault;
  };

  std::map<std::filesystem::path, std::unique_ptr<Kept>> kept_;
  std::deque<std::filesystem::path> queue_;
  std::future<Job> job_;
};

}  // namespace moltact
