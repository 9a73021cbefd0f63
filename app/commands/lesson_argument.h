// A lesson that a command is given: its file, or a pack, which is unpacked for as long as the command runs.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/problem.h"
#include "engine/pack/unpack.h"

namespace moltact {

class LessonArgument {
 public:
  /// A Problem where a pack cannot be read. Whether a lesson is there is not looked at.
  static Expected<LessonArgument> open(const std::filesystem::path& named);

  /// The lesson's file; of a pack the one that is shown first.
  const std::filesystem::path& file() const { return file_; }
  /// Null where it is no pack.
  const TemporaryPack* pack() const { return pack_ ? &*pack_ : nullptr; }

  /// A file's name, or a text that has one in it, as the person knows it: "haem.moltact/haem.md".
  std::string shown(std::string text) const { return pack_ ? pack_->shown(std::move(text)) : text; }
  Problem shown(Problem problem) const;

 private:
  std::filesystem::path file_;
  std::optional<TemporaryPack> pack_;
};

}  // namespace moltact
