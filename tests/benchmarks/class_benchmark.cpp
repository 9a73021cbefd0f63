// How fast a live class answers: a server on the loopback, and students who send a line every two seconds, each with a
// connection of its own per request as browsers do here. Prints percentiles of the time from connecting to the whole answer,
// which the server gives after the line is on the disk. Then all students ask at the same instant, five times, two seconds apart.
//
//   class_benchmark [STUDENTS [SECONDS [FOLDER]]]     200 students, 30 s, a new folder in the working folder
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>
#include <vector>

#include "engine/classroom/class_requests.h"
#include "engine/classroom/class_server.h"
#include "engine/platform/random_bytes.h"
#include "tests/classroom/http_client.h"
#include "tests/classroom/small_class.h"

using namespace moltact;
using Clock = std::chrono::steady_clock;

namespace {

double percentile(const std::vector<double>& sorted, double share) {
  return sorted.empty() ? 0.0 : sorted[std::min(sorted.size() - 1, std::size_t(share * double(sorted.size())))];
}

// A line of 40 samples of the hand, as a page writes it about once a second of touch.
std::string handLine(double t_s) {
  HipChunk chunk;
  for (int k = 0; k < 40; ++k) {
    HipSample sample;
    sample.t_s = t_s + 0.05 * k;
    sample.hip.A = {12.345 + 0.01 * k, -3.25, 7.125};
    sample.scp.A = {12.345 + 0.01 * k, -3.0, 7.25};
    sample.force.N = {0.1, 0.25, 0.5};
    sample.feature = Feature::Sphere;
    sample.atoms = {7, -1, -1};
    chunk.samples.push_back(sample);
  }
  return test::eventLine(t_s + 2.0, chunk);
}

}  // namespace

int main(int argc, char** argv) {
  const int students = argc > 1 ? std::atoi(argv[1]) : 200;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 30.0;
  const std::filesystem::path folder = argc > 3 ? argv[3] : "class-benchmark";
  std::filesystem::remove_all(folder);

  ClassServer server;
  const auto port = server.bind(false, 0);
  auto store = ClassStore::begin(folder, {"abc234", "teacher", 7, *port, "2026-11-21T10:00:00Z"});
  if (!port || !store) return std::fprintf(stderr, "the class cannot begin\n"), 1;
  ClassSite site;
  site.page = "<script id=\"classroom-script\"></script><!--a lesson comes here-->";
  site.hosts = {"127.0.0.1:" + std::to_string(*port)};
  site.random = randomBytes;
  ClassRoom room(test::smallLessons(), 7);
  std::vector<std::string> tokens;
  for (int k = 0; k < students; ++k) {
    const auto joined = room.join("", "token-" + std::to_string(k) + "-" + std::string(16, 'x'), 0.0);
    tokens.push_back(room.students()[joined->student].token);
    (*store)->add(joined->record);
  }
  auto requests = ClassRequests::make(std::move(site), std::move(room), **store);
  if (!requests) return 1;
  std::atomic<bool> stop{false};
  std::thread serving([&] { server.serve(**requests, [&] { return stop.load(); }); });
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  // The teacher's page is open meanwhile.
  std::thread teacher([&] { test::httpAsk(std::uint16_t(*port), "GET", "/teacher/teacher/events", "", "", "never"); });

  std::mutex lock;
  std::vector<double> times_ms, bursts_ms;
  std::atomic<int> failed{0};
  const auto begin = Clock::now(),
             end = begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  std::vector<std::thread> threads;
  for (int k = 0; k < students; ++k)
    threads.emplace_back([&, k] {
      std::vector<double> own;
      std::size_t have = 0;
      auto next = begin + std::chrono::milliseconds(2000 * k / students);
      for (; next < end; next += std::chrono::seconds(2)) {
        std::this_thread::sleep_until(next);
        const double t_s = std::chrono::duration<double>(next - begin).count();
        const std::string line = have == 0 ? test::headerLine() : handLine(t_s);
        const std::string body = nlohmann::json{
            {"token", tokens[std::size_t(k)]},
            {"attempt", "a"},
            {"from", have},
            {"lines", {line}}}.dump();
        const auto asked = Clock::now();
        const test::HttpAnswer answer =
            test::httpAsk(std::uint16_t(*port), "POST", "/abc234/lines", body, "Content-Type: application/json\r\n");
        own.push_back(std::chrono::duration<double, std::milli>(Clock::now() - asked).count());
        const auto json = nlohmann::json::parse(answer.body, nullptr, false);
        if (answer.status != 200 || !json.is_object() || json.value("have", std::size_t{0}) != have + 1)
          ++failed;
        else
          ++have;
      }
      std::vector<double> together;
      for (int burst = 1; burst <= 5; ++burst) {
        std::this_thread::sleep_until(end + std::chrono::seconds(2 * burst));
        const auto asked = Clock::now();
        const std::string body = nlohmann::json{{"token", tokens[std::size_t(k)]}}.dump();
        if (test::httpAsk(std::uint16_t(*port), "POST", "/abc234/lines", body, "Content-Type: application/json\r\n")
                .status != 200)
          ++failed;
        together.push_back(std::chrono::duration<double, std::milli>(Clock::now() - asked).count());
      }
      const std::lock_guard held(lock);
      times_ms.insert(times_ms.end(), own.begin(), own.end());
      bursts_ms.insert(bursts_ms.end(), together.begin(), together.end());
    });
  for (std::thread& one : threads) one.join();
  stop = true;
  serving.join();
  teacher.join();
  std::sort(times_ms.begin(), times_ms.end());
  std::printf("%d students, %zu lines in %.0f s, %d failed; answer: median %.1f ms, p99 %.1f ms, longest %.1f ms\n",
              students, times_ms.size(), seconds, failed.load(), percentile(times_ms, 0.5), percentile(times_ms, 0.99),
              times_ms.empty() ? 0.0 : times_ms.back());
  std::sort(bursts_ms.begin(), bursts_ms.end());
  std::printf("all %d at the same instant: median %.1f ms, p99 %.1f ms, longest %.1f ms\n", students,
              percentile(bursts_ms, 0.5), percentile(bursts_ms, 0.99), bursts_ms.empty() ? 0.0 : bursts_ms.back());
  std::filesystem::remove_all(folder);
  return failed ? 1 : 0;
}
