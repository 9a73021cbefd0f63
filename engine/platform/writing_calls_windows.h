// The system calls that write_file and append_file share on Windows: files that one program writes at a time, the
// meaning of errors, drafts beside a file. Included by engine/platform/*_windows.cpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact::platform {

/// The Problem for a failed write to that file; `error` is GetLastError().
Problem writingProblem(const std::filesystem::path& file, unsigned long error);

enum class Make { Nothing, NewFile };
/// Opens a file for writing; others may read, rename and remove it meanwhile but not write it, so that it is locked
/// against other programs of this kind. Null with GetLastError() on failure.
void* openToWrite(const std::filesystem::path& file, Make make);

/// Creates a new empty file in the folder of `file`, locked as long as it is open. Removes drafts there whose program has
/// ended. Null with GetLastError() on failure.
void* openDraft(const std::filesystem::path& file, std::filesystem::path& draft);

/// Puts the draft in the file's place, when the disk has it; with `refuse`, ERROR_ALREADY_EXISTS where the file is there.
bool placeDraft(const std::filesystem::path& draft, const std::filesystem::path& file, bool refuse);

/// Behind the last byte; false with GetLastError() where not all of it could be written.
bool writeAtEnd(void* handle, std::string_view bytes);
/// Truncates the file.
bool cutTo(void* handle, std::size_t bytes);

}  // namespace moltact::platform
