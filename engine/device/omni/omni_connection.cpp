#include "engine/device/omni/omni_connection.h"

#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {

OmniConnection& OmniConnection::get() {
  static OmniConnection one;
  return one;
}

OmniConnection::~OmniConnection() {
  closeUnused();
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  if (closer_.joinable()) closer_.join();
}

Expected<OmniSession> OmniConnection::opened(const hd::Library& hd) {
  hd_ = &hd;
  if (taken_) return Problem{"", 0, 0, tr("the device is open already"), tr("close it first")};
  if (session_) return *session_;
  return openOmni(hd);
}

Expected<OmniSession> OmniConnection::look(const hd::Library& hd) {
  const std::lock_guard lock(mutex_);
  const bool kept = session_.has_value();
  auto session = opened(hd);
  if (!session || kept) return session;  // not kept longer, because it may have been unplugged meanwhile
  session_ = *session;
  until_ = std::chrono::steady_clock::now() + kKeepOpen;
  if (!closer_.joinable()) closer_ = std::thread([this] { run(); });
  changed_.notify_all();
  return session;
}

Expected<OmniSession> OmniConnection::take(const hd::Library& hd) {
  const std::lock_guard lock(mutex_);
  auto session = opened(hd);
  if (!session) return session;
  session_.reset();
  taken_ = *session;
  return session;
}

void OmniConnection::giveBack() {
  const std::lock_guard lock(mutex_);
  taken_.reset();
}

std::optional<OmniSession> OmniConnection::taken() {
  const std::lock_guard lock(mutex_);
  return taken_;
}

void OmniConnection::renewed(const OmniSession& session) {
  const std::lock_guard lock(mutex_);
  taken_ = session;
}

void OmniConnection::closeUnused() {
  const std::lock_guard lock(mutex_);
  if (session_) closeOmni(*hd_, *session_);
  session_.reset();
}

// Closes a device that take() has not requested in time.
void OmniConnection::run() {
  std::unique_lock lock(mutex_);
  while (!ends_) {
    if (!session_) {
      changed_.wait(lock);
    } else if (std::chrono::steady_clock::now() < until_) {
      changed_.wait_until(lock, until_);
    } else {
      closeOmni(*hd_, *session_);
      session_.reset();
    }
  }
}

}  // namespace moltact
