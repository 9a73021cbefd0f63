// What a page keeps: its files lie in memory while it is open, and those under folderKept() are copied into the browser's
// own storage (IndexedDB) soon after each change, and from there into memory before the program begins. The copying is
// page.js's; where the browser refuses it, that is told here once. The page's one thread.
#pragma once

#include <filesystem>
#include <string>

#include "engine/core/problem.h"

namespace moltact::platform {

/// What an `errno` says of a file in the page's memory.
Problem storageProblem(const std::filesystem::path& file, int error);

/// Some file has changed: it is copied within half a second.
void storageChanged();

}  // namespace moltact::platform

namespace moltact {

/// Why the browser keeps nothing (a private window, no room left), once each time that begins; empty otherwise.
std::string takeStorageFault();

}  // namespace moltact
