// Conversion between numpy arrays and the engine's values. Invalid input raises ValueError, TypeError or IndexError. The
// caller holds Python's global lock. Units: angstrom.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/core/units.h"

namespace moltact::python {

/// Poses of shape (n, 3), positions, or (n, 7), positions and quaternions w, x, y, z, which are normalized.
std::vector<PoseA> posesOf(const pybind11::object& poses);

/// Spheres of shape (n, 4): centre and radius.
std::vector<Sphere> spheresOf(const pybind11::object& spheres);

/// Numbers of shape (n,).
std::vector<double> numbersIn(const pybind11::object& numbers, const char* name);

/// Indices into `count` atoms, in any order; negative ones count from the end, as in Python. Ascending, without
/// repetition.
std::vector<std::uint32_t> indicesOf(const pybind11::object& indices, std::size_t count, const std::string& name);

/// A new array of shape (rows, columns), or (rows) if `columns` is 0.
template <class T>
pybind11::array_t<T> newArray(std::size_t rows, std::size_t columns) {
  std::vector<pybind11::ssize_t> shape{pybind11::ssize_t(rows)};
  if (columns) shape.push_back(pybind11::ssize_t(columns));
  return pybind11::array_t<T>(shape);
}

}  // namespace moltact::python
