// A folder's entries as rows that can be clicked. Window's thread.
#pragma once

#include <filesystem>
#include <string>

#include "app/ui/files/file_browser.h"
#include "app/ui/widgets/controls.h"

namespace moltact {

enum class RowLabel {
  Cut,    ///< on one line, cut where it is too long
  Whole,  ///< on as many lines as it needs
};

/// A row with a sign and a label; recorded as `name`. True when it was clicked.
bool fileRow(const std::string& name, Icon icon, const std::string& label, RowLabel shows = RowLabel::Cut);

/// The browser's folder; folders that are clicked are looked into. Returns a file that was clicked, else an empty path.
/// Rows are recorded as prefix/up and prefix/entry/<name>; `nothing` is said where there are none.
std::filesystem::path drawFileList(FileBrowser& browser, const std::string& prefix, const char* nothing);

}  // namespace moltact
