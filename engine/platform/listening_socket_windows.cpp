#include <winsock2.h>

#include "engine/platform/listening_socket.h"

namespace moltact {

void takePortAlone(SocketHandle socket) {
  const BOOL yes = TRUE;  // SO_REUSEADDR would let two programs share the port
  (void)::setsockopt(SOCKET(socket), SOL_SOCKET, SO_EXCLUSIVEADDRUSE, reinterpret_cast<const char*>(&yes), sizeof yes);
}

void lengthenQueue(SocketHandle, int) {}

}  // namespace moltact
