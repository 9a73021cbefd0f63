// Asks the user for an output file or for a folder and passes the answer to the caller. panels/file_page.cpp draws the
// dialog. Window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/ui/files/file_browser.h"

namespace moltact {

struct FileQuestion {
  std::string title;        ///< "Save the view as a picture"
  std::string name = {};    ///< the suggested name; empty: ask for a folder
  std::string ending = {};  ///< ".png": appended to a name without it
  std::function<void(const std::filesystem::path&)> chosen;
  std::string other_ending = {};  ///< of files that are also listed
  std::string note = {};          ///< a sentence below the name
};

class FileDialog {
 public:
  /// Opens the dialog in `folder` and replaces a dialog that is open. In a browser, files are downloaded
  /// (engine/platform/hand_over.h): the suggested file is chosen at once and no dialog opens.
  void ask(FileQuestion question, const std::filesystem::path& folder);
  bool open() const { return question_.has_value(); }
  void close() { question_.reset(); }

  const FileQuestion& question() const { return *question_; }  ///< requires open()
  bool asksForFolder() const { return open() && question_->name.empty(); }
  /// The file that choose() would choose now: the typed name with its extension, in the folder; empty if no name is
  /// typed.
  std::filesystem::path answer() const;
  /// Passes answer() to the caller and closes the dialog.
  void choose();

  FileBrowser browser;
  std::string written;  ///< the name in the dialog's text field

 private:
  std::optional<FileQuestion> question_;
};

}  // namespace moltact
