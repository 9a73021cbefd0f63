// The system calls that write_file and append_file share: the meaning of errors, and drafts beside a file. Linux only;
// included by engine/platform/*_linux.cpp.
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

/// Creates a new empty file in the folder of `file`, locked as long as it is open, and returns its handle and name; -1
/// with `errno` on failure. It gets the permissions of `file` where that exists. Removes drafts in that folder whose
/// program has ended.
int openDraft(const std::filesystem::path& file, int flags, std::filesystem::path& draft);

/// Renames the draft; with `refuse`, EEXIST where the file is there. 0, or -1 with `errno`.
int placeDraft(const std::filesystem::path& draft, const std::filesystem::path& file, bool refuse);

/// Waits until the disk has a handle's bytes; what cannot be waited for (a pipe) counts as there. 0, or -1 with
/// `errno`.
int syncData(int handle);
/// The same for a file's name in its folder.
void syncName(const std::filesystem::path& file);

}  // namespace moltact::platform
