#include "app/ui/files/file_browser.h"

#include <algorithm>
#include <system_error>

#include "app/ui/files/file_kinds.h"
#include "engine/language/catalogue.h"

namespace moltact {

namespace fs = std::filesystem;

void FileBrowser::look(const fs::path& where) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(where, error);
  fs::directory_iterator it(whole, fs::directory_options::skip_permission_denied, error);
  if (error) {
    fault_text_ = trf("The folder {0} cannot be read: {1}.", where.string(), error.message());
    return;
  }
  fault_text_.clear();
  folder_ = whole;
  entries_.clear();
  for (; it != fs::directory_iterator(); it.increment(error)) {
    if (error) break;
    std::error_code ignored;
    const std::string name = it->path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = it->is_directory(ignored);
    const bool wanted = accept_ ? accept_(it->path()) : fileKind(it->path()).has_value();
    if (is_folder || wanted) entries_.push_back({name, is_folder});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const FileEntry& a, const FileEntry& b) { return a.folder != b.folder ? a.folder : a.name < b.name; });
}

}  // namespace moltact
