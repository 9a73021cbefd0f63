// Numbers of a recording of the servo loop as bytes, in native byte order. A function template that visits the fields of
// a structure serves both directions, so that writing and reading cannot differ. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <string>
#include <type_traits>

#include "engine/core/file_bytes.h"

namespace moltact {

struct BytesPutter {
  std::string& to;
  template <class T>
  void operator()(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    to.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
};

/// Past the end, `ok` is false and values keep what they held.
struct BytesGetter {
  const char* at;
  const char* end;
  bool ok = true;
  template <class T>
  void operator()(T& value) {
    static_assert(std::is_arithmetic_v<T>);
    if (left() < sizeof value) {
      ok = false;
      at = end;
      return;
    }
    value = numberAt<T>(at);
    at += sizeof value;
  }
  std::size_t left() const { return static_cast<std::size_t>(end - at); }
};

template <class Each, class V>
void visitVector(Each& each, V& v) {
  each(v.x), each(v.y), each(v.z);
}

}  // namespace moltact
