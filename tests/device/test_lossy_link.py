"""Commands over a bad link: each executed at most once, none silently wrong, nearly all finished.

What was executed is taken from the compiled firmware: what it wrote to the non-volatile memory and to the glass, and
its counters.
"""

from dataclasses import dataclass

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.device.lossy import LossyPort, Weather

from reliefscope.device import Device, FailedError, Link, OutcomeUnknownError
from reliefscope.protocol import messages as m

EVERY_FAILING = 5
"""Every so many commands one asks for what cannot be done; a failure is executed once, too."""
EMPTY_SLOT = 9


@dataclass
class Campaign:
    """How the commands ended, by number."""

    finished: set
    unknown: set
    failing: set
    device: Device
    port: LossyPort

    @property
    def finished_share(self):
        return len(self.finished) / (len(self.finished) + len(self.unknown))


def settings_for(number):
    return m.SetSettingsRequest(
        f"N{number}",
        m.GlassVariant(number % 3),
        m.Mounting(number % 2),
        number % 64,
        number % 8,
    )


def run(weather, seed, count):
    port = LossyPort(seed)
    device = Device(Link(port, "lossy"), "lossy")
    port.set_weather(weather)
    ended = Campaign(set(), set(), set(), device, port)
    for number in range(count):
        fails = number % EVERY_FAILING == EVERY_FAILING - 1
        if fails:
            ended.failing.add(number)
        try:
            if fails:
                with pytest.raises(FailedError) as caught:
                    device.select_light(EMPTY_SLOT)
                assert (caught.value.code, caught.value.detail) == (
                    m.ErrorCode.SLOT_EMPTY,
                    EMPTY_SLOT,
                )
            else:
                wanted = settings_for(number)
                reply = device.store_settings(wanted)
                assert reply.pack() == wanted.pack(), "silently wrong"
        except OutcomeUnknownError:
            ended.unknown.add(number)
        else:
            ended.finished.add(number)
    port.let_pass(7.0)  # what is still under way must not be executed a second time either
    return ended


def check(ended):
    stored = ended.port.executed()
    assert [generation for generation, _ in stored] == list(range(1, len(stored) + 1))
    numbers = [int(serial[1:]) for _, serial in stored]
    assert len(numbers) == len(set(numbers)), "executed more than once"
    assert numbers == sorted(numbers), "executed out of order"
    storing = ended.finished - ended.failing
    assert storing <= set(numbers), "finished, but never executed"
    assert set(numbers) <= storing | ended.unknown
    assert 0 < ended.port.log.set_ups <= len(stored), "executed more than once"
    # Every whole frame that the device received was executed, answered from the ring, or rejected.
    ended.port.set_weather(Weather())
    on_device, on_host = ended.device.counters(), ended.device.link_counters
    ended.device.close()
    executions = on_device.frames_received - on_device.retries_answered - on_device.rejected
    answered = on_host["frames_sent"] - on_host.get("retries", 0)
    assert answered <= executions <= answered + len(ended.unknown)
    assert len(ended.finished & ended.failing) <= on_device.failed <= len(ended.failing)


@pytest.mark.parametrize(
    ("rate", "byte_rate", "least"),
    [
        (0.0, 0.0, 1.0),
        (0.001, 0.001, 0.999),
        (0.01, 0.0, 0.999),
        (0.05, 0.0, 0.999),
        (0.0, 0.01, 0.999),
        (0.2, 0.0, 0.95),
        (0.2, 0.01, 0.95),
    ],
)
def test_commands_over_a_bad_link(rate, byte_rate, least):
    ended = run(Weather.all_at(rate, byte_rate), seed=1, count=400)
    assert ended.finished_share >= least
    retries = ended.device.link_counters.get("retries", 0)
    if max(rate, byte_rate) == 0:
        assert (ended.port.mishaps, retries) == (0, 0)
    elif max(rate, byte_rate) >= 0.01:
        assert min(ended.port.mishaps, retries) > 0
    check(ended)


rates = st.floats(0, 0.3)


@settings(max_examples=25, deadline=None)
@given(
    weather=st.builds(
        Weather,
        lose=rates,
        corrupt=rates,
        duplicate=rates,
        delay=rates,
        byte_loss=st.floats(0, 0.01),
        byte_flip=st.floats(0, 0.01),
    ),
    seed=st.integers(0, 1 << 32),
)
def test_no_weather_makes_a_command_run_twice(weather, seed):
    check(run(weather, seed, count=25))


def test_unknown_means_unknown():
    """A link that is dead one way: the host cannot tell, and says so; the device acted once."""
    port = LossyPort(1)
    device = Device(Link(port, "lossy"), "lossy")
    port.up.weather = Weather(lose=1.0)
    with pytest.raises(OutcomeUnknownError, match="may or may not have acted"):
        device.store_settings(settings_for(1))
    port.up.weather = Weather()
    assert [serial for _, serial in port.executed()] == ["N1"]
    port.down.weather = Weather(lose=1.0)
    with pytest.raises(OutcomeUnknownError):
        device.store_settings(settings_for(2))
    port.down.weather = Weather()
    assert device.settings().serial_number == "N1"
    assert len(port.executed()) == 1
    device.close()


@pytest.mark.soak
@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("byte_rate", [0.0, 0.001, 0.01])
@pytest.mark.parametrize(
    ("rate", "least"), [(0.001, 0.999), (0.01, 0.999), (0.05, 0.999), (0.2, 0.95)]
)
def test_two_thousand_commands(rate, least, byte_rate, seed):
    ended = run(Weather.all_at(rate, byte_rate), seed, count=2000)
    assert ended.finished_share >= least
    check(ended)
