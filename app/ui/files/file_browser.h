// A folder as dialogs list it: its folders, and the files that may be chosen. Window's thread.
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
  /// Which files are listed beside the folders (default: every kind of file_kinds.h).
  void accept(Accept files) { accept_ = std::move(files); }

  /// Looks into a folder; one that cannot be read leaves the last, and fault() says why.
  void look(const std::filesystem::path& where);

  const std::filesystem::path& folder() const { return folder_; }     ///< empty until one has been read
  const std::vector<FileEntry>& entries() const { return entries_; }  ///< folders first, then by name
  const std::string& fault() const { return fault_text_; }

  std::string typed;  ///< what is being written in the page's field
  bool open = false;  ///< the page was open in the last frame

 private:
  Accept accept_;
  std::filesystem::path folder_;
  std::vector<FileEntry> entries_;
  std::string fault_text_;
};

}  // namespace moltact
