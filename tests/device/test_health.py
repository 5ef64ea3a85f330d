"""The test of a link: its figures must be those of the link."""

import itertools

import numpy as np
import pytest

from reliefscope.device import Device, SequenceTiming, Step, measure_link
from reliefscope.errors import DeviceError
from reliefscope.jobs import Job

_names = itertools.count()


def open_twin(fault="", time="virtual"):
    return Device.open(f"sim://health-{next(_names)}?size=64x48&time={time}&fault={fault}", 10.0)


def test_good_link():
    with open_twin() as device:
        health = measure_link(device, requests=40, uploads=4)
        assert device.status().sequence.name == "IDLE"
    assert (health.unanswered, health.retries, health.refused) == (0, 0, 0)
    assert (health.lost_to_device, health.lost_to_host) == (0, 0)
    assert (health.damaged_to_device, health.damaged_to_host) == (0, 0)
    # 40 status, 4 x (4 chunks + commit), 2 status around them, 1 of the two counters
    assert health.host["frames_sent"] == health.device["frames_received"] == 40 + 20 + 2 + 1
    assert health.host["frames_received"] == health.device["frames_sent"]
    assert "first attempt" in health.verdict
    trip = health.round_trip_ms
    assert 0 < trip["min"] <= trip["p50"] <= trip["p99"] <= trip["max"] < 1000
    assert health.requests_per_s == pytest.approx(1000 / trip["p50"], rel=0.9)
    assert health.as_dict()["verdict"] == health.verdict


def test_lossy_link_is_told_from_a_damaging_one():
    with open_twin("link_loss:0.1") as device:
        lossy = measure_link(device, requests=150, uploads=4)
    assert lossy.unanswered == 0
    assert lossy.lost_to_device > 3
    assert lossy.lost_to_host > 3
    assert lossy.damaged_to_device == lossy.damaged_to_host == 0
    # every retry is owed to one lost frame
    assert lossy.retries == pytest.approx(lossy.lost_to_device + lossy.lost_to_host, abs=3)
    assert "retries were needed" in lossy.verdict
    with open_twin("link_flip:0.002") as device:
        flipping = measure_link(device, requests=150, uploads=4)
    assert flipping.damaged_to_device > 3
    assert flipping.damaged_to_host > 3


def test_virtual_time_is_told():
    with open_twin() as device:
        assert measure_link(device, requests=20, uploads=1).is_virtual_time


def test_sequence_under_way_is_not_disturbed():
    with open_twin() as device:
        device.load_aperture(0, np.ones((64, 128), bool))
        device.load_light(0, [100])
        device.load_steps([Step(0, 0, 5, 500_000, 10_000)])
        device.start(1, timing=SequenceTiming(ready_timeout_ms=0))
        with pytest.raises(DeviceError, match="under way"):
            measure_link(device)


def test_progress_is_told():
    seen = []
    with open_twin() as device:
        measure_link(device, requests=3, uploads=2, job=Job(seen.append))
    assert [p.stage for p in seen if p.finished] == ["round_trips", "uploads"]
