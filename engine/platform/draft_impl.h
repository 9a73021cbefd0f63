// A draft as write_file.cpp holds it: what each system does with one. Included by engine/platform/write_file*.cpp.
#pragma once

#include <string>

#include "engine/platform/write_file.h"

namespace moltact {

struct Draft::Impl {
  std::filesystem::path draft;
  std::string waiting;  // bytes that were appended and not written yet

  /// A Problem where a folder or a permission is missing, or with `refuse` where the file is there.
  static Expected<std::unique_ptr<Impl>> begin(const std::filesystem::path& file, bool refuse);

  virtual ~Impl() = default;
  /// Writes behind what is there.
  virtual std::optional<Problem> write(std::string_view bytes) = 0;
  /// Puts the draft, with all bytes in it, in the file's place.
  virtual std::optional<Problem> place() = 0;
};

}  // namespace moltact
