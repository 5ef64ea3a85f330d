"""What comes with an instrument: profile and calibration."""

import numpy as np
import pytest

from reliefscope.models.calibration import Calibration
from reliefscope_sim.offer import describe
from reliefscope_sim.url import SimUrl


def test_nominal_instrument_comes_with_its_designed_numbers():
    offer = describe("sim://miniature?size=96x72")
    assert offer.profile.name == "miniature"
    assert offer.profile.shape == (72, 96)
    nominal = Calibration.nominal(offer.profile)
    assert offer.calibration == nominal.model_copy(update={"source": offer.calibration.source})
    assert offer.calibration.source == "factory"


def test_factory_calibration_knows_the_departures():
    url = SimUrl.parse("sim://benchtop?as_built=7")
    offer = describe("sim://benchtop?as_built=7")
    built = url.load_as_built(offer.profile)
    assert offer.calibration.pupil_scale == built.pupil_scale != 1.0
    np.testing.assert_array_equal(offer.calibration.led_positions_mm, built.led_positions_mm)


def test_without_calibration_the_departures_stay_hidden():
    offer = describe("sim://benchtop?as_built=7&calibration=nominal")
    assert offer.calibration == Calibration.nominal(offer.profile)
    assert offer.calibration.source == "nominal"
    assert offer.calibration.pupil_scale == pytest.approx(1.0)
