// A draft as write_file.cpp holds it: what each system does with one. Included by engine/platform/write_file*.cpp.
#pragma once

#include <string>

#include "engine/platform/write_file.h"

namespace moltact {

struct Draft::Impl {
  std::filesystem::path draft;
  std::string waiting;  // bytes that were appended and not written yet

  virtual ~Impl() = default;
  /// Writes behind what is there.
  virtual std::optional<Problem> write(std::string_view bytes) = 0;
  /// Puts the draft, with all bytes in it, in the file's place.
  virtual std::optional<Problem> place() = 0;
};

}  // namespace moltact
