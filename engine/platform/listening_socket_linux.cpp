#include <sys/socket.h>

#include "engine/platform/listening_socket.h"

namespace moltact {

void takePortAlone(SocketHandle socket) {
  const int yes = 1;  // SO_REUSEADDR lets go of connections that have ended, not of a port in use
  (void)::setsockopt(int(socket), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void lengthenQueue(SocketHandle socket, int connections) { (void)::listen(int(socket), connections); }

}  // namespace moltact
