// The only way to write a complete file: into a draft beside it, flushed to the disk and renamed to its final name. A
// reader finds either the old or the new content, never a part, even after a crash or with a full disk. Of two
// simultaneous writers, each has a draft and the later rename wins. A draft whose program was killed is removed at the
// next write in its folder. For files that grow while they are written, see append_file.h. Any one thread except the
// haptic one; the calls block on the disk.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// The behaviour if the file exists.
enum class IfThere {
  Replace,  ///< replace it; a Problem if the running command has read or written it (file_guard.h)
  Renew,    ///< replace it even if it has been read, because that is the purpose
  Refuse,   ///< return a Problem; the file stays unchanged
};

/// Writes the file; its folder must exist. Links are followed; a target that is not an ordinary file (a pipe, a device)
/// is written directly. Returns a Problem with a remedy on failure; then everything is unchanged.
std::optional<Problem> writeWhole(const std::filesystem::path& file, std::string_view bytes,
                                  IfThere there = IfThere::Replace);

/// Writes a file in pieces.
class Draft {
 public:
  /// Returns a Problem if a folder or a permission is missing; then nothing is changed.
  static Expected<Draft> begin(const std::filesystem::path& file, IfThere there = IfThere::Replace);

  Draft(Draft&&) noexcept;
  Draft& operator=(Draft&&) noexcept;
  /// Removes a draft that was not committed.
  ~Draft();

  std::optional<Problem> append(std::string_view bytes);
  /// The path of the draft; its name ends like the file's. It contains all appended bytes after flush().
  const std::filesystem::path& path() const;
  std::optional<Problem> flush();
  /// Flushes to the disk and renames the draft to the file. Call once.
  std::optional<Problem> commit();

  struct Impl;  ///< draft_impl.h, implemented per system

 private:
  Draft(std::unique_ptr<Impl> impl, std::filesystem::path file);
  std::unique_ptr<Impl> impl_;
  std::filesystem::path file_;  // as named by the caller
};

/// Makes exceeding the file size limit (`ulimit -f`) an error like a full disk, instead of ending the program.
void takeSizeLimitsAsErrors();

}  // namespace moltact
