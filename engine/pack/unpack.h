// Unpacks packs of lessons to disk: permanently for the window, temporarily for a command. Any thread except the
// haptic one.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "engine/core/problem.h"
#include "engine/pack/pack_file.h"
#include "engine/platform/removed_at_signal.h"
#include "engine/platform/temporary_folder.h"

namespace moltact {

/// userDataFolder()/packs, where the window unpacks packs. Empty if there is no home folder.
std::filesystem::path packsFolder();

/// Unpacks into packs/NAME-HASH, with the lesson's name and the pack's hash, replacing an existing folder. After a
/// Problem the folder is unchanged. Creates `packs` if it is missing. Returns the lesson's file.
Expected<std::filesystem::path> unpack(const PackFile& pack, const std::filesystem::path& packs);

/// The lesson of a pack in the given language, if the pack contains it; else `lesson_file`.
std::filesystem::path packedLesson(const std::filesystem::path& lesson_file, std::string_view language);

/// A pack in a temporary folder, removed by the destructor and when a signal ends the program. The folder of a killed
/// program is removed when the next pack is opened. For commands; one at a time.
class TemporaryPack {
 public:
  static Expected<TemporaryPack> open(const std::filesystem::path& pack_file);

  const PackFile& pack() const { return pack_; }
  std::filesystem::path folder() const { return folder_.path(); }
  std::filesystem::path lesson() const { return folder_.path() / pack_.lesson(); }
  /// Returns the text with each path of the temporary folder replaced by one of the pack: "haem.moltact/haem.md".
  std::string shown(std::string text) const;

 private:
  TemporaryPack(PackFile pack, TemporaryFolder folder, std::unique_ptr<RemovedAtSignal> at_signal)
      : pack_(std::move(pack)), folder_(std::move(folder)), at_signal_(std::move(at_signal)) {}
  PackFile pack_;
  TemporaryFolder folder_;
  std::unique_ptr<RemovedAtSignal> at_signal_;
};

}  // namespace moltact
