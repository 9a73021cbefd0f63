// System calls shared by write_file and append_file on Windows: exclusive writing, error messages, and drafts beside a
// file. Included by engine/platform/*_windows.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact::platform {

/// The Problem for a failed write to that file; `error` is GetLastError().
Problem writingProblem(const std::filesystem::path& file, unsigned long error);

enum class Make { Nothing, NewFile };
/// Opens a file for writing. Others may read, rename and remove it meanwhile but not write it, which locks it against
/// other instances. Returns null with GetLastError() on failure.
void* openToWrite(const std::filesystem::path& file, Make make);

/// Creates an empty draft in the folder of `file`, locked while it is open. Removes drafts there whose program has
/// ended. Returns null with GetLastError() on failure.
void* openDraft(const std::filesystem::path& file, std::filesystem::path& draft);

/// Renames the draft to the file after flushing it to the disk. With `refuse` an existing file gives
/// ERROR_ALREADY_EXISTS.
bool placeDraft(const std::filesystem::path& draft, const std::filesystem::path& file, bool refuse);

/// Appends the bytes. Returns false with GetLastError() if not all of them could be written.
bool writeAtEnd(void* handle, std::string_view bytes);
/// Truncates the file.
bool cutTo(void* handle, std::size_t bytes);

}  // namespace moltact::platform
