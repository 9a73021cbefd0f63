#include "engine/haptics/field/compute_grid.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace moltact {
namespace {

constexpr int kBrick = 4;  // nodes along an edge that share a list of atoms

// The atoms within `reach` of a point, in blocks relative to it.
std::vector<PairBlock> blocksNear(const SphereGrid& scene, std::span<const PairAtom> atoms, const Vec3& centre,
                                  double reach) {
  std::vector<PairBlock> out;
  int lane = PairBlock::kLanes;
  scene.visitCentresNear(centre, reach, [&](std::uint32_t index, const Sphere& sphere) {
    const Vec3 relative = sphere.centre_A - centre;
    if (glm::dot(relative, relative) > reach * reach) return;
    if (lane == PairBlock::kLanes) {
      out.emplace_back().clear(0);
      lane = 0;
    }
    out.back().set(lane++, relative, atoms[index]);
  });
  return out;
}

}  // namespace

bool runGridWork(std::size_t count, int threads, const std::function<void(std::size_t)>& work,
                 const GridProgress& progress) {
  std::atomic<std::size_t> next{0}, finished{0};
  std::atomic<bool> stopped{false};
  std::exception_ptr thrown;
  std::mutex throwing;
  const auto run = [&](bool reports) {
    auto reported = std::chrono::steady_clock::now() - std::chrono::seconds(1);
    for (std::size_t k; !stopped && (k = next++) < count;) {
      try {
        work(k);
        ++finished;
        const auto now = std::chrono::steady_clock::now();
        if (reports && progress && now - reported > std::chrono::milliseconds(100)) {
          reported = now;
          if (!progress(double(finished) / double(count))) stopped = true;
        }
      } catch (...) {
        const std::lock_guard lock(throwing);
        if (!thrown) thrown = std::current_exception();
        stopped = true;
      }
    }
  };
  const unsigned wanted = threads > 0 ? unsigned(threads) : std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::thread> others;
  others.reserve(wanted);
  try {
    for (unsigned k = 1; k < wanted; ++k) others.emplace_back([&] { run(false); });
  } catch (const std::system_error&) {  // no further thread available
  }
  run(true);
  for (std::thread& other : others) other.join();
  if (thrown) std::rethrow_exception(thrown);
  return finished == count && (!progress || progress(1.0));
}

std::optional<GridMaps> computeGridMaps(const SphereGrid& scene, std::span<const PairAtom> atoms, const GridBox& box,
                                        std::span<const float> sizes, const PairModel& model, int threads,
                                        const GridProgress& progress) {
  GridMaps out;
  out.box = box;
  out.van_der_waals.assign(sizes.size(), std::vector<float>(box.count()));
  out.electrostatic.resize(box.count());
  const PairConstants constants(model);
  const AddPairs add = pairKernel(model.kind).slope;
  const PairAtom unit{.depth_kcal_mol = sizes.empty() ? 0.0f : 1.0f, .charge_e = 1.0f};
  std::array<std::size_t, 3> bricks{};
  for (std::size_t axis = 0; axis < 3; ++axis) bricks[axis] = std::size_t((box.nodes[axis] + kBrick - 1) / kBrick);
  const auto brick = [&](std::size_t number) {
    const int i0 = int(number % bricks[0]) * kBrick, j0 = int(number / bricks[0] % bricks[1]) * kBrick,
              k0 = int(number / bricks[0] / bricks[1]) * kBrick;
    const Vec3 centre = box.node(i0, j0, k0) + Vec3(0.5 * (kBrick - 1) * box.spacing_A);
    const double half = 0.5 * (kBrick - 1) * box.spacing_A * std::sqrt(3.0);
    const std::vector<PairBlock> blocks = blocksNear(scene, atoms, centre, model.cutoff_A + half);
    const PairRun all{blocks.data(), int(blocks.size())};
    for (int k = k0; k < std::min(k0 + kBrick, box.nodes[2]); ++k)
      for (int j = j0; j < std::min(j0 + kBrick, box.nodes[1]); ++j)
        for (int i = i0; i < std::min(i0 + kBrick, box.nodes[0]); ++i) {
          const Vec3 at = box.node(i, j, k) - centre;
          const std::size_t node = box.index(i, j, k);
          PairOwn own(unit, at);
          for (std::size_t size = 0; size < std::max<std::size_t>(sizes.size(), 1); ++size) {
            if (size < sizes.size()) own.half_minimum_A = sizes[size];
            PairTerms terms;
            add(&all, 1, constants, own, terms);
            if (size < sizes.size()) out.van_der_waals[size][node] = float(terms.energy[EnergyPart::VanDerWaals]);
            if (size == 0) out.electrostatic[node] = float(terms.energy[EnergyPart::Electrostatic]);
          }
        }
  };
  if (!runGridWork(bricks[0] * bricks[1] * bricks[2], threads, brick, progress)) return std::nullopt;
  return out;
}

}  // namespace moltact
