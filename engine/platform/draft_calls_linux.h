// The system calls that write_file and append_file share: what a failed one means to a person, and drafts beside a
// file. Linux only; included by engine/platform/*_linux.cpp.
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

/// What an `errno` says of a file that was to be written.
Problem writingProblem(const std::filesystem::path& file, int error);

/// Where writing to `file` ends: links are followed, also to a file that is not there yet.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// A new empty file in the folder of `file`, locked as long as it is open, and its name; -1 with `errno` where there
/// can be none. It gets the rights of `file` where that is there. Drafts in that folder whose program has ended go.
int openDraft(const std::filesystem::path& file, int flags, std::filesystem::path& draft);

/// Renames the draft; with `refuse`, EEXIST where the file is there. 0, or -1 with `errno`.
int placeDraft(const std::filesystem::path& draft, const std::filesystem::path& file, bool refuse);

/// Waits until the disk has a handle's bytes; what cannot be waited for (a pipe) counts as there. 0, or -1 with
/// `errno`.
int syncData(int handle);
/// The same for a file's name in its folder.
void syncName(const std::filesystem::path& file);

}  // namespace moltact::platform
