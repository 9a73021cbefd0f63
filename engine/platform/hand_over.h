// File exchange with the user in the browser edition, where the program's folders are invisible. A written file is
// given as a download, and the browser opens files of the user. On other systems program and user share folders, and
// these functions do nothing. Window's thread.
#pragma once

#include <filesystem>

namespace moltact {

/// True if a written file reaches the user only through handOver().
bool filesAreHandedOver() noexcept;

/// Gives the user a file from the program's folders as a download.
void handOver(const std::filesystem::path& file);

/// Opens the browser's file dialog; the chosen file arrives as if it had been dropped on the window. Returns false if
/// the program must show its own dialog.
bool askForFile();

}  // namespace moltact
