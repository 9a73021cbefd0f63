#include "engine/haptics/methods.h"

#include <array>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/paper/paper_tracker.h"

namespace moltact {
namespace {

template <class T>
std::unique_ptr<Tracker> make(std::shared_ptr<const BallScene> scene, double probe_A) {
  return std::make_unique<T>(std::move(scene), probe_A);
}

constexpr std::array kMethods{
    Method{"exact", "the sphere tracker without error: the god-object on the union of balls", &make<ExactTracker>},
    Method{"paper", "Algorithm 1 of Stocks and Laycock (2008) as published, its faults included", &make<PaperTracker>},
};

}  // namespace

std::span<const Method> methods() { return kMethods; }

const Method* findMethod(std::string_view name) {
  for (const Method& m : kMethods)
    if (m.name == name) return &m;
  return nullptr;
}

}  // namespace moltact
