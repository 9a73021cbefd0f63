// A command's lesson argument: a lesson's file, or a pack, which stays unpacked while the command runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/problem.h"
#include "engine/pack/unpack.h"

namespace moltact {

class LessonArgument {
 public:
  /// Returns a Problem if a pack cannot be read. Does not check whether a lesson's file exists.
  static Expected<LessonArgument> open(const std::filesystem::path& named);

  /// The lesson's file. For a pack, the file of the lesson that is shown first.
  const std::filesystem::path& file() const { return file_; }
  /// The unpacked pack, or null if the argument is not a pack.
  const TemporaryPack* pack() const { return pack_ ? &*pack_ : nullptr; }

  /// Replaces the paths of unpacked files in a text by the names that the user knows: "haem.moltact/haem.md".
  std::string shown(std::string text) const { return pack_ ? pack_->shown(std::move(text)) : text; }
  Problem shown(Problem problem) const;

 private:
  std::filesystem::path file_;
  std::optional<TemporaryPack> pack_;
};

}  // namespace moltact
