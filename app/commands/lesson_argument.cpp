#include "app/commands/lesson_argument.h"

#include <utility>

namespace moltact {

Expected<LessonArgument> LessonArgument::open(const std::filesystem::path& named) {
  LessonArgument out;
  out.file_ = named;
  if (!hasPackName(named)) return out;
  Expected<TemporaryPack> pack = TemporaryPack::open(named);
  if (!pack) return pack.problem();
  out.file_ = pack->lesson();
  out.pack_.emplace(*std::move(pack));
  return out;
}

Problem LessonArgument::shown(Problem problem) const {
  problem.file = shown(std::move(problem.file));
  problem.message = shown(std::move(problem.message));
  problem.remedy = shown(std::move(problem.remedy));
  return problem;
}

}  // namespace moltact
