// The only way to write a file whole: into a draft beside it, flushed to the disk, and put in its place by one rename.
// A reader of the file finds either the old or the new content, never a part, whatever ends the program or fills the
// disk. Two writers at the same time each have a draft, and the later one's remains. A draft whose program was killed
// is removed when anything is written in its folder again. For files that grow while they are written: append_file.h.
// Any one thread but the haptic one.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

enum class IfThere {
  Replace,  ///< a Problem where the command that runs has read or written it (file_guard.h)
  Renew,    ///< replaced although it has been read, for that is the purpose
  Refuse,   ///< a Problem; what is there stays
};

/// Writes the file; its folder must exist. A link is followed; a target that is no ordinary file (a pipe, a device) is
/// written directly. A Problem that a person can act on where that is impossible; then everything is as it was.
std::optional<Problem> writeWhole(const std::filesystem::path& file, std::string_view bytes,
                                  IfThere there = IfThere::Replace);

/// The same in pieces.
class Draft {
 public:
  /// A Problem where a folder or a permission is missing; then nothing is changed.
  static Expected<Draft> begin(const std::filesystem::path& file, IfThere there = IfThere::Replace);

  Draft(Draft&&) noexcept;
  Draft& operator=(Draft&&) noexcept;
  /// Removes a draft that was not committed.
  ~Draft();

  std::optional<Problem> append(std::string_view bytes);
  /// Where the draft is meanwhile; its name ends as the file's. All that was appended is in it after flush().
  const std::filesystem::path& path() const;
  std::optional<Problem> flush();
  /// Waits for the disk and puts the draft in the file's place. Once.
  std::optional<Problem> commit();

  struct Impl;  ///< draft_impl.h, for each system's part

 private:
  Draft(std::unique_ptr<Impl> impl, std::filesystem::path file);
  std::unique_ptr<Impl> impl_;
  std::filesystem::path file_;  // as it was named
};

/// From this call on a limit on the size of files (`ulimit -f`) is an error like a full disk, and does not end the
/// program.
void takeSizeLimitsAsErrors();

}  // namespace moltact
