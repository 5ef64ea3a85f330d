"""Flashing simulated boards through pyusb: the straight way, every way in, and every way in which it ends early."""

import dataclasses

import pytest
from tests.device.fake import FakeDevice
from tests.flash.boards import Desk, Teensy, identity_block, intel_hex, program, write_image

from reliefscope.device import SequenceState
from reliefscope.device.errors import PortAccessError
from reliefscope.errors import Cancelled
from reliefscope.flash import (
    FirmwareImage,
    Flasher,
    FlashError,
    HalfWrittenError,
    ImageError,
    NotConfirmedError,
    UsbAccessError,
)
from reliefscope.jobs import Job

OLD = program(identity_block(version="0.0.9", git_hash="old", schema=bytes(16)), salt=3)


@pytest.fixture
def image(tmp_path):
    return FirmwareImage.load(write_image(tmp_path, version="0.2.0", git_hash="new"))


def flash(desk, image, name=None, job=None, **options):
    flasher = Flasher(desk.around(), job)
    return flasher.flash(image, flasher.select(name), **options)


def holds(board, image):
    """Whether the board's flash is the image and nothing else."""
    return board.flash == image.data.ljust(len(board.flash), b"\xff")


def test_board_with_older_firmware_of_ours(image):
    board = Teensy().install(OLD)
    job = Job()
    seen = []
    job.subscribe(seen.append)
    desk = Desk(board)
    report = flash(desk, image, job=job)
    assert holds(board, image)
    assert (report.before, report.after) == ("0.0.9 (old)", "0.2.0 (new)")
    assert (report.confirmed, report.port, report.attempts) == (True, "/dev/ttyACM0", 1)
    assert report.blocks == len(board.writes) == len(image.blocks)
    assert board.writes[0] == 0
    assert (board.erased, board.mode, desk.touched) == (1, "serial", [])
    assert [p.done for p in seen if p.stage == "write"][:-1] == list(range(report.blocks + 1))


def test_firmware_of_our_own_version_is_replaced_too(image, tmp_path):
    board = Teensy().install(program(identity_block(git_hash="same")))
    assert flash(Desk(board), image).before == "0.1.0 (same)"


def test_board_with_a_program_of_others_goes_by_134_baud(image):
    board = Teensy().install(program())
    report = flash(Desk(board), image)
    assert (report.before, report.after) == ("", "0.2.0 (new)")
    assert holds(board, image)


def test_134_baud_through_the_serial_driver_where_usb_does_not_let_us(image):
    board = Teensy(obeys_baud=False).install(program())
    desk = Desk(board)
    desk.touch = lambda port: (desk.touched.append(port), board.press_button())
    assert flash(desk, image).confirmed
    assert desk.touched == ["/dev/ttyACM0"]


def test_board_that_obeys_nothing_waits_for_its_button(image):
    board = Teensy(obeys_baud=False).install(program())
    desk = Desk(board)
    desk.button_at_s = 12
    job = Job()
    notes = []
    job.subscribe(lambda p: notes.append(p.note))
    assert flash(desk, image, job=job).confirmed
    assert (
        "press the button on Teensy 3.2 at USB 1-2.4 (/dev/ttyACM0, serial number 3456780): 30 s"
        in notes
    )
    assert notes[-1] == ""


def test_blank_board_waits_for_its_button(image):
    board = Teensy(mode="off")
    desk = Desk(board)
    desk.button_at_s = 3
    assert flash(desk, image).confirmed


def test_nobody_presses_the_button(image):
    desk = Desk(Teensy(mode="off"))
    with pytest.raises(FlashError, match=r"No bootloader appeared within 30 s") as caught:
        flash(desk, image)
    assert "press its button" in caught.value.hint
    assert desk.time.now == pytest.approx(1030, abs=1)


def test_waiting_for_the_button_can_be_given_up(image):
    job = Job()
    job.subscribe(lambda p: job.cancel() if p.stage == "press_the_button" and p.done > 4 else None)
    with pytest.raises(Cancelled):
        flash(Desk(Teensy(mode="off")), image, job=job)


def test_board_in_its_bootloader(image):
    board = Teensy(mode="bootloader")
    report = flash(Desk(board), image)
    assert report.board["serial_number"] == "3456780"
    assert holds(board, image)


def test_timeouts_are_repeated(image):
    board = Teensy(mode="bootloader", busy=[0, 40, 7, 0, 100, 3, 0, 0, 5])
    report = flash(Desk(board), image)
    assert (report.retries, report.attempts) == (155, 1)
    assert holds(board, image)


def test_stuck_bootloader_is_erased_and_written_again(image):
    board = Teensy(mode="bootloader", busy=[0] * 8 + [40])
    report = flash(Desk(board), image)
    assert (report.attempts, board.erased) == (2, 2)
    assert holds(board, image)


def test_bootloader_that_stays_stuck(image):
    board = Teensy(mode="bootloader", busy=[0] * 8 + [10**9])
    with pytest.raises(
        HalfWrittenError, match=r"did not take the block at 0x0.*within 45 s.*may have lost"
    ):
        flash(Desk(board), image)


def test_patience_with_the_first_writes_is_longer_but_ends(image):
    board = Teensy(mode="bootloader", busy=[1200])
    assert flash(Desk(board), image).confirmed
    desk = Desk(Teensy(mode="bootloader", busy=[10**9]))
    with pytest.raises(HalfWrittenError, match="within 45 s"):
        flash(desk, image)
    assert desk.time.now < 1000 + 2 * 45 + 10


@pytest.mark.parametrize("after", [0, 1, 7, 14])
def test_unplugged_in_the_middle_and_mended(image, after):
    board = Teensy(unplug_before=after).install(OLD)
    desk = Desk(board)
    lost = "has no whole firmware now" if after else "may have lost its firmware"
    with pytest.raises(HalfWrittenError, match=lost) as caught:
        flash(desk, image, "/dev/ttyACM0")
    assert "bootloader is a chip of its own" in caught.value.hint
    assert f"reliefscope flash {image.path}" in caught.value.hint
    board.plug_in()
    assert (board.mode == "off") == (after > 0)
    board.press_button()
    report = flash(desk, image, "/dev/ttyACM0")  # the same command, though the port is gone
    assert report.confirmed
    assert holds(board, image)


def test_interrupt_in_the_middle_says_so(image):
    board = Teensy(mode="bootloader")
    desk = Desk(board)
    job = Job()

    def interrupt(progress):
        if progress.stage == "write" and progress.done == 3:
            raise KeyboardInterrupt

    job.subscribe(interrupt)
    with pytest.raises(HalfWrittenError, match="interrupted"):
        flash(desk, image, job=job)


def test_wish_to_stop_does_not_leave_half_a_board(image):
    board = Teensy(mode="bootloader")
    job = Job()
    job.subscribe(lambda p: job.cancel() if p.stage == "write" and p.done == 3 else None)
    assert flash(Desk(board), image, job=job).confirmed
    with pytest.raises(Cancelled):
        flash(Desk(Teensy()), image, job=job)


def test_wish_to_stop_before_the_first_block_goes_back_to_the_old_firmware(image):
    board = Teensy().install(OLD)
    desk = Desk(board)
    job = Job()
    plain = desk.open_device

    def open_device(port):
        job.cancel()
        return plain(port)

    desk.open_device = open_device
    with pytest.raises(Cancelled):
        flash(desk, image, job=job)
    assert (board.mode, board.writes) == ("serial", [])


def test_other_image_touches_nothing(tmp_path):
    board = Teensy().install(OLD)
    before = bytes(board.flash)
    wrong = FirmwareImage.load(write_image(tmp_path, board="qemu_m4"))
    with pytest.raises(ImageError):
        flash(Desk(board), wrong)
    assert (board.flash, board.mode, board.writes) == (before, "serial", [])


def test_forced_image_without_identity(tmp_path):
    path = tmp_path / "blink.hex"
    path.write_text(intel_hex(program(salt=9)))
    board = Teensy().install(OLD)
    report = flash(Desk(board), FirmwareImage.load(path), force=True)
    assert (report.confirmed, report.after, report.port) == (False, "", "/dev/ttyACM0")
    assert holds(board, FirmwareImage.load(path))


def test_image_that_does_not_come_up(image):
    board = Teensy(mode="bootloader")
    desk = Desk(board)
    board.plug_in = lambda: setattr(board, "mode", "off")
    with pytest.raises(NotConfirmedError, match="did not come back on USB") as caught:
        flash(desk, image)
    assert "doctor" in caught.value.hint


def test_image_that_does_not_answer(image):
    board = Teensy(mode="bootloader", silent=True)
    with pytest.raises(NotConfirmedError, match="does not answer"):
        flash(Desk(board), image)


def test_board_that_runs_something_else_afterwards(image):
    board = Teensy(mode="bootloader")
    desk = Desk(board)
    board.hello = lambda: {
        "board": "teensy31",
        "firmware_version": "0.0.9",
        "git_hash": "new",
        "schema_hash": image.identity.schema_hash,
    }
    with pytest.raises(NotConfirmedError, match=r"version 0\.0\.9 instead of 0\.2\.0"):
        flash(desk, image)


def test_rights_are_missing(image):
    board = Teensy(forbidden=True).install(OLD)
    with pytest.raises(UsbAccessError) as caught:
        flash(Desk(board), image)
    assert "sudo tee /etc/udev/rules.d/" in caught.value.hint
    assert board.mode == "serial"
    board.press_button()
    with pytest.raises(UsbAccessError, match="may not be opened"):
        flash(Desk(board), image)
    assert not board.writes


def test_rights_that_come_a_moment_after_the_device(image):
    board = Teensy(mode="bootloader", forbidden=True)
    desk = Desk(board)
    plain = desk.sleep

    def sleep(seconds):
        plain(seconds)
        board.forbidden = desk.time.now < 1001

    desk.sleep = sleep
    assert flash(desk, image).confirmed


def test_rights_to_the_serial_port_are_missing(image):
    board = Teensy().install(OLD)
    desk = Desk(board)

    def refuse(port):
        raise PortAccessError(f"{port} may not be opened by this user.", hint="udev")

    desk.open_device = refuse
    with pytest.raises(UsbAccessError):
        flash(desk, image)
    assert board.mode == "serial"


def test_sequence_under_way_is_spared(image, monkeypatch):
    board = Teensy().install(program(identity_block()))
    desk = Desk(board)
    plain = FakeDevice.reply
    asked = []

    def reply(self, request):
        asked.append(type(request).__name__)
        answer = plain(self, request)
        if type(answer).__name__ == "StatusReply":
            answer = dataclasses.replace(answer, sequence=SequenceState.RUNNING)
        return answer

    monkeypatch.setattr(FakeDevice, "reply", reply)
    with pytest.raises(FlashError, match=r"sequence is under way on this board \(RUNNING\)"):
        flash(desk, image)
    assert board.mode == "serial"
    assert "AllOffRequest" not in asked
    assert flash(desk, image, force=True).confirmed


def three():
    return [
        Teensy(),
        Teensy(serial=99, port="/dev/ttyACM1", ports=(2, 1)),
        Teensy(serial=100, port="/dev/ttyACM2", ports=(3,)),
    ]


def test_several_boards_are_listed_with_their_commands(image):
    with pytest.raises(FlashError, match="There are 3 boards") as caught:
        flash(Desk(*three()), image)
    assert "reliefscope flash --port /dev/ttyACM1" in caught.value.hint
    assert "serial number 990" in caught.value.hint


@pytest.mark.parametrize("name", ["/dev/ttyACM1", "1-2.1", "990"])
def test_one_of_several_is_named(image, name):
    boards = three()
    assert flash(Desk(*boards), image, name).port == "/dev/ttyACM1"
    assert [bool(b.writes) for b in boards] == [False, True, False]


def test_one_of_several_is_chosen(image):
    flasher = Flasher(Desk(*three()).around())
    assert flasher.select(choose=lambda boards: boards[-1]).port == "/dev/ttyACM2"


def test_link_to_a_port_names_it(tmp_path, image):
    port = tmp_path / "ttyACM7"
    port.touch()
    (tmp_path / "by-id").symlink_to(port)
    flasher = Flasher(Desk(*three(), Teensy(port=str(port), ports=(4,), serial=7)).around())
    assert flasher.select(str(tmp_path / "by-id")).port == str(port)


def test_names_that_are_no_board(image):
    flasher = Flasher(Desk(*three()).around())
    with pytest.raises(FlashError, match=r"No Teensy is at /dev/ttyUSB0") as caught:
        flasher.select("/dev/ttyUSB0")
    assert "/dev/ttyACM2" in caught.value.hint
    with pytest.raises(FlashError, match="not a board on USB"):
        flasher.select("sim://benchtop")
    assert Flasher(Desk().around()).select() is None


def test_other_models_are_refused(image):
    with pytest.raises(FlashError, match=r"This board is a Teensy LC"):
        flash(Desk(Teensy(release=0x273)), image)
    board = Teensy(mode="bootloader", usage=0x24)
    with pytest.raises(FlashError, match=r"This board is a Teensy 4\.0"):
        flash(Desk(board), image)
    assert not board.writes
    assert flash(Desk(Teensy(mode="bootloader", usage=0x1E)), image).confirmed


def test_boards_without_rights_are_listed_all_the_same():
    (board,) = Flasher(Desk(Teensy(forbidden=True)).around()).boards()
    assert (board.location, board.port, board.model) == ("1-2.4", "/dev/ttyACM0", "Teensy 3.2")
    assert board.serial_number == "3456780"  # the serial driver knows it
