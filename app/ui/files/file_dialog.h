// Asks the person for a file to be written or for a folder, and hands the answer to whoever asked (panels/file_page.cpp
// draws it). Window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/ui/files/file_browser.h"

namespace moltact {

struct FileQuestion {
  std::string title;        ///< "Save the view as a picture"
  std::string name = {};    ///< what is offered; empty: a folder is asked for
  std::string ending = {};  ///< ".png": put behind a name that has none
  std::function<void(const std::filesystem::path&)> chosen;
};

class FileDialog {
 public:
  /// Opens the dialog in a folder, in place of one that is open. In a page, where files are handed over
  /// (engine/platform/hand_over.h), a file that is to be written is chosen at once, and no dialog opens.
  void ask(FileQuestion question, const std::filesystem::path& folder);
  bool open() const { return question_.has_value(); }
  void close() { question_.reset(); }

  const FileQuestion& question() const { return *question_; }  ///< only while open()
  bool asksForFolder() const { return open() && question_->name.empty(); }
  /// The file that would be chosen now: the name, with its ending, in the folder; empty where no name is written.
  std::filesystem::path answer() const;
  /// Hands the answer over and closes.
  void choose();

  FileBrowser browser;
  std::string written;  ///< the name in the dialog's field

 private:
  std::optional<FileQuestion> question_;
};

}  // namespace moltact
