"""Other software reads a run without ours."""

import hashlib
import json
from pathlib import Path

import numpy as np
import ome_types
import pytest
import yaozarrs
import zarr
from tests.dataset.helpers import make_run, pixels


def test_zarr_alone_reads_every_frame(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    root = zarr.open_group(str(run.path), mode="r")
    assert dict(root.attrs)["ome"] == {"version": "0.5", "bioformats2raw.layout": 3}
    series = dict(root["OME"].attrs)["ome"]["series"]
    assert series == ["0", "1", "2", "3", "4", "5"]  # three views, centre, dark, leakage
    for key, request in run.layout.requests.items():
        image, channel = run.layout.places[key]
        frame = root[f"{image}/0"][channel]
        np.testing.assert_array_equal(frame, pixels(request, run.spec))
    array = root["0/0"]
    assert array.chunks == (1, *run.shape)
    metadata = json.loads((run.path / "0" / "0" / "zarr.json").read_text())
    assert [codec["name"] for codec in metadata["codecs"]] == ["bytes", "crc32c"]
    assert metadata["dimension_names"] == ["c", "y", "x"]


def test_journal_hashes_are_over_little_endian_pixels(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    for line in (run.path / "journal.jsonl").read_text().splitlines():
        entry = json.loads(line)
        image, channel = run.layout.places[entry["kind"], entry["view"], entry["light"]]
        chunk = (run.path / str(image) / "0" / "c" / str(channel) / "0" / "0").read_bytes()
        assert hashlib.sha256(chunk[:-4]).hexdigest() == entry["sha256"]  # 4 bytes of CRC-32C


def test_images_are_valid_ngff(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    for group in [run.path, *(run.path / str(image.index) for image in run.layout.images)]:
        yaozarrs.validate_zarr_store(str(group))


def test_ome_xml_is_valid(tmp_path: Path) -> None:
    run = make_run(tmp_path / "run")
    ome = ome_types.from_xml(run.path / "OME" / "METADATA.ome.xml")
    assert [image.name for image in ome.images] == [
        "disc-00",
        "disc-01",
        "disc-02",
        "centre",
        "dark",
        "leakage",
    ]
    first = ome.images[0].pixels
    assert (first.size_x, first.size_y, first.size_c) == (32, 24, 2)
    assert first.physical_size_x == pytest.approx(run.pixel_um)
    assert first.physical_size_x_unit.value == "µm"
    assert first.type.value == "uint16"
    assert [channel.name for channel in first.channels] == ["led-00", "led-01"]
