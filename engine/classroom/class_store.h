// The class's folder: a journal with every record of ClassRoom, and the attempts that are made from it. A line counts as
// kept once the journal is on the disk. Many threads may wait at once; one of them writes for all.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/platform/append_file.h"

namespace moltact {

/// The first record of a journal: what makes the class's addresses.
struct ClassIdentity {
  std::string code, teacher;  ///< the class's code; the teacher's token
  std::uint64_t seed = 0;     ///< of the animals
  int port = 0;
  std::string began;                      ///< UTC
  std::vector<std::string> lessons = {};  ///< as LiveClassOptions::lessons, files with absolute paths
  bool share = false;
};

class ClassStore {
 public:
  /// Whether a class was begun in this folder.
  static bool begun(const std::filesystem::path& folder);
  /// Whether somebody joined the class of this folder and nobody has ended it. Reads the journal.
  static bool open(const std::filesystem::path& folder);
  /// Goes on with the class in this folder. An incomplete last record, which was never acknowledged, is cut off.
  static Expected<std::unique_ptr<ClassStore>> goOn(const std::filesystem::path& folder);
  /// Begins a class in a folder, which is made for its owner alone if it is new.
  static Expected<std::unique_ptr<ClassStore>> begin(const std::filesystem::path& folder,
                                                     const ClassIdentity& identity);

  /// Passes each record after the first to `record`, in order, without its line end.
  void forEachRecord(const std::function<void(std::string_view)>& record) const;

  const ClassIdentity& identity() const { return identity_; }
  const std::filesystem::path& folder() const { return folder_; }
  std::filesystem::path attemptsFolder() const { return folder_ / "attempts"; }

  /// Adds records to those that wait for the disk; returns a ticket. Does not block on the disk.
  std::uint64_t add(std::string_view records);
  /// The ticket of everything that was added.
  std::uint64_t newest() const;
  /// Blocks until the records of a ticket are on the disk. A Problem if they are not; they wait, and the next call tries
  /// again.
  std::optional<Problem> commit(std::uint64_t ticket);

  /// Writes the attempts of all students into attemptsFolder(), as far as the journal has them. Blocks.
  std::optional<Problem> writeAttempts();

 private:
  explicit ClassStore(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  ClassIdentity identity_;
  std::optional<AppendFile> journal_;
  mutable std::mutex lock_;
  std::condition_variable written_;
  std::string waiting_;
  std::uint64_t added_ = 0, kept_ = 0;
  bool writing_ = false;
  std::mutex attempts_lock_;
};

}  // namespace moltact
