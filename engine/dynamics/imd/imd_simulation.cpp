#include "engine/dynamics/imd/imd_simulation.h"

#include <system_error>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {
constexpr std::size_t kChunk_bytes = 1 << 16;
constexpr int kWait_ms = 5;  // the longest time until a command is seen
}  // namespace

ImdSimulation::ImdSimulation(std::unique_ptr<TcpConnection> connection, std::vector<Vec3> start_A)
    : connection_(std::move(connection)), session_(std::move(start_A), 0.0), buffer_(kChunk_bytes) {}

Expected<std::unique_ptr<LiveSimulation>> ImdSimulation::connect(const TcpAddress& address, std::vector<Vec3> start_A,
                                                                 std::shared_ptr<const std::atomic<bool>> cancelled) {
  auto connection = TcpConnection::connect(address, kConnect_ms);
  if (!connection) return connection.problem();
  auto made = over(*std::move(connection), std::move(start_A), std::move(cancelled));
  if (made) return made;
  Problem named = made.problem();
  named.file = address.text();
  return named;
}

Expected<std::unique_ptr<LiveSimulation>> ImdSimulation::over(std::unique_ptr<TcpConnection> connection,
                                                              std::vector<Vec3> start_A,
                                                              std::shared_ptr<const std::atomic<bool>> cancelled) {
  if (start_A.empty() || start_A.size() > kMaxAtoms)
    return Problem{{},
                   0,
                   0,
                   trf("the molecule has {0} atoms; simulations have 1 to {1}", start_A.size(), kMaxAtoms),
                   tr("set the server to send a group of atoms only, and open the structure of this group")};
  std::unique_ptr<ImdSimulation> made(new ImdSimulation(std::move(connection), std::move(start_A)));
  while (made->session_.frame().serial == 0) {
    if (cancelled && cancelled->load(std::memory_order_relaxed))
      return Problem{{}, 0, 0, tr("the connection was given up"), {}};
    made->step();
    if (made->session_.problem()) return *made->session_.problem();
  }
  made->frames_.back() = made->session_.frame();
  made->frames_.publish();
  try {
    made->thread_ = std::thread([simulation = made.get()] { simulation->run(); });
  } catch (const std::system_error& e) {
    return Problem{{}, 0, 0, trf("the simulation cannot begin: {0}", e.what()), {}};
  }
  return std::unique_ptr<LiveSimulation>(std::move(made));
}

ImdSimulation::~ImdSimulation() {
  ends_.store(true, std::memory_order_relaxed);
  if (thread_.joinable()) thread_.join();
  farewell();
}

double ImdSimulation::now_s() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
}

void ImdSimulation::command(const SimulationCommand& wanted) {
  commands_.back() = wanted;
  commands_.publish();
  commanded_.fetch_add(1, std::memory_order_release);
}

// Reads what has arrived, and answers.
void ImdSimulation::step() {
  const int size = connection_->read(buffer_, kWait_ms);
  if (size < 0) return session_.lost();
  // A stopped program gives no force, on neither side.
  if (forceInhibited()) {
    SimulationCommand rests;
    rests.running = obeyed_ == 0 || commands_.read().running;
    session_.command(rests, now_s());
  } else if (const std::uint64_t count = commanded_.load(std::memory_order_acquire); count != obeyed_) {
    obeyed_ = count;
    session_.command(commands_.read(), now_s());
  }
  if (size > 0) session_.received({buffer_.data(), std::size_t(size)}, now_s());
  session_.passed(now_s());
  if (!session_.toSend().empty() && !connection_->write(session_.toSend())) session_.lost();
  session_.toSend().clear();
  if (remembers_last_words_) return;
  if (const std::vector<std::uint8_t> words = session_.lastWords(); !words.empty()) {
    connection_->lastBytes(words);
    remembers_last_words_ = true;
  }
}

void ImdSimulation::run() {
  const CrashStack crash_stack;
  constexpr double kPublish_s = 0.002;
  double published_s = -1.0;
  while (!ends_.load(std::memory_order_relaxed) && !session_.ended()) {
    step();
    const SimulationFrame& frame = session_.frame();
    const double now = now_s();
    if (frame.serial == published_ || (now - published_s < kPublish_s && !session_.ended())) continue;
    published_ = frame.serial;
    published_s = now;
    frames_.back() = frame;
    frames_.publish();
  }
}

// The server closes the connection when it has read the last message. Closing it first, while positions are still
// arriving, could destroy that message.
void ImdSimulation::farewell() {
  connection_->lastBytes({});
  const bool had_ended = session_.ended();
  session_.leave();
  if (session_.toSend().empty() && !had_ended) return;
  if (!session_.toSend().empty() && !connection_->write(session_.toSend())) return;
  const double until_s = now_s() + 0.001 * kFarewell_ms;
  while (now_s() < until_s)
    if (connection_->read(buffer_, 20) < 0) return;
}

}  // namespace moltact
