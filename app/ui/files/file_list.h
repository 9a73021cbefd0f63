// Draws a folder's entries as clickable rows. Window's thread.
#pragma once

#include <filesystem>
#include <string>

#include "app/ui/files/file_browser.h"
#include "app/ui/widgets/controls.h"

namespace moltact {

enum class RowLabel {
  Cut,    ///< on one line, cut if it is too long
  Whole,  ///< wrapped onto as many lines as it needs
};

/// Draws a row with an icon and a label, recorded as `name`. Returns whether it was clicked.
bool fileRow(const std::string& name, Icon icon, const std::string& label, RowLabel shows = RowLabel::Cut);

/// Draws the browser's folder; a click on a subfolder opens it. Returns a file that was clicked, or an empty path. Rows
/// are recorded as prefix/up and prefix/entry/<name>. `nothing` is the text for an empty list.
std::filesystem::path drawFileList(FileBrowser& browser, const std::string& prefix, const char* nothing);

}  // namespace moltact
