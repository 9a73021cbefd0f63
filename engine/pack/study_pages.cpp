#include "engine/pack/study_pages.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_lesson.h"
#include "engine/pack/pack_page.h"
#include "engine/pack/study_draw.h"
#include "engine/pack/write_pack.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// A lesson or test in its place.
struct Placed {
  PlannedLesson lesson;
  std::string part;
  Condition condition = Condition::Touch;
};

bool isLessonText(const std::string& name, std::string_view text) {
  return name.ends_with(".md") && (text.starts_with("---") || text.starts_with("\xEF\xBB\xBF---"));
}

// Replaces keys of the front matter by `lines`, which follow its first line. Sets the number of lines that the text has
// gained before the rest.
std::string withFront(const std::string& text, const std::vector<std::string>& lines) {
  std::string out;
  std::size_t at = 0, number = 0;
  bool in_front = true;
  while (at < text.size()) {
    const std::size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
    const std::string_view line = std::string_view(text).substr(at, end - at);
    at = end;
    if (number++ == 0) {
      out += line;
      for (const std::string& l : lines) out += l + '\n';
      continue;
    }
    if (in_front && trimmed(line) == "---") in_front = false;
    const auto begins = [&](std::string_view key) { return line.starts_with(key); };
    // A replaced key leaves a comment, so that the lines keep their numbers.
    if (in_front && (begins("order:") || begins("ask:") || begins("condition:") || begins("study:")))
      out += "#\n";
    else
      out += line;
  }
  return out;
}

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

class StudyPacking {
 public:
  StudyPacking(const StudyPlan& plan, StudyPacks& into) : plan_(plan), into_(into) {}

  void pack(const std::string& name, const std::string& group, const std::vector<Placed>& parts) {
    std::map<std::string, std::string> files;
    std::string first;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::string lesson = add(files, parts[k], group, k + 1);
      if (k == 0) first = lesson;
    }
    if (!into_.errors.empty()) return;
    Expected<std::string> bytes = writePack(first, files);
    if (!bytes) return into_.errors.push_back(bytes.problem());
    if (const auto opened = PackFile::ofBytes(name + kPackEnding, *bytes); !opened)
      return into_.errors.push_back(opened.problem());
    StudyPack out{name, group, *std::move(bytes), {}};
    for (const auto& [file, content] : files) out.files.push_back(file);
    into_.packs.push_back(std::move(out));
  }

 private:
  const PackedLesson& packedOf(const fs::path& file) {
    const auto [known, is_new] = packed_.try_emplace(file);
    if (is_new) {
      known->second = packLesson(file);
      into_.errors.insert(into_.errors.end(), known->second.errors.begin(), known->second.errors.end());
      into_.warnings.insert(into_.warnings.end(), known->second.warnings.begin(), known->second.warnings.end());
    }
    return known->second;
  }

  // Adds a part with everything that it needs. Returns the name of its lesson in the pack.
  std::string add(std::map<std::string, std::string>& files, const Placed& part, const std::string& group,
                  std::size_t order) {
    const PackedLesson& packed = packedOf(part.lesson.file);
    if (!packed.pack) return {};
    const Expected<PackFile> pack = PackFile::ofBytes(part.lesson.file.string(), packed.pack->bytes);
    if (!pack) {
      into_.errors.push_back(pack.problem());
      return {};
    }
    const std::string id = lessonName(pack->lesson()).id;
    const auto newName = [&](const std::string& name) {
      if (name.find('/') != std::string::npos || lessonName(name).id != id || !name.ends_with(".md")) return name;
      std::string kind = part.part;
      std::replace(kind.begin(), kind.end(), ' ', '-');
      return std::to_string(order) + "-" + kind + "-" + name;
    };
    for (const PackEntry& entry : pack->entries()) {
      Expected<std::string> text = pack->read(entry);
      if (!text) {
        into_.errors.push_back(text.problem());
        return {};
      }
      const std::string name = newName(entry.name);
      std::string content = *std::move(text);
      if (isLessonText(name, content)) {
        for (const PackEntry& other : pack->entries()) {
          const std::string renamed = newName(other.name);
          if (renamed == other.name) continue;
          for (const char* opening : {"](", "](<"}) replaceAll(content, opening + other.name, opening + renamed);
        }
        content = placed(name, content, name != entry.name, part, group, order);
      }
      const auto [there, is_new] = files.emplace(name, content);
      if (!is_new && there->second != content)
        into_.errors.push_back({plan_.file, part.lesson.place.line, part.lesson.place.column,
                                trf("two lessons of the study need different files '{0}'", name),
                                tr("rename one of the files and the places that name it")});
    }
    return newName(pack->lesson());
  }

  // The text of a lesson with its place in the study. Problems of the condition are reported at the lesson's own lines.
  std::string placed(const std::string& name, const std::string& text, bool of_study, const Placed& part,
                     const std::string& group, std::size_t order) {
    std::vector<std::string> lines;
    if (of_study) {
      lines.push_back("order: " + std::to_string(order));
      lines.push_back("ask: " + plan_.ask);
      lines.push_back("study: " + plan_.study + ", " + part.part + (group.empty() ? "" : ", " + group));
    }
    if (part.condition != Condition::Touch) lines.push_back("condition: " + std::string(nameOf(part.condition)));
    std::string out = withFront(text, lines);
    for (Problem p : readLessonText(name, out).errors) {
      p.file = part.lesson.file.string();
      p.line -= std::min(p.line, lines.size());
      p.message = trf("{0} (in the condition '{1}')", p.message, nameOf(part.condition));
      into_.errors.push_back(std::move(p));
    }
    return out;
  }

  const StudyPlan& plan_;
  StudyPacks& into_;
  std::map<fs::path, PackedLesson> packed_;
};

}  // namespace

StudyPacks packStudy(const StudyPlan& plan) {
  StudyPacks out;
  StudyPacking packing(plan, out);
  for (const PlannedGroup& group : plan.groups) {
    std::vector<Placed> parts;
    if (plan.pre) parts.push_back({*plan.pre, "pre"});
    for (std::size_t k = 0; k < group.lessons.size(); ++k)
      parts.push_back({group.lessons[k], k == 0 ? "lesson" : "lesson " + std::to_string(k + 1), group.condition});
    if (plan.post) parts.push_back({*plan.post, "post"});
    packing.pack(plan.study + "-" + group.name, group.name, parts);
  }
  if (plan.delayed) packing.pack(plan.study + "-delayed", {}, {{*plan.delayed, "delayed"}});
  if (!out.errors.empty()) out.packs.clear();
  return out;
}

std::vector<DrawnStudent> drawStudents(const StudyPlan& plan) {
  const std::vector<std::string> codes = studyCodes(plan.students, plan.seed);
  const std::vector<std::size_t> groups = permutedBlocks(plan.students, plan.groups.size(), plan.block, plan.seed);
  std::vector<DrawnStudent> out;
  for (std::size_t k = 0; k < codes.size(); ++k) out.push_back({codes[k], groups[k]});
  return out;
}

std::string drawTable(const StudyPlan& plan, const std::vector<DrawnStudent>& students) {
  std::string out = "number,code,group,condition\r\n";
  for (std::size_t k = 0; k < students.size(); ++k) {
    const PlannedGroup& group = plan.groups[students[k].group];
    out += std::to_string(k + 1) + "," + students[k].code + "," + group.name + "," +
           std::string(nameOf(group.condition)) + "\r\n";
  }
  return out;
}

Expected<std::string> pageWithDraw(std::string page, const std::string& page_file, const StudyPlan& plan,
                                   const std::vector<StudyPack>& packs, const std::vector<DrawnStudent>& students) {
  nlohmann::json draw{{"study", plan.study}, {"codes", nlohmann::json::object()}};
  for (const DrawnStudent& s : students) draw["codes"][s.code] = plan.groups[s.group].name;
  std::vector<PageElement> elements;
  for (const StudyPack& pack : packs)
    if (!pack.group.empty()) elements.push_back(packElement("pack-bytes-" + pack.group, pack.name, pack.bytes));
  elements.push_back({"study-draw", "application/json", draw.dump(), {}});
  return pageWithElements(std::move(page), page_file, elements);
}

}  // namespace moltact
