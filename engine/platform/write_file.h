// The one way to write a file whole: into a draft of its own beside it, flushed to the disk, and put in its place by
// one rename. Whoever reads the file meets what it was or what it is to be, never less, whatever ends the program or
// fills the disk; two who write it at once each have a draft, and the later one's stands. A draft whose program was
// killed goes when anything is written in its folder again. Files that grow while they are written: append_file.h. Any
// one thread but the haptic one.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

enum class IfThere {
  Replace,
  Refuse,  ///< a Problem; what is there stays
};

/// Writes the file; its folder must be there. A link is followed, and what is no ordinary file (a pipe, a device) is
/// written to as it is. A Problem that a person can act on where that cannot be; then everything is as it was.
std::optional<Problem> writeWhole(const std::filesystem::path& file, std::string_view bytes,
                                  IfThere there = IfThere::Replace);

/// The same in pieces.
class Draft {
 public:
  /// Where the file could not be written for want of a folder or a right, this says so, and changes nothing.
  static Expected<Draft> begin(const std::filesystem::path& file, IfThere there = IfThere::Replace);

  Draft(Draft&&) noexcept;
  Draft& operator=(Draft&&) noexcept;
  /// A draft that was not committed goes.
  ~Draft();

  std::optional<Problem> append(std::string_view bytes);
  /// Where the draft is meanwhile; its name ends as the file's. All that was appended is in it after flush().
  const std::filesystem::path& path() const;
  std::optional<Problem> flush();
  /// Waits for the disk and puts the draft in the file's place. Once.
  std::optional<Problem> commit();

 private:
  struct Impl;
  explicit Draft(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// From here on a limit on the size of files (`ulimit -f`) is an error like a full disk, and not the end of the
/// program.
void takeSizeLimitsAsErrors();

}  // namespace moltact
