#include "app/ui/files/file_dialog.h"

#include <system_error>
#include <utility>

#include "app/ui/files/user_folders.h"
#include "engine/platform/hand_over.h"

namespace moltact {

namespace fs = std::filesystem;

void FileDialog::ask(FileQuestion question, const fs::path& folder) {
  std::error_code ignored;
  if (filesAreHandedOver() && !question.name.empty()) return question.chosen(folder / question.name);
  browser.accept([ending = question.ending, other = question.other_ending](const fs::path& file) {
    return file.has_extension() && (file.extension() == ending || file.extension() == other);
  });
  browser.look(fs::is_directory(folder, ignored) ? folder : fs::current_path(ignored));
  written = question.name;
  question_ = std::move(question);
}

fs::path FileDialog::answer() const {
  if (asksForFolder()) return browser.folder();
  fs::path name = typedPath(written);
  if (written.empty() || !name.has_filename()) return {};
  if (!name.has_extension()) name += question_->ending;
  return name.is_relative() ? browser.folder() / name : name;
}

void FileDialog::choose() {
  const fs::path file = answer();
  const FileQuestion asked = std::move(*question_);
  close();
  asked.chosen(file);
}

}  // namespace moltact
