#include "app/ui/panels/lesson/hand_in.h"

#include <filesystem>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "engine/language/catalogue.h"
#include "engine/platform/hand_over.h"
#include "engine/platform/read_file.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxBytes = std::size_t{1} << 30;  // of an attempt

void copyTo(Application& app, const std::filesystem::path& from, const std::filesystem::path& to) {
  const Expected<std::string> lines = readFile(from, kMaxBytes, "");
  if (!lines) return app.messages.error(lines.problem().text());
  if (const auto problem = writeWhole(to, *lines)) return app.messages.error(problem->text());
  handOver(to);
  app.messages.notice(trf("Your results are in {0}; hand in this file.", to.filename().string()));
}

}  // namespace

bool canHandIn(const Application& app) { return !app.extensions().recorder.file().empty(); }

void handIn(Application& app) {
  AttemptRecorder& recorder = app.extensions().recorder;
  recorder.flush();
  const std::filesystem::path file = recorder.file();
  app.file_dialog.ask({.title = tr("Hand in my results"),
                       .name = file.filename().string(),
                       .ending = ".jsonl",
                       .chosen = [&app, file](const std::filesystem::path& to) { copyTo(app, file, to); }},
                      app.options().picture_folder);
}

}  // namespace moltact
