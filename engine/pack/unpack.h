// A pack as files on the disk, for as long as a lesson is on the shelf or a command looks at it. Any thread but the
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

/// userDataFolder()/packs: where the window unpacks what it opens. Empty where this computer tells no home.
std::filesystem::path packsFolder();

/// Unpacks into packs/NAME-HASH, NAME being the lesson's and HASH the pack's, in the place of what is there: the folder
/// is there whole or, with a Problem, as it was before. `packs` is made where it is missing. Gives the lesson's file.
Expected<std::filesystem::path> unpack(const PackFile& pack, const std::filesystem::path& packs);

/// The lesson of a pack in the language, where the pack has it in several.
std::filesystem::path packedLesson(const std::filesystem::path& lesson_file, std::string_view language);

/// A pack in a folder of the temporary ones, which goes with this; also where a signal ends the program. What a program
/// left that was killed is removed when the next pack is opened. For commands; one at a time.
class PackForNow {
 public:
  static Expected<PackForNow> open(const std::filesystem::path& pack_file);

  const PackFile& pack() const { return pack_; }
  std::filesystem::path folder() const { return folder_.path(); }
  std::filesystem::path lesson() const { return folder_.path() / pack_.lesson(); }
  /// A text that names files of the folder, naming those of the pack instead: "haem.moltact/haem.md".
  std::string shown(std::string text) const;

 private:
  PackForNow(PackFile pack, TemporaryFolder folder, std::unique_ptr<RemovedAtSignal> at_signal)
      : pack_(std::move(pack)), folder_(std::move(folder)), at_signal_(std::move(at_signal)) {}
  PackFile pack_;
  TemporaryFolder folder_;
  std::unique_ptr<RemovedAtSignal> at_signal_;
};

}  // namespace moltact
