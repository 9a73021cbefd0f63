#include "engine/lesson/lesson_files.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <map>
#include <system_error>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/language/language_code.h"
#include "engine/lesson/reader.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

/// Decodes "%20" and other escapes.
std::string decoded(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned code = 0;
    if (text[i] == '%' && i + 2 < text.size() &&
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16).ptr == text.data() + i + 3) {
      out += static_cast<char>(code);
      i += 2;
    } else {
      out += text[i];
    }
  }
  return out;
}

}  // namespace

std::string_view linkScheme(std::string_view link) {
  const std::size_t colon = link.find(':');
  // A single letter is a drive of a path.
  if (colon == std::string_view::npos || colon < 2) return {};
  const std::string_view scheme = link.substr(0, colon);
  const auto allowed = [](unsigned char c) { return std::isalnum(c) || c == '+' || c == '-' || c == '.'; };
  return std::all_of(scheme.begin(), scheme.end(), allowed) ? scheme : std::string_view();
}

std::optional<FileLink> fileLink(const fs::path& lesson_file, std::string_view link) {
  if (link.empty() || link.starts_with('#') || !linkScheme(link).empty()) return {};
  const std::size_t hash = link.find('#');
  FileLink out{lesson_file.parent_path() / decoded(link.substr(0, hash)), {}};
  if (hash != std::string_view::npos) out.step = link.substr(hash + 1);
  return out;
}

Expected<std::string> readLessonFile(const fs::path& file) {
  return readBesideLesson(file, kLargestLesson, tr("name a lesson, a file that ends in .md"));
}

Expected<std::string> readBesideLesson(const fs::path& file, std::size_t max_bytes, const std::string& what_it_is) {
  const auto fail = [&](std::string message, std::string remedy) {
    return Problem{file.string(), 0, 0, std::move(message), std::move(remedy)};
  };
  std::error_code error;
  const auto status = fs::status(file, error);
  if (status.type() == fs::file_type::not_found)
    return fail(tr("there is no such file"), tr("check its name and folder"));
  if (!fs::is_regular_file(status)) return fail(tr("this is not a file"), what_it_is);
  std::ifstream in(file, std::ios::binary);
  if (!in) return fail(trf("the file cannot be opened: {0}", std::strerror(errno)), tr("check that you may read it"));
  // One byte more than allowed suffices to detect that the file is too large.
  const std::uintmax_t size = fs::file_size(file, error);
  std::string bytes(error ? max_bytes + 1 : std::size_t(std::min<std::uintmax_t>(size, max_bytes)) + 1, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (in.bad()) return fail(tr("the file cannot be read to its end"), tr("copy it again"));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

bool looksLikeLesson(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string line;
  bool front = false;
  for (bool first = true; std::getline(in, line); first = false) {
    const std::string_view text = trimmed(line);
    if (first) front = text == "---" || text == "\xEF\xBB\xBF---";
    // The plan of a study has groups, and no lesson has.
    if (front && !first) {
      if (text.starts_with("groups:")) return false;
      if (text == "---") return true;
    }
    for (const char* fence : {"```scene", "```touch", "```answer"})
      if (text == fence) return true;
  }
  return front;
}

LessonName lessonName(const fs::path& file) {
  const fs::path stem = file.stem();
  const std::string ending = stem.extension().string();
  if (ending.empty() || !isLanguageCode(std::string_view(ending).substr(1))) return {stem.string(), {}};
  return {stem.stem().string(), ending.substr(1)};
}

std::vector<fs::path> inLanguage(std::vector<fs::path> lessons, std::string_view language) {
  const auto rank = [&](const LessonName& name) {
    return name.language == language ? 0 : name.language.empty() ? 1 : 2;
  };
  std::map<fs::path, int> best;  // of each lesson, by folder and id
  for (const fs::path& file : lessons) {
    const LessonName name = lessonName(file);
    const auto [at, is_new] = best.try_emplace(file.parent_path() / name.id, rank(name));
    if (!is_new) at->second = std::min(at->second, rank(name));
  }
  std::erase_if(lessons, [&](const fs::path& file) {
    const LessonName name = lessonName(file);
    int& wanted = best[file.parent_path() / name.id];
    if (wanted != rank(name)) return true;
    wanted = -1;  // of several equally good ones, the first
    return false;
  });
  return lessons;
}

LessonFolder lessonsIn(const fs::path& folder) {
  LessonFolder out;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    const fs::path& path = it->path();
    std::error_code unknown;
    if (path.filename().string().starts_with('.')) {
      it.disable_recursion_pending();
    } else if (lower(path.extension().string()) == ".md" && it->is_regular_file(unknown)) {
      (looksLikeLesson(path) ? out.lessons : out.others).push_back(path);
    }
  }
  std::sort(out.lessons.begin(), out.lessons.end());
  std::sort(out.others.begin(), out.others.end());
  if (error)
    out.fault = Problem{folder.string(), 0, 0, trf("the folder cannot be read: {0}", error.message()),
                        tr("check that you may read it")};
  else if (out.lessons.empty())
    out.fault = Problem{folder.string(), 0, 0, tr("there is no lesson in this folder"),
                        tr("name a folder with lessons, files that end in .md")};
  return out;
}

}  // namespace moltact
