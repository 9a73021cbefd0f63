// System calls shared by write_file and append_file: error messages, and drafts beside a file. Linux only; included by
// engine/platform/*_linux.cpp.
#pragma once

#include <cerrno>
#include <filesystem>

#include "engine/core/problem.h"

namespace moltact::platform {

template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

/// The Problem for an `errno` of a failed write to that file.
Problem writingProblem(const std::filesystem::path& file, int error);

/// The target of `file`: links are followed, also to a file that does not exist yet.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// Creates an empty draft in the folder of `file`, locked while it is open. Returns its handle and writes its name to
/// `draft`; -1 with `errno` on failure. The draft gets the permissions of an existing `file`. Removes drafts in that
/// folder whose program has ended.
int openDraft(const std::filesystem::path& file, int flags, std::filesystem::path& draft);

/// Renames the draft to `file`. With `refuse` an existing file gives EEXIST. Returns 0, or -1 with `errno`.
int placeDraft(const std::filesystem::path& draft, const std::filesystem::path& file, bool refuse);

/// Blocks until the disk has the bytes of a handle; a handle that cannot be synchronised (a pipe) counts as done.
/// Returns 0, or -1 with `errno`.
int syncData(int handle);
/// The same for the file's directory entry.
void syncName(const std::filesystem::path& file);

}  // namespace moltact::platform
