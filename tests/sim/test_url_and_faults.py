"""Addresses of simulated instruments, and the grammar of faults."""

import pytest
from tests.support import REPOSITORY

from reliefscope.errors import InvalidInputError
from reliefscope_sim.display import Mounting
from reliefscope_sim.faults import KNOWN, Faults, FaultyWire, Place
from reliefscope_sim.flaws import FlawLevels
from reliefscope_sim.url import KEYS, SimUrl


def test_name_gives_its_profile():
    assert SimUrl.parse("sim://miniature").load_profile().name == "miniature"
    assert SimUrl.parse("sim://left-bench").load_profile().name == "benchtop"
    assert SimUrl.parse("sim://benchtop-2").load_profile().name == "benchtop"
    assert SimUrl.parse("sim://bencht0p?profile=miniature").load_profile().name == "miniature"
    assert SimUrl.parse("sim://left?profile=miniature").load_profile().name == "miniature"


def test_every_option():
    url = SimUrl.parse(
        "sim://benchtop?scene=plane&scene.tilt_deg=10&finish=dull&seed=5&as_built=9&size=96x72"
        "&time=real&glass=E&mounting=top_view&fault=camera_drop:3&fault=link_loss:0.5"
        "&calibration=nominal&profile=benchtop&contrast=12&temperature=-5&led_droop=0.05&bits=8"
        "&stage_um=-12.5&simulant=ds1&file=ground.x3p&shading=0.1&dust=8&dust_px=12.5&hot_pixels=0"
    )
    assert {key for key, _ in url.given} - {"scene.tilt_deg"} == set(KEYS) - {"replay"}
    assert (url.scene, url.seed, url.as_built, url.size) == ("plane", 5, 9, (96, 72))
    assert dict(url.scene_options) == {
        "tilt_deg": "10",
        "finish": "dull",
        "simulant": "ds1",
        "file": "ground.x3p",
    }
    assert (url.time, url.mounting) == ("real", Mounting.TOP_VIEW)
    assert url.faults == Faults(
        rates={"link_loss": 0.5}, places={"camera_drop": Place(frozenset({3}))}
    )
    profile = url.load_profile()
    assert profile.shape == (72, 96)
    assert profile.glass.variant == "E"
    assert (profile.glass.contrast_ratio, profile.camera.bit_depth) == (12, 8)
    assert (url.temperature_c, url.led_droop, url.stage_um) == (-5, 0.05, -12.5)
    assert url.flaws == FlawLevels(shading=0.1, dust=8, dust_px=12.5, hot_pixels=0)


def test_positive_glass_has_less_contrast_than_negative():
    ratios = {v: SimUrl.parse(f"sim://benchtop?glass={v}").load_profile().glass for v in "ES"}
    assert (ratios["E"].contrast_ratio, ratios["S"].contrast_ratio) == (10, 15)


@pytest.mark.parametrize(
    ("url", "named"),
    [
        ("sim://", "address"),
        ("sim://a b", "address"),
        ("sim://benchtop/path", "address"),
        ("sim://bencht0p", "there are benchtop and miniature"),
        ("sim://minature?size=96x72", "did you mean `sim://miniature`"),
        ("socket://benchtop", "address"),
        ("sim://benchtop?sead=1", "did you mean `seed`"),
        ("sim://benchtop?seed=x", "seed"),
        ("sim://benchtop?seed=1&seed=2", "twice"),
        ("sim://benchtop?size=96", "96x72|COLUMNSxROWS"),
        ("sim://benchtop?time=slow", "virtual, real"),
        ("sim://benchtop?glass=W", "E, S"),
        ("sim://benchtop?mounting=side", "bottom_view, top_view"),
        ("sim://benchtop?fault=gremlin:1", "link_loss"),
        ("sim://benchtop?fault=link_los:0.1", "did you mean `link_loss`"),
        ("sim://benchtop?fault=link_loss:2", "probability"),
        ("sim://benchtop?fault=link_loss", "NUMBER"),
        ("sim://benchtop?fault=camera_drop:1.5", "whole number"),
        ("sim://benchtop?fault=camera_drop:-1", "NUMBER"),
        ("sim://benchtop?fault=camera_drop:120%", "more than 1"),
        ("sim://benchtop?fault=disk_full:3", "made by the system"),
        ("sim://benchtop?temperature=90", "from -30 to 70"),
        ("sim://benchtop?contrast=x", "from 1.1"),
        ("sim://benchtop?replay=/nowhere/run.bundle.zip", "no recording"),
        ("sim://replay=/nowhere/run.bundle.zip", "no recording"),
        ("sim://benchtop?bits=9", "8, 10, 12"),
    ],
)
def test_wrong_addresses_are_refused_with_advice(url, named):
    with pytest.raises(InvalidInputError, match=f"(?i){named}"):
        SimUrl.parse(url)


@pytest.mark.parametrize("size", ["8x8", "4000x72", "97x72"])
def test_impossible_sizes_are_refused(size):
    with pytest.raises(InvalidInputError, match=r"even|size from"):
        SimUrl.parse(f"sim://benchtop?size={size}").load_profile()


def test_addresses_agree_by_meaning():
    first = SimUrl.parse("sim://benchtop?size=96x72&scene.a=1&finish=dull")
    first.check_agrees(SimUrl.parse("sim://benchtop"))
    first.check_agrees(SimUrl.parse("sim://benchtop?seed=1&scene=fiducial&finish=dull&scene.a=1"))
    for other in ("seed=2", "size=96x64", "scene.a=2", "finish=half", "fault=camera_drop:1"):
        with pytest.raises(InvalidInputError, match="already in use"):
            first.check_agrees(SimUrl.parse(f"sim://benchtop?{other}"))


def test_every_documented_fault_is_understood():
    for name in KNOWN:
        assert Faults.parse(f"{name}:1") != Faults()


def test_a_rate_of_exposures_is_drawn_from_seed_and_place_alone():
    faults = Faults.parse("camera_drop:20%,camera_drop:7", seed=3)
    struck = [number for number in range(5000) if faults.strikes("camera_drop", number)]
    assert 7 in struck
    assert len(struck) / 5000 == pytest.approx(0.2, abs=0.02)
    again = Faults.parse("camera_drop:20%,camera_late:1", seed=3)
    assert [n for n in range(5000) if again.strikes("camera_drop", n) or n == 7] == struck
    other = Faults.parse("camera_drop:20%", seed=4)
    assert [n for n in range(5000) if other.strikes("camera_drop", n)] != struck
    assert not faults.strikes("camera_late", 7)


FRAMES = [bytes([1 + n % 250, 2, 3, 4, 5, 0]) for n in range(2000)]


def carried(text, seed="s", delays=True):
    wire = FaultyWire(Faults.parse(text), seed, delays=delays)
    return [item for n, frame in enumerate(FRAMES) for item in wire.feed(10 * n, frame)]


def test_sound_wire_changes_nothing():
    assert carried("") == [(10 * n, frame) for n, frame in enumerate(FRAMES)]


def test_lost_frames_are_whole_and_as_many_as_asked_for():
    arrived = [data for _, data in carried("link_loss:0.2")]
    assert set(arrived) <= set(FRAMES)
    assert len(arrived) / len(FRAMES) == pytest.approx(0.8, abs=0.04)


def test_flips_change_one_bit_of_as_many_bytes_as_asked_for():
    sent, got = b"".join(FRAMES), b"".join(data for _, data in carried("link_flip:0.05"))
    changed = [a ^ b for a, b in zip(sent, got, strict=True) if a != b]
    assert len(changed) / len(sent) == pytest.approx(0.05, abs=0.01)
    assert all(bits.bit_count() == 1 for bits in changed)


def test_drops_and_duplicates_change_the_length():
    length = len(b"".join(FRAMES))
    dropped = sum(len(data) for _, data in carried("link_drop:0.1"))
    doubled = sum(len(data) for _, data in carried("link_duplicate:0.1"))
    assert dropped / length == pytest.approx(0.9, abs=0.02)
    assert doubled / length == pytest.approx(1.1, abs=0.02)


def test_delays_keep_the_order():
    arrivals = carried("link_delay:5")
    times = [time for time, _ in arrivals]
    assert times == sorted(times)
    assert [data for _, data in arrivals] == FRAMES
    assert max(time - 10 * n for n, time in enumerate(times)) > 1000


def test_faults_come_from_the_seed():
    text = "link_loss:0.1,link_flip:0.01,link_delay:3"
    assert carried(text) == carried(text)
    assert carried(text) != carried(text, seed="t")


@pytest.mark.parametrize("fault", ["link_loss_at", "link_flip_at", "link_duplicate_at"])
def test_a_placed_fault_hits_the_next_frame_and_no_other(fault):
    wire = FaultyWire(Faults.parse(f"{fault}:4"), "s", delays=True)
    wire.strike(3)
    sound = wire.feed(0, FRAMES[0])
    wire.strike(4)
    delimiter = wire.feed(1, b"\0")
    struck = b"".join(data for _, data in wire.feed(2, FRAMES[1][:2]) + wire.feed(3, FRAMES[1][2:]))
    assert (sound, delimiter) == ([(0, FRAMES[0])], [(1, b"\0")])
    if fault == "link_flip_at":
        changed = [a ^ b for a, b in zip(struck, FRAMES[1], strict=True) if a != b]
        assert [bits.bit_count() for bits in changed] == [1]
    else:
        assert struck == (b"" if fault == "link_loss_at" else 2 * FRAMES[1])
    assert wire.feed(4, FRAMES[2]) == [(4, FRAMES[2])]


def test_a_frame_in_pieces_is_lost_as_a_whole():
    whole, pieces = (FaultyWire(Faults.parse("link_loss:0.3"), "s", delays=True) for _ in "ab")
    for frame in FRAMES[:200]:
        first = b"".join(data for _, data in whole.feed(0, frame))
        second = b"".join(d for byte in frame for _, d in pieces.feed(0, bytes([byte])))
        assert first == second


def test_the_reference_page_lists_every_option_and_fault():
    page = (REPOSITORY / "docs" / "reference" / "simulated-instrument.md").read_text("utf-8")
    for name in [*KEYS, *KNOWN]:
        assert f"| `{name}` |" in page, name


def test_serial_numbers_tell_twins_apart():
    url = SimUrl.parse("sim://benchtop?seed=4&scene=cone&as_built=3")
    same = SimUrl.parse("sim://benchtop?seed=4&scene=cone&as_built=3&fault=camera_drop:3")
    assert (same.device_serial, same.camera_serial) == (url.device_serial, url.camera_serial)
    assert len(url.device_serial) <= 16
    for change in (
        "seed=5&scene=cone",
        "seed=4&scene=flat",
        "seed=4&scene=cone&finish=dull",
        "seed=4&scene=cone&stage_um=10",
    ):
        other = SimUrl.parse(f"sim://benchtop?as_built=3&{change}")
        # a calibration belongs to the instrument, whatever lies under it
        assert other.device_serial == url.device_serial
        assert other.camera_serial != url.camera_serial
    departed = SimUrl.parse("sim://benchtop?seed=4&scene=cone&as_built=4")
    assert departed.device_serial != url.device_serial
