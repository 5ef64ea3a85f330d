"""Simulated Teensy boards behind pyusb's backend and behind serial ports, and images for them.

A board runs what its flash holds: HELLO tells the identity block found there, and a board whose flash is not a whole
program stays off USB until its button is pressed.
"""

import errno
import itertools
import struct
import zlib
from dataclasses import dataclass, field
from types import SimpleNamespace

import bincopy
import usb.backend
import usb.core
from tests.device.fake import FakeDevice, FakePort, hello_reply

from reliefscope.device import Device, Link, PortInfo
from reliefscope.device.errors import DeviceNotFoundError
from reliefscope.flash import Surroundings
from reliefscope.protocol import messages as m

FLASH = 256 * 1024
BLOCK = 1024
CODE_AT = 0x1000
IDENTITY_AT = 0x2345


def identity_block(
    product="reliefscope",
    board="teensy31",
    version="0.1.0",
    git_hash="0123abcd",
    protocol=m.PROTOCOL_VERSION,
    schema=m.SCHEMA_HASH,
    extra=b"",
):
    """The block of firmware/core/identity.hpp; ``extra`` is what a later layout might append."""
    size = 100 + len(extra)
    body = struct.pack("<8sHH", b"\x89RSID\r\n\x1a", 2 if extra else 1, size)
    for text in (product, board, version, git_hash):
        body += text.encode().ljust(16, b"\0")
    body += struct.pack("<HH16s", protocol, 0, schema) + extra
    return body + struct.pack("<I", zlib.crc32(body))


def program(identity=None, *, stack=0x20008000, start=CODE_AT | 1, fsec=0xDE, blocks=12, salt=0):
    """{address: bytes} of a program whose code is pseudo-random and leaves gaps."""
    vectors = struct.pack("<II", stack, start) + bytes([salt]) * 0x3F8
    config = b"\xff" * 12 + bytes([fsec]) + b"\xff" * 3
    code = bytes((i * 7 + (i >> 5) + salt) & 0xFF for i in range(blocks * BLOCK))
    parts = {0: vectors, 0x400: config, CODE_AT: code, 0x10000: code[:1500]}
    if identity is not None:
        at = IDENTITY_AT - CODE_AT
        parts[CODE_AT] = code[:at] + identity + code[at + len(identity) :]
    return parts


def intel_hex(parts):
    content = bincopy.BinFile()
    for address, data in parts.items():
        content.add_binary(data, address)
    return content.as_ihex()


def write_image(folder, name="firmware.hex", **options):
    """A file with our program for this board; options as of identity_block."""
    path = folder / name
    path.write_text(intel_hex(program(identity_block(**options))))
    return path


class Time:
    """Time that passes only when somebody sleeps or waits for the bus."""

    def __init__(self):
        self.now = 1000.0

    def sleep(self, seconds):
        self.now += seconds

    def monotonic(self):
        return self.now


def usb_error(number, text):
    kind = usb.core.USBTimeoutError if number == errno.ETIMEDOUT else usb.core.USBError
    return kind(text, None, number)


@dataclass
class Teensy:
    """One board; ``mode`` is "serial", "bootloader" or "off" (plugged in, but not on USB)."""

    serial: int = 345678
    port: str = "/dev/ttyACM0"
    ports: tuple = (2, 4)
    mode: str = "serial"
    release: int = 0x275
    usage: int = 0x21
    obeys_baud: bool = True
    forbidden: bool = False
    silent: bool = False
    busy: list = field(default_factory=list)
    """How many reports are not taken before each block, in the order of writing."""
    unplug_before: int | None = None
    """Block (by count of writes) before which the cable is pulled."""
    erased: int = 0
    writes: list = field(default_factory=list)
    flash: bytearray = field(default_factory=lambda: bytearray(b"\xff" * FLASH))
    serial_off: int = 0
    nonces: object = field(default_factory=lambda: itertools.count(1))

    def install(self, parts):
        for address, data in parts.items():
            self.flash[address : address + len(data)] = data
        return self

    @property
    def runs(self):
        """Whether the flash holds a program that comes up."""
        stack, start = struct.unpack_from("<II", self.flash)
        # Every block of the program below must be there: code that is cut off crashes.
        return stack == 0x20008000 and start == CODE_AT | 1 and self.flash[0x10000] != 0xFF

    def press_button(self):
        self.mode = "bootloader"

    def plug_in(self):
        self.unplug_before = None
        self.mode = "serial" if self.runs else "off"

    def hello(self):
        at = self.flash.find(b"\x89RSID")
        if at < 0 or self.silent:
            return None
        _, board, version, git, _, _, schema = struct.unpack_from(
            "<16s16s16s16sHH16s", self.flash, at + 12
        )
        text = [field.rstrip(b"\0").decode() for field in (board, version, git)]
        return dict(zip(("board", "firmware_version", "git_hash"), text, strict=True)) | {
            "schema_hash": schema
        }

    def report(self, data, time):
        """An output report to the bootloader."""
        assert len(data) == 1088
        address = int.from_bytes(data[:3], "little")
        if address == 0xFFFFFF:
            self.plug_in()
            raise usb_error(errno.ENODEV, "No such device")
        assert address % BLOCK == 0
        assert address < FLASH
        assert not any(data[3:64])
        if self.unplug_before == len(self.writes):
            self.mode = "off"
        if self.mode == "off":
            raise usb_error(errno.ENODEV, "No such device")
        if self.busy and self.busy[0] > 0:
            self.busy[0] -= 1
            time.sleep(0.02)
            raise usb_error(errno.ETIMEDOUT, "Operation timed out")
        if self.busy:
            self.busy.pop(0)
        if address == 0:
            self.flash[:] = b"\xff" * FLASH
            self.erased += 1
            time.sleep(1.5)
        else:
            assert self.erased, "block 0 erases and must come first"
        self.flash[address : address + BLOCK] = data[64:]
        self.writes.append(address)


class FakeUsb(usb.backend.IBackend):
    """A bus with boards on it, and a mouse."""

    def __init__(self, boards, time):
        super().__init__()
        self.boards = boards
        self.time = time
        self.drivers = set()

    def enumerate_devices(self):
        yield SimpleNamespace(board=None)
        for board in self.boards:
            if board.mode != "off":
                yield SimpleNamespace(board=board, mode=board.mode)

    def get_device_descriptor(self, device):
        board = device.board
        return SimpleNamespace(
            bLength=18,
            bDescriptorType=1,
            bcdUSB=0x200,
            bDeviceClass=0,
            bDeviceSubClass=0,
            bDeviceProtocol=0,
            bMaxPacketSize0=64,
            idVendor=0x16C0 if board else 0x046D,
            idProduct=0xC077
            if board is None
            else {"serial": 0x0483, "bootloader": 0x0478}[device.mode],
            bcdDevice=board.release if board and device.mode == "serial" else 0x100,
            iManufacturer=0,
            iProduct=0,
            iSerialNumber=3 if board else 0,
            bNumConfigurations=1,
            address=5,
            bus=1,
            port_number=1,
            port_numbers=board.ports if board else (1,),
            speed=2,
        )

    def get_configuration_descriptor(self, device, config):
        return SimpleNamespace(
            bLength=9,
            bDescriptorType=2,
            wTotalLength=34,
            bNumInterfaces=1,
            bConfigurationValue=1,
            iConfiguration=0,
            bmAttributes=0x80,
            bMaxPower=50,
            extra_descriptors=[],
        )

    def get_interface_descriptor(self, device, interface, alternate, config):
        if interface or alternate:
            raise IndexError
        return SimpleNamespace(
            bLength=9,
            bDescriptorType=4,
            bInterfaceNumber=0,
            bAlternateSetting=0,
            bNumEndpoints=0,
            bInterfaceClass=3,
            bInterfaceSubClass=0,
            bInterfaceProtocol=0,
            iInterface=0,
            extra_descriptors=[],
        )

    def open_device(self, device):
        if device.board and device.board.forbidden:
            raise usb_error(errno.EACCES, "Access denied (insufficient permissions)")
        return device

    def close_device(self, handle):
        pass

    def get_configuration(self, handle):
        return 1

    def claim_interface(self, handle, interface):
        if (id(handle.board), handle.mode) not in self.drivers:
            raise usb_error(errno.EBUSY, "Resource busy")

    def release_interface(self, handle, interface):
        pass

    def is_kernel_driver_active(self, handle, interface):
        return (id(handle.board), handle.mode) not in self.drivers

    def detach_kernel_driver(self, handle, interface):
        self.drivers.add((id(handle.board), handle.mode))

    def attach_kernel_driver(self, handle, interface):
        self.drivers.discard((id(handle.board), handle.mode))

    def ctrl_transfer(self, handle, kind, request, value, index, data, timeout):
        board = handle.board
        if board.mode != handle.mode:
            raise usb_error(errno.ENODEV, "No such device")
        match (kind, request):
            case (0x80, 6):
                return self._descriptor(handle, value, data)
            case (0x81, 6) if board.mode == "bootloader":
                return _fill(data, bytes([0x06, 0x9C, 0xFF, 0x09, board.usage, 0xA1, 0x01]))
            case (0x21, 0x20) if board.mode == "serial":
                if not board.obeys_baud:
                    raise usb_error(errno.EPIPE, "Pipe error")
                if int.from_bytes(bytes(data)[:4], "little") == 134:
                    board.mode = "bootloader"
                return len(data)
            case (0x21, 9) if board.mode == "bootloader":
                assert (value, index) == (0x0200, 0)
                assert 0 < timeout <= 5000
                board.report(bytes(data), self.time)
                return len(data)
        raise AssertionError(f"a {board.mode} Teensy has no request {kind:#x} {request:#x}")

    def _descriptor(self, handle, value, data):
        if value == 0x0100:
            return _fill(data, bytes(18))
        if value & 0xFF == 0:
            return _fill(data, bytes([4, 3, 0x09, 0x04]))
        board = handle.board
        number = f"{board.serial:08X}" if handle.mode == "bootloader" else str(board.serial * 10)
        text = number.encode("utf-16-le")
        return _fill(data, bytes([len(text) + 2, 3]) + text)


def _fill(data, content):
    count = min(len(data), len(content))
    data[:count] = type(data)("B", content[:count])
    return count


class Desk:
    """Boards on a desk, and the surroundings of a flasher that sees them."""

    def __init__(self, *boards):
        self.boards = list(boards)
        self.time = Time()
        self.usb = FakeUsb(self.boards, self.time)
        self.touched = []
        self.button_at_s = None

    def around(self):
        return Surroundings(
            find_backend=lambda: self.usb,
            list_ports=self.list_ports,
            open_device=self.open_device,
            touch_port=self.touch,
            sleep=self.sleep,
            monotonic=self.time.monotonic,
        )

    def sleep(self, seconds):
        self.time.sleep(seconds)
        if self.button_at_s is not None and self.time.now >= 1000 + self.button_at_s:
            self.button_at_s = None
            self.boards[0].press_button()

    def list_ports(self):
        return [
            PortInfo(
                b.port, "USB Serial", str(b.serial * 10), True, f"1-{'.'.join(map(str, b.ports))}"
            )
            for b in self.boards
            if b.mode == "serial"
        ]

    def touch(self, port):
        self.touched.append(port)

    def open_device(self, port):
        board = next(b for b in self.boards if b.port == port and b.mode == "serial")
        told = board.hello()
        if told is None:
            raise DeviceNotFoundError(f"No reliefscope device answered on {port} within 1 s.")
        return Device(Link(BoardPort(board, told), port), port, allow_mismatch=True)


class Firmware(FakeDevice):
    """The fake device, answering HELLO with what the board's flash says."""

    def __init__(self, told):
        super().__init__(schema_hash=told["schema_hash"])
        self.told = told

    def answer(self, frame, message):
        if isinstance(message, m.HelloReply):
            message = hello_reply(boot_nonce=self.nonce, last_request_id=self.highest, **self.told)
        return super().answer(frame, message)


class BoardPort(FakePort):
    """Serial port of a board; it goes away when the firmware leaves for the bootloader."""

    def __init__(self, board, told):
        super().__init__(Firmware(told))
        self.board = board

    def close(self):
        super().close()
        if any(isinstance(r, m.EnterBootloaderRequest) for r in self.device.requests):
            self.board.press_button()
