// What a server asks of the system for the socket that its library listens on. Any thread but the haptic one.
#pragma once

#include <cstdint>

namespace moltact {

/// The system's handle of a socket: a file descriptor, or Windows' SOCKET.
using SocketHandle = std::uintptr_t;

/// Before the socket is bound: no other program may listen on its port at the same time, but a program that was just stopped
/// may begin again.
void takePortAlone(SocketHandle socket);

/// After listen(): lets up to `connections` wait to be accepted. Where the system keeps the first length, as Windows does,
/// nothing happens.
void lengthenQueue(SocketHandle socket, int connections);

}  // namespace moltact
