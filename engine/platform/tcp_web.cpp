#include "engine/language/catalogue.h"
#include "engine/platform/tcp.h"

namespace moltact {

Expected<std::unique_ptr<TcpConnection>> TcpConnection::connect(const TcpAddress& address, int) {
  return Problem{"", 0, 0, trf("there is no connection to {0}: a page in a browser has no TCP", address.text()),
                 tr("use the desktop program")};
}

}  // namespace moltact
