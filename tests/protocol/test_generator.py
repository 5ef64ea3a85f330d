"""The generator: its output is up to date, and what is wrong in protocol.yml is said clearly."""

import copy
import re

import pytest
import yaml
from protocol.generator.__main__ import main
from protocol.generator.render import generate
from protocol.generator.schema import SchemaError, load
from protocol.generator.vectors import crc32, stuff
from tests.support import REPOSITORY

DEFINITION = REPOSITORY / "protocol" / "protocol.yml"


@pytest.fixture(scope="module")
def original():
    return yaml.safe_load(DEFINITION.read_text())


@pytest.fixture
def changed(tmp_path, original):
    """Load the definition after a change."""

    def load_changed(change):
        content = copy.deepcopy(original)
        change(content)
        path = tmp_path / "protocol.yml"
        path.write_text(yaml.safe_dump(content, sort_keys=False))
        return load(path)

    return load_changed


def exchange(content, name):
    return next(e for e in content["exchanges"] if e["name"] == name)


def test_generated_files_are_up_to_date(capsys):
    assert main(["--check"]) == 0, capsys.readouterr().err


def test_check_fails_on_a_difference_and_writes_nothing(tmp_path, capsys):
    assert main([], root=tmp_path) == 0
    assert main(["--check"], root=tmp_path) == 0
    header = tmp_path / "firmware/core/generated/protocol.hpp"
    header.write_text("edited by hand")
    assert main(["--check"], root=tmp_path) == 1
    assert "protocol.hpp differs" in capsys.readouterr().err
    assert header.read_text() == "edited by hand"


def test_hash_covers_what_is_on_the_wire_only(changed):
    same = load(DEFINITION).hash

    def describe(content):
        exchange(content, "hello")["description"] = "Another text."
        content["enums"]["ErrorCode"]["values"]["BUSY"]["cause"] = "Another cause."

    def widen(content):
        exchange(content, "select_light")["request"][0]["max"] = 30

    def unit(content):
        exchange(content, "start")["request"][3]["unit"] = "ms"

    def member(content):
        content["enums"]["ResetCause"]["values"]["PIN"]["value"] = 9

    assert changed(describe).hash == same
    assert len({same, changed(widen).hash, changed(unit).hash, changed(member).hash}) == 4


@pytest.mark.parametrize(
    ("change", "text"),
    [
        (
            lambda c: exchange(c, "status").update(id=1),
            "message id 1 is given twice: by hello_request",
        ),
        (
            lambda c: exchange(c, "status").update(name="hello"),
            "message name 'hello_request' is given",
        ),
        (lambda c: exchange(c, "start").update(extra=1), r"exchanges\.\d+\.extra: Extra inputs"),
        (
            lambda c: exchange(c, "status").update(id=0x80),
            r"exchanges\.\d+\.id: .*less than or equal to 63",
        ),
        (
            lambda c: exchange(c, "start")["request"][0].update(type="u24"),
            r"start_request\.run_id: unknown type 'u24'; known are u8, u16",
        ),
        (
            lambda c: exchange(c, "start")["request"][0].update(type="u32[", min=None),
            r"start_request\.run_id: cannot read type",
        ),
        (
            lambda c: exchange(c, "select_light")["request"][0].update(max=256),
            r"select_light_request\.slot: min and max must be ordered and fit u8",
        ),
        (
            lambda c: exchange(c, "select_light")["request"][0].update(max="SLOTS-1"),
            "'SLOTS-1' is neither a number nor a constant",
        ),
        (
            lambda c: c["enums"]["FaultReason"]["values"]["INTERNAL"].update(cause=""),
            "FaultReason.INTERNAL: an error needs a cause",
        ),
        (
            lambda c: c["enums"]["Capability"]["values"]["READY"].update(value=3),
            "3 is not a single bit",
        ),
        (
            lambda c: c["enums"]["Mounting"]["values"]["TOP_VIEW"].update(value=256),
            "256 does not fit u8",
        ),
        (lambda c: c["enums"]["Mounting"]["values"]["TOP_VIEW"].update(value=0), "given twice"),
        (lambda c: c["structs"].pop("Header"), "Header is missing"),
        (lambda c: c["events"][0]["fields"].append(c["events"][0]["fields"][0]), "given twice"),
    ],
)
def test_mistakes_are_named(changed, change, text):
    with pytest.raises(SchemaError, match=text):
        changed(change)


def test_broken_yaml_is_named(tmp_path):
    path = tmp_path / "protocol.yml"
    path.write_text("protocol: [")
    with pytest.raises(SchemaError, match=r"protocol\.yml is not YAML"):
        load(path)


def test_reference_documents_every_field():
    schema = load(DEFINITION)
    text = generate(schema)["docs/reference/protocol.md"]
    for message in schema.messages:
        section = text.split(f"### `{message.name}`")[1].split("\n### ")[0]
        for field in message.fields:
            assert re.search(
                rf"^\| {field.name} \| {re.escape(field.type_text)} ", section, re.MULTILINE
            )
    for name in schema.enums["ErrorCode"].values:
        assert f"| {name} |" in text


def test_plain_definitions_of_the_vectors():
    assert crc32(b"123456789") == 0xCBF43926  # the check value of CRC-32 in every catalogue
    assert stuff(b"\x11\x22\0\x33") == b"\x03\x11\x22\x02\x33"
