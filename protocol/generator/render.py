"""Turns a checked schema into the text of every generated file."""

from __future__ import annotations

import json
import re
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from protocol.generator.schema import INTEGER_BYTES, Layout, Schema
from protocol.generator.vectors import cobs_vectors, frame_vectors

_TEMPLATES = Path(__file__).parent / "templates"
_CPP_INTEGERS = {
    name: f"{'uint' if name[0] == 'u' else 'int'}{8 * size}_t"
    for name, size in INTEGER_BYTES.items()
}


def generate(schema: Schema) -> dict[str, str]:
    """Text of every generated file, by its path from the repository's root."""
    frames, stuffing = frame_vectors(schema), cobs_vectors()
    environment = _environment()

    def render(template: str) -> str:
        text = environment.get_template(template).render(
            schema=schema, frames=frames, stuffing=stuffing
        )
        return re.sub(r"[ \t]+\n", "\n", text).rstrip("\n") + "\n"

    origin = "Generated from protocol/protocol.yml by protocol/generator; do not edit."
    return {
        "firmware/core/generated/protocol.hpp": render("protocol.hpp.j2"),
        "host/reliefscope/protocol/messages.py": render("messages.py.j2"),
        "docs/reference/protocol.md": re.sub(r"\n{3,}", "\n\n", render("protocol.md.j2")),
        "tests/firmware/generated/vectors.hpp": render("vectors.hpp.j2"),
        "protocol/vectors/frames.json": _json(
            {"origin": origin, "schema_hash": schema.hash.hex(), "vectors": frames}
        ),
        "protocol/vectors/cobs.json": _json({"origin": origin, "vectors": stuffing}),
    }


def _json(content: object) -> str:
    return json.dumps(content, indent=1) + "\n"


def _environment() -> Environment:
    environment = Environment(
        loader=FileSystemLoader(_TEMPLATES),
        undefined=StrictUndefined,
        keep_trailing_newline=True,
        autoescape=False,
    )
    environment.filters.update(
        class_name=lambda name: "".join(part.capitalize() for part in name.split("_")),
        constant_name=lambda name: "k" + "".join(part.capitalize() for part in name.split("_")),
        cpp_int=_CPP_INTEGERS.__getitem__,
        size_of=INTEGER_BYTES.__getitem__,
        literal=json.dumps,
        docstring=lambda text: f'"""{text}"""',
        hex_bytes=lambda text: ",".join(map(str, bytes.fromhex(text))),
    )
    environment.globals["fields_of"] = _fields_table
    return environment


def _fields_table(layout: Layout) -> str:
    if not layout.fields:
        return "No payload.\n"
    rows = ["| field | type | unit | range | meaning |", "|---|---|---|---|---|"]
    for f in layout.fields:
        rows.append(f"| {f.name} | {f.type_text} | {f.unit} | {f.range_text} | {f.description} |")
    return "\n".join(rows) + "\n"
