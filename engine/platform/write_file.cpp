// The part of write_file.h common to all systems.
#include "engine/platform/write_file.h"

#include <utility>

#include "engine/platform/draft_impl.h"
#include "engine/platform/file_guard.h"

namespace moltact {

Draft::Draft(std::unique_ptr<Impl> impl, std::filesystem::path file) : impl_(std::move(impl)), file_(std::move(file)) {}
Draft::Draft(Draft&&) noexcept = default;
Draft& Draft::operator=(Draft&&) noexcept = default;
Draft::~Draft() = default;

Expected<Draft> Draft::begin(const std::filesystem::path& file, IfThere there) {
  if (there == IfThere::Replace)
    if (auto problem = overwriteProblem(file)) return *std::move(problem);
  Expected<std::unique_ptr<Impl>> impl = Impl::begin(file, there == IfThere::Refuse);
  if (!impl) return impl.problem();
  return Draft(*std::move(impl), file);
}

std::optional<Problem> Draft::append(std::string_view bytes) {
  constexpr std::size_t kMaxWaiting = std::size_t{1} << 20;
  if (bytes.size() >= kMaxWaiting) {
    if (auto problem = flush()) return problem;
    return impl_->write(bytes);  // avoids a copy
  }
  impl_->waiting += bytes;
  return impl_->waiting.size() < kMaxWaiting ? std::nullopt : flush();
}

const std::filesystem::path& Draft::path() const { return impl_->draft; }

std::optional<Problem> Draft::flush() {
  if (auto problem = impl_->write(impl_->waiting)) return problem;
  impl_->waiting.clear();
  return std::nullopt;
}

std::optional<Problem> Draft::commit() {
  if (auto problem = flush()) return problem;
  auto problem = impl_->place();
  if (!problem) noteWritten(file_);
  return problem;
}

std::optional<Problem> writeWhole(const std::filesystem::path& file, std::string_view bytes, IfThere there) {
  Expected<Draft> draft = Draft::begin(file, there);
  if (!draft) return draft.problem();
  if (auto problem = draft->append(bytes)) return problem;
  return draft->commit();
}

}  // namespace moltact
