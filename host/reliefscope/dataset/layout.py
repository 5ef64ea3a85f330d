"""How a run lies in OME-Zarr 0.5.

NGFF allows no axes view and light side by side, so each view is an image of its own with the lights as
channels (``c``), and the centre view, the dark frame and the leakage frames are further images.  The groups
are named ``0``, ``1``, ... and listed in ``OME`` (the bioformats2raw layout), which is what readers look for.
One chunk is one frame, with a CRC-32C.
"""

from __future__ import annotations

import uuid
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import zarr
from zarr.codecs import Crc32cCodec

from reliefscope.dataset.durable import DurableStore, write_file
from reliefscope.dataset.records import FrameKey, key_of
from reliefscope.dataset.spec import RunSpec
from reliefscope.models.plan import FrameKind, FrameRequest

NGFF_VERSION = "0.5"
OME_NAMESPACE = "http://www.openmicroscopy.org/Schemas/OME/2016-06"
_OME_SCHEMA = f"{OME_NAMESPACE} {OME_NAMESPACE}/ome.xsd"
XSI_NAMESPACE = "http://www.w3.org/2001/XMLSchema-instance"


@dataclass(frozen=True)
class ImageGroup:
    """One image of the run: a stack of frames that share an aperture."""

    index: int
    kind: FrameKind
    name: str
    channels: tuple[str, ...]
    accumulate: int


class Layout:
    """Place of every planned image: group and channel."""

    def __init__(self, spec: RunSpec) -> None:
        self.spec = spec
        self.places: dict[FrameKey, tuple[int, int]] = {}
        self.requests: dict[FrameKey, FrameRequest] = {}
        members: dict[tuple[FrameKind, int | None], list[FrameRequest]] = {
            ("view", view): [] for view in range(len(spec.view_names))
        }
        for kind in ("centre", "dark", "leakage"):
            members[kind, None] = []
        for request in spec.requests():
            members[request.kind, request.view].append(request)
            self.requests[key_of(request)] = request
        self.images: list[ImageGroup] = []
        for (kind, view), requests in members.items():
            if not requests:
                continue
            index = len(self.images)
            name = spec.view_names[view] if view is not None else kind
            channels = tuple(_channel_name(spec, request) for request in requests)
            self.images.append(ImageGroup(index, kind, name, channels, requests[0].accumulate))
            for channel, request in enumerate(requests):
                self.places[key_of(request)] = (index, channel)

    def array_path(self, image: int) -> str:
        """Path of an image's only resolution level within the root group."""
        return f"{image}/0"

    def chunk_path(self, key: FrameKey) -> Path:
        """Path of a frame's chunk within the run's folder."""
        image, channel = self.places[key]
        return Path(str(image), "0", "c", str(channel), "0", "0")

    def dtype(self, image: ImageGroup) -> str:
        """Stored type of an image."""
        return self.spec.frame.dtype(image.accumulate)

    def create(self, folder: Path) -> None:
        """Write all metadata durably."""
        rows, columns = self.spec.frame.shape
        store = DurableStore(folder)
        root = zarr.create_group(
            store,
            zarr_format=3,
            attributes={"ome": {"version": NGFF_VERSION, "bioformats2raw.layout": 3}},
        )
        series: list[Any] = [str(image.index) for image in self.images]
        root.create_group("OME", attributes={"ome": {"version": NGFF_VERSION, "series": series}})
        for image in self.images:
            group = root.create_group(str(image.index), attributes=self._attributes(image))
            group.create_array(
                "0",
                shape=(len(image.channels), rows, columns),
                chunks=(1, rows, columns),
                dtype=self.dtype(image),
                compressors=[Crc32cCodec()],
                dimension_names=["c", "y", "x"],
                fill_value=0,
            )
        write_file(folder / "OME" / "METADATA.ome.xml", self.ome_xml())

    def _attributes(self, image: ImageGroup) -> dict[str, Any]:
        top = self.spec.frame.full_scale * image.accumulate
        pixel_um = self.spec.pixel_um
        return {
            "ome": {
                "version": NGFF_VERSION,
                "multiscales": [
                    {
                        "name": image.name,
                        "axes": [
                            {"name": "c", "type": "channel"},
                            {"name": "y", "type": "space", "unit": "micrometer"},
                            {"name": "x", "type": "space", "unit": "micrometer"},
                        ],
                        "datasets": [
                            {
                                "path": "0",
                                "coordinateTransformations": [
                                    {"type": "scale", "scale": [1.0, pixel_um, pixel_um]}
                                ],
                            }
                        ],
                    }
                ],
                "omero": {
                    "channels": [
                        {
                            "label": channel,
                            "color": "FFFFFF",
                            "active": index == 0,
                            "window": {"min": 0, "max": top, "start": 0, "end": top},
                        }
                        for index, channel in enumerate(image.channels)
                    ]
                },
            },
            "reliefscope": {
                "kind": image.kind,
                "sensor": self.spec.frame.sensor,
                "accumulated": image.accumulate,
            },
        }

    def ome_xml(self) -> bytes:
        """``METADATA.ome.xml``: one Image per group, one Channel per light."""
        ET.register_namespace("", OME_NAMESPACE)
        ET.register_namespace("xsi", XSI_NAMESPACE)
        rows, columns = self.spec.frame.shape
        root = ET.Element(
            f"{{{OME_NAMESPACE}}}OME",
            {
                f"{{{XSI_NAMESPACE}}}schemaLocation": _OME_SCHEMA,
                "Creator": self.spec.software,
                "UUID": uuid.uuid4().urn,
            },
        )
        for image in self.images:
            element = _sub(root, "Image", ID=f"Image:{image.index}", Name=image.name)
            pixels = _sub(
                element,
                "Pixels",
                ID=f"Pixels:{image.index}",
                DimensionOrder="XYZCT",
                Type=self.dtype(image),
                SizeX=str(columns),
                SizeY=str(rows),
                SizeZ="1",
                SizeC=str(len(image.channels)),
                SizeT="1",
                PhysicalSizeX=repr(self.spec.pixel_um),
                PhysicalSizeXUnit="µm",
                PhysicalSizeY=repr(self.spec.pixel_um),
                PhysicalSizeYUnit="µm",
            )
            for channel, name in enumerate(image.channels):
                identity = f"Channel:{image.index}:{channel}"
                _sub(pixels, "Channel", ID=identity, Name=name, SamplesPerPixel="1")
            _sub(pixels, "MetadataOnly")
        document: bytes = ET.tostring(root, encoding="UTF-8", xml_declaration=True)
        return document


def _sub(parent: ET.Element, tag: str, **attributes: str) -> ET.Element:
    return ET.SubElement(parent, f"{{{OME_NAMESPACE}}}{tag}", attributes)


def _channel_name(spec: RunSpec, request: FrameRequest) -> str:
    if request.light is not None:
        return spec.light_names[request.light]
    if request.kind == "centre" and spec.plan is not None and spec.plan.centre_light is not None:
        return spec.plan.centre_light.name
    return request.kind
