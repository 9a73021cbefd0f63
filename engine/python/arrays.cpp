#include "engine/python/arrays.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/contact.h"

namespace py = pybind11;

namespace moltact::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::string shapeText(const Numbers& numbers) {
  std::string out = "(";
  for (py::ssize_t k = 0; k < numbers.ndim(); ++k) out += (k ? ", " : "") + std::to_string(numbers.shape(k));
  return out + (numbers.ndim() == 1 ? ",)" : ")");
}

Numbers numbersOf(const py::object& object, const char* name) {
  Numbers numbers = Numbers::ensure(object);
  if (!numbers) {
    PyErr_Clear();
    throw py::type_error(std::string(name) + " must be an array of numbers");
  }
  return numbers;
}

[[noreturn]] void refuseRow(const char* name, py::ssize_t row, const char* why) {
  throw py::value_error(std::string(name) + "[" + std::to_string(row) + "] " + why);
}

}  // namespace

std::vector<PoseA> posesOf(const py::object& poses) {
  const Numbers numbers = numbersOf(poses, "poses");
  if (numbers.ndim() != 2 || (numbers.shape(1) != 3 && numbers.shape(1) != 7))
    throw py::value_error("poses must have the shape (n, 3) or (n, 7), not " + shapeText(numbers));
  const bool oriented = numbers.shape(1) == 7;
  const auto at = numbers.unchecked<2>();
  std::vector<PoseA> out(std::size_t(numbers.shape(0)));
  for (py::ssize_t row = 0; row < numbers.shape(0); ++row) {
    PoseA& pose = out[std::size_t(row)];
    pose.place.A = {at(row, 0), at(row, 1), at(row, 2)};
    if (!finite(pose.place.A)) refuseRow("poses", row, "is not finite");
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(pose.place.A[axis]) > kMaxPosition_A) refuseRow("poses", row, "is farther than 1e9 A");
    if (!oriented) continue;
    const Quat turned(at(row, 3), at(row, 4), at(row, 5), at(row, 6));
    const double length = glm::length(turned);
    if (!std::isfinite(length)) refuseRow("poses", row, "is not finite");
    if (length < 1e-6) refuseRow("poses", row, "has a quaternion of length zero");
    pose.orientation = turned / length;
  }
  return out;
}

std::vector<Sphere> spheresOf(const py::object& spheres) {
  const Numbers numbers = numbersOf(spheres, "spheres");
  if (numbers.ndim() != 2 || numbers.shape(1) != 4)
    throw py::value_error("spheres must have the shape (n, 4), centre and radius, not " + shapeText(numbers));
  const auto at = numbers.unchecked<2>();
  std::vector<Sphere> out(std::size_t(numbers.shape(0)));
  for (py::ssize_t row = 0; row < numbers.shape(0); ++row) {
    for (py::ssize_t column = 0; column < 4; ++column)
      if (!(std::abs(at(row, column)) <= kMaxPosition_A)) refuseRow("spheres", row, "is not finite or exceeds 1e9 A");
    if (at(row, 3) < 0.0) refuseRow("spheres", row, "has a negative radius");
    out[std::size_t(row)] = {{at(row, 0), at(row, 1), at(row, 2)}, at(row, 3)};
  }
  return out;
}

std::vector<double> numbersIn(const py::object& object, const char* name) {
  const Numbers numbers = numbersOf(object, name);
  if (numbers.ndim() != 1)
    throw py::value_error(std::string(name) + " must have the shape (n,), not " + shapeText(numbers));
  return {numbers.data(), numbers.data() + numbers.size()};
}

std::vector<std::uint32_t> indicesOf(const py::object& indices, std::size_t count, const std::string& name) {
  std::vector<std::uint32_t> out;
  for (const py::handle& one : py::iter(indices)) {
    if (!PyIndex_Check(one.ptr())) throw py::type_error(name + " must contain whole numbers");
    py::ssize_t index = PyNumber_AsSsize_t(one.ptr(), PyExc_IndexError);
    if (index == -1 && PyErr_Occurred()) throw py::error_already_set();
    if (index < 0) index += py::ssize_t(count);
    if (index < 0 || index >= py::ssize_t(count))
      throw py::index_error(name + ": there is no atom " + std::string(py::str(one)) + " among " +
                            std::to_string(count));
    out.push_back(std::uint32_t(index));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace moltact::python
