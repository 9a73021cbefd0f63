#include "app/ui/files/file_kinds.h"

#include <string>

#include "engine/core/text.h"
#include "engine/molecule/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/trajectory/trajectory_file.h"

namespace moltact {
namespace {

struct EndingOfKind {
  const char* ending;
  FileKind kind;
};

// A new kind of file needs one line here and an extension that opens it (Extension::open).
constexpr EndingOfKind kEndings[] = {{".md", FileKind::Lesson},
                                     {kPackEnding, FileKind::Pack},
                                     {".jsonl", FileKind::Attempt},
                                     {kRecordingEnding, FileKind::Recording}};

}  // namespace

std::optional<FileKind> fileKind(const std::filesystem::path& file) {
  const std::string ending = lower(file.extension().string());
  for (const EndingOfKind& e : kEndings)
    if (ending == e.ending) return e.kind;
  if (hasTrajectoryName(file)) return FileKind::Trajectory;
  if (hasMoleculeName(file)) return FileKind::Molecule;
  return std::nullopt;
}

}  // namespace moltact
