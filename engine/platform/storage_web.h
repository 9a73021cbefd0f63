// Persistent storage of the browser edition. The page's files are in memory. Changes under folderKept() are copied to
// the browser's storage (IndexedDB) shortly after each change, and from there into memory before the program starts.
// page.js performs the copying; a refusal by the browser is reported here once. The page's only thread.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/problem.h"

namespace moltact::platform {

/// The Problem for an `errno` of a file in the page's memory.
Problem storageProblem(const std::filesystem::path& file, int error);

/// Reports a changed file; it is copied within half a second.
void storageChanged();

}  // namespace moltact::platform

namespace moltact {

/// The reason why the browser stores nothing (a private window, no space), once per occurrence; empty otherwise.
std::string takeStorageFault();

}  // namespace moltact
