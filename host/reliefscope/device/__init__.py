"""The link to the device and a client with one method for each thing it can do.

with Device.open("sim://benchtop") as device:
    print(device.identity.board, device.status().sequence)
"""

from reliefscope.device.client import Device
from reliefscope.device.errors import (
    DeviceNotFoundError,
    DeviceRebootedError,
    DeviceTimeout,
    FailedError,
    LinkLostError,
    OutcomeUnknownError,
    PortAccessError,
    RefusedError,
    RejectedError,
    SchemaMismatchError,
)
from reliefscope.device.health import LinkHealth, measure_link
from reliefscope.device.link import Deadline, Link
from reliefscope.device.ports import PortInfo, list_ports
from reliefscope.device.sequence import SequenceTiming, sequence_duration_s
from reliefscope.protocol.messages import (
    ExposureEvent,
    FaultEvent,
    SequenceEvent,
    SequenceNews,
    SequenceState,
    Step,
)

__all__ = [
    "Deadline",
    "Device",
    "DeviceNotFoundError",
    "DeviceRebootedError",
    "DeviceTimeout",
    "ExposureEvent",
    "FailedError",
    "FaultEvent",
    "Link",
    "LinkHealth",
    "LinkLostError",
    "OutcomeUnknownError",
    "PortAccessError",
    "PortInfo",
    "RefusedError",
    "RejectedError",
    "SchemaMismatchError",
    "SequenceEvent",
    "SequenceNews",
    "SequenceState",
    "SequenceTiming",
    "Step",
    "list_ports",
    "measure_link",
    "sequence_duration_s",
]
