#include "app/ui/extensions/lesson_pictures.h"

#include <chrono>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/widgets/imgui_versions.h"
#include "engine/language/catalogue.h"
#include "engine/platform/background.h"
#include "engine/render/gl.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr double kPictureAgain_s = 2.0;  // a missing picture is looked for again at this interval
constexpr int kLongest_px = 2048;        // every WebGL 2 supports textures of this size

GLuint textureFor(const LessonPicture& p) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  glBindTexture(GL_TEXTURE_2D, texture);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, p.width_px, p.height_px, 0, GL_RGB, GL_UNSIGNED_BYTE, p.rgb.data());
  // Mipmaps, because a panel is narrower than most pictures.
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, GLuint(bound));
  return texture;
}

}  // namespace

struct LessonPictures::Kept {
  Shown shown;
  GLuint texture = 0;
  double failed_s = 0.0;  // the time when it could not be read
  Kept() = default;
  Kept(const Kept&) = delete;
  Kept& operator=(const Kept&) = delete;
  ~Kept() {
    if (texture) glDeleteTextures(1, &texture);
  }
};

LessonPictures::LessonPictures(const ApplicationOptions& options, const FrameTime& time)
    : options_(options), time_(time) {}
LessonPictures::~LessonPictures() = default;

const LessonPictures::Shown& LessonPictures::find(const fs::path& file) {
  const fs::path plain = file.lexically_normal();  // "a.png" and "./a.png" are decoded once
  auto [at, is_new] = kept_.try_emplace(plain);
  if (is_new) {
    at->second = std::make_unique<Kept>();
    queue_.push_back(plain);
  }
  return at->second->shown;
}

void LessonPictures::lessonChanged() {
  kept_.clear();
  queue_.clear();
}

void LessonPictures::afterPanels() {
  const bool wait = options_.clock == ServoClock::Frames;  // deterministic on the frames' clock
  if (job_.valid() && (wait || job_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)) {
    Job done = job_.get();
    if (const auto at = kept_.find(done.file); at != kept_.end()) {
      Kept& kept = *at->second;
      kept.shown = {{}, done.width_px, done.height_px, std::move(done.fault)};
      kept.failed_s = time_.now_s;
      if (done.picture) {
        kept.texture = textureFor(*done.picture);
        kept.shown.texture = textureOf(kept.texture);
      }
    }
  }
  if (!job_.valid() && queue_.empty())
    for (auto& [file, kept] : kept_) {
      if (kept->shown.fault.empty() || time_.now_s - kept->failed_s < kPictureAgain_s) continue;
      kept->failed_s = time_.now_s;
      std::error_code error;
      if (fs::exists(file, error)) queue_.push_back(file);
    }
  if (job_.valid() || queue_.empty()) return;
  fs::path file = std::move(queue_.front());
  queue_.pop_front();
  job_ = inBackground([file = std::move(file)]() {
    Job job{file, {}, 0, 0, {}};
    Expected<LessonPicture> read = readLessonPicture(file);
    if (!read) {
      job.fault = trf("'{0}' cannot be shown: {1}", file.filename().string(), read.problem().message);
      return job;
    }
    job.width_px = read->width_px;
    job.height_px = read->height_px;
    job.picture = halvedTo(*std::move(read), kLongest_px);
    return job;
  });
}

}  // namespace moltact
