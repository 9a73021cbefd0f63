// The draft of write_file.cpp, implemented per system. Included by engine/platform/write_file*.cpp.
#pragma once

#include <string>

#include "engine/platform/write_file.h"

namespace moltact {

struct Draft::Impl {
  std::filesystem::path draft;
  std::string waiting;  // appended bytes that are not written yet

  /// Returns a Problem if a folder or a permission is missing, or, with `refuse`, if the file exists.
  static Expected<std::unique_ptr<Impl>> begin(const std::filesystem::path& file, bool refuse);

  virtual ~Impl() = default;
  /// Appends to the draft.
  virtual std::optional<Problem> write(std::string_view bytes) = 0;
  /// Renames the complete draft to the file.
  virtual std::optional<Problem> place() = 0;
};

}  // namespace moltact
