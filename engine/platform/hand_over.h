// How files go between the program and the person where nobody sees the program's folders: in a page a file is given as a
// download, and one of the person's own is asked for by the browser. Elsewhere both have folders in common, and nothing
// here does anything. Window's thread.
#pragma once

#include <filesystem>

namespace moltact {

/// Whether a file that was written reaches the person only by handOver().
bool filesAreHandedOver() noexcept;

/// Gives the person a file that lies in the program's own folders.
void handOver(const std::filesystem::path& file);

/// Has the browser ask for a file, which then comes as if it had been dropped on the window. False where that is the
/// program's own work.
bool askForFile();

}  // namespace moltact
