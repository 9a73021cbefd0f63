#include "engine/classroom/class_store.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <utility>

#include "engine/classroom/class_room.h"
#include "engine/language/catalogue.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;
constexpr const char* kJournal = "class.jsonl";
constexpr std::size_t kLongestRecord = kMaxClassLine + 1000;
constexpr std::size_t kOpenAttempts = 200;  // files open at once

std::string identityRecord(const ClassIdentity& of) {
  return nlohmann::ordered_json{{"kind", "class"},       {"format", 1},       {"code", of.code},
                                {"teacher", of.teacher}, {"seed", of.seed},   {"port", of.port},
                                {"began", of.began},     {"share", of.share}, {"lessons", of.lessons}}
             .dump() +
         '\n';
}

std::optional<ClassIdentity> identityOf(const std::string& line) {
  const nlohmann::json j = nlohmann::json::parse(line, nullptr, false);
  if (!j.is_object() || j.value("kind", nlohmann::json()) != "class") return std::nullopt;
  ClassIdentity out;
  for (const char* key : {"code", "teacher", "began"})
    if (!j.contains(key) || !j[key].is_string()) return std::nullopt;
  if (!j.contains("port") || !j["port"].is_number_unsigned() || !j.contains("seed") || !j["seed"].is_number_unsigned())
    return std::nullopt;
  out.code = j["code"];
  out.teacher = j["teacher"];
  out.began = j["began"];
  out.seed = j["seed"];
  out.port = j["port"].get<int>();
  if (j.contains("share") && j["share"].is_boolean()) out.share = j["share"];
  if (j.contains("lessons") && j["lessons"].is_array())
    for (const nlohmann::json& lesson : j["lessons"])
      if (lesson.is_string()) out.lessons.push_back(lesson);
  if (out.code.empty() || out.teacher.empty() || out.port < 0 || out.port > 65535) return std::nullopt;
  return out;
}

// Calls `line` for each complete line of a file; returns their bytes with line ends.
std::uintmax_t forEachLine(const fs::path& file, const std::function<void(const std::string&)>& line) {
  std::ifstream in(file, std::ios::binary);
  std::uintmax_t complete = 0;
  for (std::string one; std::getline(in, one);) {
    if (in.eof()) break;  // without a line end
    complete += one.size() + 1;
    if (one.size() <= kLongestRecord) line(one);
  }
  return complete;
}

std::string attemptFileName(std::size_t student, std::size_t attempt) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "student-%03zu-%zu.jsonl", student + 1, attempt + 1);
  return text.data();
}

// The journal has the teacher's token and the answers; also in a folder that was there before and that others may read.
void keepPrivate(const fs::path& folder, const fs::path& attempts) {
  std::error_code error;
  fs::permissions(folder / kJournal, fs::perms::owner_read | fs::perms::owner_write, error);
  fs::permissions(attempts, fs::perms::owner_all, error);
}

Problem folderProblem(const fs::path& folder, const std::error_code& error) {
  return {folder.string(), 0, 0, trf("the folder cannot be made ({0})", error.message()),
          tr("allow writing there, or free some space")};
}

}  // namespace

bool ClassStore::begun(const fs::path& folder) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(folder / kJournal, error);
  return !error && bytes > 0;
}

bool ClassStore::open(const fs::path& folder) {
  bool joined = false, ended = false;
  forEachLine(folder / kJournal, [&](const std::string& line) {
    joined = joined || line.starts_with(R"({"kind":"joined")");
    ended = ended || line.starts_with(R"({"kind":"ended")");
  });
  return joined && !ended;
}

Expected<std::unique_ptr<ClassStore>> ClassStore::begin(const fs::path& folder, const ClassIdentity& identity) {
  std::unique_ptr<ClassStore> out(new ClassStore(folder));
  std::error_code error;
  const bool there = fs::is_directory(folder, error);
  fs::create_directories(out->attemptsFolder(), error);
  if (error) return folderProblem(folder, error);
  if (!there) fs::permissions(folder, fs::perms::owner_all, error);
  if (!begun(folder)) fs::remove(folder / kJournal, error);
  Expected<AppendFile> journal = AppendFile::open(folder / kJournal, AppendFile::Begin::New);
  if (!journal) return journal.problem();
  out->journal_.emplace(*std::move(journal));
  keepPrivate(folder, out->attemptsFolder());
  out->identity_ = identity;
  if (auto problem = out->journal_->append(identityRecord(identity))) return *problem;
  if (auto problem = out->journal_->sync()) return *problem;
  return out;
}

Expected<std::unique_ptr<ClassStore>> ClassStore::goOn(const fs::path& folder) {
  std::unique_ptr<ClassStore> out(new ClassStore(folder));
  const fs::path file = folder / kJournal;
  std::error_code error;
  fs::create_directories(out->attemptsFolder(), error);
  if (error) return folderProblem(folder, error);
  Expected<AppendFile> journal = AppendFile::open(file, AppendFile::Begin::Continue);
  if (!journal) return journal.problem();
  out->journal_.emplace(*std::move(journal));
  keepPrivate(folder, out->attemptsFolder());
  std::optional<ClassIdentity> identity;
  bool first = true;
  const std::uintmax_t complete = forEachLine(file, [&](const std::string& line) {
    if (std::exchange(first, false)) identity = identityOf(line);
  });
  if (!identity)
    return Problem{file.string(), 0, 0, tr("it is no journal of a class"), tr("name another folder for the class")};
  out->identity_ = *identity;
  if (complete < fs::file_size(file, error))
    if (auto problem = out->journal_->cut(complete)) return *problem;
  return out;
}

void ClassStore::forEachRecord(const std::function<void(std::string_view)>& record) const {
  bool first = true;
  forEachLine(folder_ / kJournal, [&](const std::string& line) {
    if (!std::exchange(first, false)) record(line);
  });
}

std::uint64_t ClassStore::add(std::string_view records) {
  const std::lock_guard held(lock_);
  if (!records.empty()) {
    waiting_ += records;
    ++added_;
  }
  return added_;
}

std::uint64_t ClassStore::newest() const {
  const std::lock_guard held(lock_);
  return added_;
}

std::optional<Problem> ClassStore::commit(std::uint64_t ticket) {
  std::unique_lock held(lock_);
  for (;;) {
    if (kept_ >= ticket) return std::nullopt;
    if (!writing_) break;
    written_.wait(held);
  }
  // Writes for all who wait, and for those who come meanwhile the next one does.
  writing_ = true;
  const std::uint64_t upto = added_;
  std::string records = std::exchange(waiting_, {});
  held.unlock();
  std::optional<Problem> problem = journal_->append(records);
  if (!problem) {
    records.clear();  // they are in the file, whether or not they can be synced
    problem = journal_->sync();
  }
  held.lock();
  if (problem)
    waiting_.insert(0, records);
  else
    kept_ = upto;
  writing_ = false;
  written_.notify_all();
  return problem;
}

std::optional<Problem> ClassStore::writeAttempts() {
  const std::lock_guard alone(attempts_lock_);
  // An open draft for each attempt; a class with more attempts than may be open reads the journal several times.
  using Of = std::pair<std::size_t, std::size_t>;
  std::set<Of> all;
  forEachLine(folder_ / kJournal, [&](const std::string& record) {
    if (const auto line = lineRecord(record)) all.insert({line->student, line->attempt});
  });
  std::optional<Problem> problem;
  for (auto from = all.begin(); from != all.end();) {
    std::map<Of, Draft> drafts;
    for (; from != all.end() && drafts.size() < kOpenAttempts; ++from) {
      Expected<Draft> begun =
          Draft::begin(attemptsFolder() / attemptFileName(from->first, from->second), IfThere::Renew);
      if (!begun) return begun.problem();
      drafts.emplace(*from, *std::move(begun));
    }
    forEachLine(folder_ / kJournal, [&](const std::string& record) {
      const auto line = lineRecord(record);
      if (!line || problem) return;
      if (const auto draft = drafts.find({line->student, line->attempt}); draft != drafts.end())
        problem = draft->second.append(std::string(line->line) + '\n');
    });
    if (problem) return problem;
    for (auto& [of, draft] : drafts)
      if ((problem = draft.commit())) return problem;
  }
  return std::nullopt;
}

}  // namespace moltact
