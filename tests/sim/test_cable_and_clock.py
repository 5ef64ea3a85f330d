"""Buffers at both ends of the link, and where time comes from."""

import time

from reliefscope_sim.clock import Clock
from reliefscope_sim.faults import Faults
from reliefscope_sim.firmware import NEVER_US
from reliefscope_sim.link import HOST_BUFFER, Cable


class Ends:
    """A device's serial port with a small receive buffer and a lot to say."""

    def __init__(self, room: int = 10, to_say: int = 0) -> None:
        self.room = room
        self.to_say = to_say
        self.taken = b""

    def serial_in(self, data: bytes) -> int:
        count = min(self.room, len(data))
        self.taken += data[:count]
        return count

    def serial_out(self) -> bytes:
        count = min(self.to_say, 4096)
        self.to_say -= count
        return b"\x01" * count


def plugged(fault: str = "") -> Cable:
    cable = Cable(Faults.parse(fault), seed=1)
    cable.plug_in()
    return cable


def test_bytes_wait_until_the_device_takes_them():
    cable, device = plugged(), Ends(room=10)
    cable.send(0, bytes(range(25)))
    left = []
    for time_us in range(4):
        cable.exchange(time_us, device)
        left.append(cable.unsent)
    assert left == [15, 5, 0, 0]
    assert device.taken == bytes(range(25))


def test_a_host_that_does_not_read_lets_the_device_fill_up():
    cable, device = plugged(), Ends(to_say=10 * HOST_BUFFER)
    for time_us in range(100):
        cable.exchange(time_us, device)
    assert HOST_BUFFER <= len(cable.received) < HOST_BUFFER + 4096
    kept = device.to_say
    cable.received.clear()
    cable.exchange(101, device)
    assert device.to_say < kept


def test_nobody_listens_while_the_port_is_closed():
    cable, device = Cable(Faults(), seed=1), Ends(to_say=100)
    cable.exchange(0, device)
    cable.plug_in()
    cable.exchange(1, device)
    assert cable.received == b""
    assert device.to_say == 0


def test_delayed_frames_arrive_when_they_are_due():
    cable, device = plugged("link_delay:5"), Ends(to_say=3)
    cable.exchange(1000, device)
    due_us = cable.next_event_us
    assert 1000 < due_us <= 6000
    cable.exchange(due_us - 1, device)
    assert cable.received == b""
    cable.exchange(due_us, device)
    assert len(cable.received) == 3
    assert cable.next_event_us == NEVER_US


def test_broken_cable_carries_nothing_until_it_is_plugged_in_again():
    cable, device = plugged(), Ends(to_say=5)
    cable.broken = True
    cable.send(0, b"lost")
    cable.exchange(0, device)
    assert (device.taken, cable.received) == (b"", b"")
    cable.plug_in()
    cable.exchange(1, device)
    assert (device.taken, len(cable.received)) == (b"", 5)


def test_virtual_time_moves_only_when_told_and_never_back():
    clock = Clock("virtual")
    time.sleep(0.002)
    assert clock.due_us() == 0
    clock.advance_to(500)
    clock.advance_to(300)
    assert clock.due_us() == 500


def test_real_time_follows_the_wall():
    clock = Clock("real")
    started = time.monotonic()
    time.sleep(0.02)
    clock.advance_to(10**9)
    elapsed_us = (time.monotonic() - started) * 1e6
    assert elapsed_us - 5000 < clock.due_us() < elapsed_us + 50_000
