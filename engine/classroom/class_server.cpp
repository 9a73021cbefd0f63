#include "engine/classroom/class_server.h"

#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

#include "engine/language/catalogue.h"
#include "engine/platform/listening_socket.h"

namespace moltact {
namespace {

// A connection keeps a thread while its page travels, which takes a slow telephone a minute. So there are more threads than
// students; most of them sleep.
constexpr std::size_t kAnswerThreads = kMaxStudents + 64;
constexpr int kMaxListeners = 16, kTimeout_s = 15, kWaitingConnections = 512;
constexpr std::chrono::milliseconds kEventEvery{1000}, kStopEvery{100};
constexpr std::chrono::seconds kBeat{10}, kGoodFor{60};
constexpr std::chrono::milliseconds kGiveUpAfter{10000};

void giveReply(const ClassReply& reply, httplib::Response& to) {
  to.status = reply.status;
  for (const auto& [name, value] : reply.headers) to.set_header(name, value);
  to.set_header("X-Content-Type-Options", "nosniff");
  to.set_header("Referrer-Policy", "no-referrer");
  to.set_header("Cross-Origin-Resource-Policy", "same-origin");
  to.set_header("Cache-Control", reply.whole ? "no-cache" : "no-store");
  if (reply.whole)
    to.set_content_provider(reply.whole->size(), reply.type.c_str(),
                            [whole = reply.whole](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                              constexpr std::size_t kPiece = std::size_t{64} << 10;
                              return sink.write(whole->data() + offset, std::min(length, kPiece));
                            });
  else
    to.set_content(reply.body, reply.type.c_str());
}

}  // namespace

struct ClassServer::Impl {
  httplib::Server http;
  std::chrono::steady_clock::time_point began = std::chrono::steady_clock::now();
  std::atomic<bool> stopping{false};
  std::atomic<int> listeners{0};
  socket_t socket = INVALID_SOCKET;  // that listens
  std::string address;
  int port = 0;

  // The library asks for a queue of 5 connections; a class that opens the page at the same moment is longer, and each
  // connection beyond it waits a second or more. Linux takes the length of a later call; Windows keeps the first.
  void allowMoreToWait() const {
    if (socket != INVALID_SOCKET) lengthenQueue(SocketHandle(socket), kWaitingConnections);
  }

  double now_s() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(); }

  ClassRequest requestOf(const httplib::Request& from) const {
    ClassRequest out;
    out.method = from.method;
    out.path = from.path;
    out.host = from.get_header_value("Host");
    out.origin = from.get_header_value("Origin");
    out.content_type = from.get_header_value("Content-Type");
    out.fetch_site = from.get_header_value("Sec-Fetch-Site");
    out.if_none_match = from.get_header_value("If-None-Match");
    out.remote = from.remote_addr;
    out.now_s = now_s();
    return out;
  }

  void listen(ClassRequests& requests, httplib::Response& to) {
    if (listeners.fetch_add(1) >= kMaxListeners) {
      listeners.fetch_sub(1);
      ClassReply reply;
      reply.status = 429;
      reply.body = tr("Too many requests; wait a moment.");
      return giveReply(reply, to);
    }
    struct Said {
      std::string parts;
      std::chrono::steady_clock::time_point at{};
    };
    to.set_header("Cache-Control", "no-store");
    to.set_chunked_content_provider(
        "text/event-stream",
        [this, &requests, said = std::make_shared<Said>()](std::size_t, httplib::DataSink& sink) {
          const auto now = std::chrono::steady_clock::now();
          const auto wake = said->at.time_since_epoch().count() ? now + kEventEvery : now;
          while (!stopping && std::chrono::steady_clock::now() < wake) std::this_thread::sleep_for(kStopEvery);
          if (stopping) {
            sink.done();
            return true;
          }
          std::string parts = requests.liveParts(now_s()), text;
          if (parts != said->parts)
            text = "event: live\ndata: " + parts + "\n\n";
          else if (std::chrono::steady_clock::now() - said->at < kBeat)
            return true;
          else
            text = ": still here\n\n";
          said->parts = std::move(parts);
          said->at = std::chrono::steady_clock::now();
          return sink.write(text.data(), text.size());
        },
        [this](bool) { listeners.fetch_sub(1); });
  }
};

ClassServer::ClassServer() : impl_(std::make_unique<Impl>()) {
  httplib::Server& http = impl_->http;
  http.new_task_queue = [] { return new httplib::ThreadPool(kAnswerThreads); };
  http.set_keep_alive_max_count(1);  // a connection that waits for more would keep a thread
  http.set_read_timeout(kTimeout_s);
  http.set_write_timeout(kTimeout_s);
  http.set_payload_max_length(kMaxClassBody);
  http.set_tcp_nodelay(true);
  // Not the library's SO_REUSEPORT, with which a second class of the same account would share the port.
  http.set_socket_options([this](socket_t socket) {
    takePortAlone(SocketHandle(socket));
    impl_->socket = socket;
  });
}

ClassServer::~ClassServer() = default;

std::chrono::steady_clock::time_point ClassServer::clockBegan() const { return impl_->began; }

Expected<int> ClassServer::bind(bool share, int port) {
  impl_->address = share ? "0.0.0.0" : "127.0.0.1";
  int bound = port;
  if (port == 0)
    bound = impl_->http.bind_to_any_port(impl_->address);
  else if (!impl_->http.bind_to_port(impl_->address, port))
    bound = -1;
  if (bound > 0) {
    impl_->allowMoreToWait();
    return impl_->port = bound;
  }
  return Problem{{},
                 0,
                 0,
                 trf("the port {0} of this computer cannot be served", port),
                 tr("end the program that uses it, or choose another with --port")};
}

bool ClassServer::serve(ClassRequests& requests, const std::function<bool()>& stop) {
  httplib::Server& http = impl_->http;
  using Handling = httplib::Server::HandlerResponse;
  const auto refuse = [](int status, httplib::Response& to) {
    ClassReply reply;
    reply.status = status;
    reply.body = tr("The request cannot be read.");
    giveReply(reply, to);
    return Handling::Handled;
  };
  // Before a body is read.
  http.set_pre_routing_handler([&](const httplib::Request& from, httplib::Response& to) {
    const ClassRequest request = impl_->requestOf(from);
    if (const auto reply = requests.refused(request)) {
      giveReply(*reply, to);
      return Handling::Handled;
    }
    // Of these the library would read or make more bytes than the headers say.
    for (const char* header : {"Transfer-Encoding", "Content-Encoding", "Range"})
      if (from.has_header(header)) return refuse(400, to);
    if (request.method == "GET") {
      const ClassReply reply = requests.answer(request);
      if (reply.events)
        impl_->listen(requests, to);
      else
        giveReply(reply, to);
      return Handling::Handled;
    }
    const std::string length = from.get_header_value("Content-Length");
    if (length.empty() || length.size() > 9 || length.find_first_not_of("0123456789") != std::string::npos)
      return refuse(411, to);
    if (std::stoul(length) > kMaxClassBody) return refuse(413, to);
    return Handling::Unhandled;
  });
  http.Post(".*", [&](const httplib::Request& from, httplib::Response& to) {
    ClassRequest request = impl_->requestOf(from);
    request.body = from.body;
    giveReply(requests.answer(request), to);
  });
  http.set_exception_handler(
      [](const httplib::Request&, httplib::Response& to, std::exception_ptr) { to.status = 500; });
  // The library stops to accept after some errors of the system that pass, such as a full table of files. So it begins again.
  std::atomic<bool> served{true};
  auto accepting = std::thread([&] {
    auto again = kStopEvery;
    while (!impl_->stopping) {
      const auto began = std::chrono::steady_clock::now();
      (void)http.listen_after_bind();
      if (impl_->stopping) break;
      if (std::chrono::steady_clock::now() - began > kGoodFor) again = kStopEvery;
      std::this_thread::sleep_for(again);
      if ((again *= 2) > kGiveUpAfter) break;
      if (http.bind_to_port(impl_->address, impl_->port)) impl_->allowMoreToWait();
    }
    served = false;
  });
  bool asked = false;
  while (served && !(asked = stop())) std::this_thread::sleep_for(kStopEvery);
  impl_->stopping = true;
  // stop() does nothing before the thread has begun to accept.
  while (served && !http.is_running()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  http.stop();
  accepting.join();
  return asked;
}

}  // namespace moltact
