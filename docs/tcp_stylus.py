#!/usr/bin/env python3
"""A stylus over TCP in the open report layout: docs/device-protocol.md, "Over a network".

    python3 docs/tcp_stylus.py 7010        (another port, or 0 for any free one)
    moltact device check open-tcp:7010     (or choose the address on the device page)

The handle is a mass of 50 g. A simulated hand pulls it along a path through the workspace, and the motors push it back.
"""
import math, select, socket, struct, sys, time

PEAK_N, CONTINUOUS_N, UNIT_MM = 3.0, 1.0, 0.005
# id, magic, version; unit in nm, peak and continuous force in mN; workspace in mm; stiffness in N/m, own damping and
# renderable damping in mN s/m, friction in mN, delay in µs; flags
DESCRIPTION = struct.pack("<B4sB3H3H5HB3x", 3, b"MLTC", 1, 5000, 3000, 1000, 160, 120, 120, 500, 1000, 5000, 20, 2000, 0)
MASS_KG, HAND_N_PER_M, HAND_N_S_PER_M = 0.05, 60.0, 3.0

def send(host, report):
    host.sendall(bytes([len(report)]) + report)

def serve(host):
    place, speed, force = [0.0, 0.0, 0.05], [0.0] * 3, [0.0] * 3      # metres, metres per second, newtons
    received, number, force_number = b"", 0, 0
    start = tick = received_at = printed_at = time.monotonic()
    motors_off_at = 0.0
    while True:
        wait = max(0.0, tick - time.monotonic())
        if select.select([host], [], [], wait)[0]:
            data = host.recv(4096)
            if not data:
                return                                                # the host has closed: no force any more
            received += data
        while received and len(received) > received[0]:
            report, received = received[1:1 + received[0]], received[1 + received[0]:]
            received_at = time.monotonic()
            if report[:1] == b"\x03":
                send(host, DESCRIPTION)
            elif report[:1] == b"\x02" and len(report) == 11:
                _, force_number, x, y, z, motors_on, watchdog_ms = struct.unpack("<BH3hBB", report)
                force = [max(-PEAK_N, min(PEAK_N, mN / 1000)) * motors_on for mN in (x, y, z)]
                motors_off_at = received_at + (watchdog_ms or 50) / 1000
        now = time.monotonic()
        if now > received_at + 2.0:
            return                                                    # the host is silent
        if now > motors_off_at:
            force = [0.0] * 3                                         # the watchdog
        if now < tick:
            continue
        tick = max(tick + 0.001, now - 0.01)
        t = now - start
        goal = 0.02 * math.sin(t), 0.02 * math.cos(t), 0.05 * math.cos(2 * t)
        for k in range(3):                                            # the hand pulls, the motors push
            pull = HAND_N_PER_M * (goal[k] - place[k]) - HAND_N_S_PER_M * speed[k] + force[k]
            speed[k] += pull / MASS_KG * 0.001
            place[k] += speed[k] * 0.001
        number = (number + 1) % 65536
        steps = [max(-32767, min(32767, round(1000 * p / UNIT_MM))) for p in place]
        send(host, struct.pack("<BHI3h4hBBH", 1, number, int(t * 1e6) % 2**32, *steps, 0, 0, 0, 32767, 0, 0, force_number))
        if now > printed_at + 0.1:
            printed_at = now
            print("place %.1f %.1f %.1f mm, force %.3f %.3f %.3f N" % (*(1000 * p for p in place), *force), flush=True)

with socket.create_server(("127.0.0.1", int(sys.argv[1]) if len(sys.argv) > 1 else 7010)) as listener:
    print("listening on 127.0.0.1:%d" % listener.getsockname()[1], flush=True)
    while True:
        connection, _ = listener.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        with connection:
            try:
                serve(connection)
            except OSError:
                pass                                                  # the connection broke
