// Real LAMMPS as the server, where the program lmp is installed; else the tests say that they did not run. Oracle: at
// 10 K an atom of a free molecule that a spring pulls comes to rest at the end of the spring.
#include <doctest/doctest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "engine/dynamics/imd/imd_simulation.h"
#include "tests/dynamics/child_program.h"

using namespace moltact;
using namespace moltact::test;

namespace {

namespace fs = std::filesystem;

// Atoms at the corners of a cube of 3 x 3 x 3, 1.5 A apart, with springs between those nearer than 2.7 A.
struct LammpsCube {
  fs::path folder;
  std::vector<Vec3> atoms;
  std::uint16_t port = freePort();

  explicit LammpsCube(const std::string& name, const std::string& imd = "") {
    folder = fs::temp_directory_path() / ("moltact-" + name + "-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    for (int k = 0; k < 27; ++k) atoms.push_back(1.5 * Vec3(k % 3, k / 3 % 3, k / 9));
    std::string bonds;
    int count = 0;
    for (std::size_t i = 0; i < atoms.size(); ++i)
      for (std::size_t j = i + 1; j < atoms.size(); ++j)
        if (const double length = glm::distance(atoms[i], atoms[j]); length < 2.7)
          bonds += std::to_string(++count) +
                   (length < 1.6   ? " 1 "
                    : length < 2.2 ? " 2 "
                                   : " 3 ") +
                   std::to_string(i + 1) + ' ' + std::to_string(j + 1) + '\n';
    std::ofstream data(folder / "cube.data");
    data << "cube\n\n27 atoms\n" << count << " bonds\n1 atom types\n3 bond types\n";
    for (const char* axis : {"x", "y", "z"}) data << "-500 500 " << axis << "lo " << axis << "hi\n";
    data << "\nMasses\n\n1 12.0\n\nAtoms\n\n";
    for (std::size_t i = 0; i < atoms.size(); ++i)
      data << i + 1 << " 1 1 " << atoms[i].x << ' ' << atoms[i].y << ' ' << atoms[i].z << '\n';
    data << "\nBonds\n\n" << bonds;
    std::ofstream in(folder / "in.cube");
    in << "units real\natom_style bond\nboundary f f f\npair_style zero 10.0\nbond_style harmonic\n"
          "special_bonds lj/coul 1 1 1\nread_data cube.data extra/special/per/atom 30\n"
          "pair_coeff * *\nbond_coeff 1 100 1.5\nbond_coeff 2 100 2.12132\nbond_coeff 3 100 2.598076\n"
          "fix move all nve\nfix bath all langevin 10 10 100 1234\nfix hand all imd "
       << port << " unwrap on " << imd << "\nthermo 1000000\ntimestep 1\nrun 2000000000\n";
  }
  ~LammpsCube() {
    std::error_code error;
    fs::remove_all(folder, error);
  }
  std::string log() const {
    std::ifstream in(folder / "log");
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

template <class Done>
bool comes(Done done) {
  for (int k = 0; k < 60'000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return done();
}

// It listens some time after its start.
std::unique_ptr<LiveSimulation> connected(const LammpsCube& cube) {
  std::string why;
  for (int k = 0; k < 6000; ++k) {
    auto made = ImdSimulation::connect({"127.0.0.1", cube.port}, cube.atoms, nullptr);
    if (made) return *std::move(made);
    why = made.problem().text();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  FAIL(why << '\n' << cube.log());
  return nullptr;
}

bool lammpsMissing() { return lacksProgram("lmp", "lammps"); }

// A client that says GO and nothing else, so that forces that another one has left behind stay on. The places of an atom
// in so many frames; empty if the server does not answer for 10 s.
std::vector<Vec3> silentlyWatched(std::uint16_t port, std::size_t atom, int frames) {
  std::vector<Vec3> out;
  int socket = -1;
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  at.sin_port = htons(port);
  for (int k = 0; k < 1000; ++k) {
    socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (::connect(socket, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0) break;
    ::close(std::exchange(socket, -1));
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  if (socket < 0) return out;
  const timeval wait{10, 0};
  ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &wait, sizeof wait);
  const auto read = [&](void* to, std::size_t size) { return ::recv(socket, to, size, MSG_WAITALL) == ssize_t(size); };
  std::int32_t head[2];
  const std::int32_t go[2] = {std::int32_t(htonl(3)), 0};
  if (read(head, 8) && ntohl(std::uint32_t(head[0])) == 4 && ::send(socket, go, 8, 0) == 8)
    while (int(out.size()) < frames && read(head, 8)) {
      const std::uint32_t type = ntohl(std::uint32_t(head[0])), length = ntohl(std::uint32_t(head[1]));
      std::vector<float> body(type == 1 ? 10 : type == 2 ? 3 * std::size_t(length) : 0);
      if (!body.empty() && !read(body.data(), 4 * body.size())) break;
      if (type == 2 && 3 * atom + 2 < body.size())
        out.emplace_back(body[3 * atom], body[3 * atom + 1], body[3 * atom + 2]);
    }
  ::close(socket);
  return int(out.size()) == frames ? out : std::vector<Vec3>();
}

Vec3 meanPlace(std::span<const Vec3> places) {
  Vec3 out(0.0);
  for (const Vec3& v : places) out += v / double(places.size());
  return out;
}

}  // namespace

TEST_CASE(
    "real LAMMPS: a corner of the cube that is pulled comes to rest within 0.5 A of where the spring ends; a "
    "client after us that sends no word about forces finds it without a force: in 5 ps it moves by less than 3 A") {
  if (lammpsMissing()) return;
  LammpsCube cube("lammps-pull");
  ChildProgram lammps({"lmp", "-in", "in.cube", "-log", "none"}, cube.folder.string(), "log");
  const Vec3 end = cube.atoms[26] + Vec3(6, 2, 0);
  std::unique_ptr<LiveSimulation> live = connected(cube);
  SimulationCommand wanted;
  wanted.pushes.push_back({26, end, Vec3(0.0), 2.0});
  Vec3 mean(0.0);
  const auto meanOf = [&](int frames) {
    mean = Vec3(0.0);
    std::uint64_t last = 0;
    for (int k = 0; k < frames;) {
      live->command(wanted);
      const SimulationFrame& frame = live->newest();
      if (frame.dead) return false;
      if (frame.serial == last) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      last = frame.serial;
      ++k;
      mean += frame.positions_A[26] / double(frames);
    }
    return true;
  };
  CHECK(comes([&] { return !meanOf(50) || glm::distance(mean, end) < 0.5; }));
  REQUIRE_FALSE_MESSAGE(live->newest().dead, live->newest().fault);
  MESSAGE("mean distance from the end of the spring ", glm::distance(mean, end), " A");
  // We leave while the spring pulls with its greatest force of 29 kcal/mol/A. If that stayed on, the cube would drift by
  // 3.7 A in a picosecond; by diffusion it moves about 1 A in 60 ps.
  wanted.pushes[0].to_A = end + Vec3(40, 0, 0);
  // Its thermal motion about its mean place is below 0.5 A.
  const double pulled_from_A = mean.x;
  REQUIRE(comes([&] {
    live->command(wanted);
    return live->newest().dead || live->newest().positions_A[26].x > pulled_from_A + 1.0;
  }));
  REQUIRE_FALSE_MESSAGE(live->newest().dead, live->newest().fault);
  live.reset();
  // A frame comes in each step of 1 fs until a client sets another rate.
  const std::vector<Vec3> places = silentlyWatched(cube.port, 26, 5000);
  REQUIRE(places.size() == 5000);
  const double drift_A = glm::distance(meanPlace(std::span(places).first(50)), meanPlace(std::span(places).last(50)));
  MESSAGE("after us, the corner moves by ", drift_A, " A in 5000 frames");
  CHECK(drift_A < 3.0);
}

TEST_CASE(
    "real LAMMPS, stopped by SIGSTOP: the forces end, the frame is silent; continued: positions come again; killed in "
    "the middle: the session ends with a sentence; paused by the client it stands still") {
  if (lammpsMissing()) return;
  LammpsCube cube("lammps-faults");
  ChildProgram lammps({"lmp", "-in", "in.cube", "-log", "none"}, cube.folder.string(), "log");
  std::unique_ptr<LiveSimulation> live = connected(cube);
  SimulationCommand wanted;
  wanted.pushes.push_back({0, cube.atoms[0] - Vec3(2, 0, 0), Vec3(0.0), 2.0});
  const auto becomes = [&](auto done) {
    return comes([&] {
      live->command(wanted);
      return done(live->newest());
    });
  };
  CHECK(becomes([](const SimulationFrame& f) { return f.serial > 100; }));
  lammps.signal(SIGSTOP);
  CHECK(becomes([](const SimulationFrame& f) { return f.silent; }));
  const std::uint32_t starts = live->newest().starts;
  lammps.signal(SIGCONT);
  CHECK(becomes([&](const SimulationFrame& f) { return !f.silent && f.starts > starts; }));
  wanted.running = false;
  std::uint64_t serial = 0;
  int still = 0;
  CHECK(becomes([&](const SimulationFrame& f) {
    still = f.serial == serial ? still + 1 : 0;
    serial = f.serial;
    return still > 200;
  }));
  wanted.running = true;
  CHECK(becomes([&](const SimulationFrame& f) { return f.serial > serial + 100; }));
  lammps.kill();
  CHECK(becomes([](const SimulationFrame& f) { return f.dead; }));
  CHECK(live->newest().fault.find("lost") != std::string::npos);
}
