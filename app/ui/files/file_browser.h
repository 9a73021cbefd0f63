// The entries of a folder for file dialogs: its subfolders and the files that may be chosen. Window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace moltact {

struct FileEntry {
  std::string name;
  bool folder = false;
};

class FileBrowser {
 public:
  using Accept = std::function<bool(const std::filesystem::path&)>;
  /// Sets which files are listed besides the folders (default: every kind in file_kinds.h).
  void accept(Accept files) { accept_ = std::move(files); }

  /// Lists a folder. If it cannot be read, the previous folder stays and fault() gives the reason.
  void look(const std::filesystem::path& where);

  const std::filesystem::path& folder() const { return folder_; }     ///< empty until a folder has been read
  const std::vector<FileEntry>& entries() const { return entries_; }  ///< folders first, then by name
  const std::string& fault() const { return fault_text_; }

  std::string typed;  ///< the contents of the page's text field
  bool open = false;  ///< whether the page was open in the last frame

 private:
  Accept accept_;
  std::filesystem::path folder_;
  std::vector<FileEntry> entries_;
  std::string fault_text_;
};

}  // namespace moltact
