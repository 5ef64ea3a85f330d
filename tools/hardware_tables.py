"""Writes the tables and the diagram of docs/guide/hardware.md from the Teensy's board header.

python tools/hardware_tables.py            rewrites what stands between the marks, and the diagram
python tools/hardware_tables.py --check    fails when they differ from what the header says
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HEADER = ROOT / "firmware" / "boards" / "teensy31" / "board.hpp"
PAGE = ROOT / "docs" / "guide" / "hardware.md"
DIAGRAM = ROOT / "docs" / "images" / "wiring.svg"
_CONSTANT = re.compile(r"constexpr std::uint\d+_t k(\w+) =\s*(\d+);\s*// (.+)")
_LEDS_PER_CHIP = 16


def constants() -> dict[str, tuple[int, str]]:
    """Value and text of every constant of the header."""
    found = _CONSTANT.findall(HEADER.read_text(encoding="utf-8"))
    return {name: (int(value), text) for name, value, text in found}


def pins() -> list[tuple[str, int, str]]:
    """Name, pin and use, in the header's order."""
    text = HEADER.read_text(encoding="utf-8")
    section = text[text.index("// Pins.") : text.index("// LEDs.")]
    return [(name, int(pin), use) for name, pin, use in _CONSTANT.findall(section)]


def wiring_table() -> str:
    """One row a pin."""
    rows = [f"| {pin} | `k{name}` | {use} |" for name, pin, use in pins()]
    return "\n".join(["| Teensy pin | in the header | goes to |", "|---|---|---|", *rows])


def limits_table() -> str:
    """One row for each constant that is no pin."""
    names = {name for name, _, _ in pins()}
    rows = [
        f"| `k{name}` | {value} | {text} |"
        for name, (value, text) in constants().items()
        if name not in names
    ]
    return "\n".join(["| in the header | value | meaning |", "|---|---|---|", *rows])


def parts_table() -> str:
    """Bill of materials for the chain of TLC5940."""
    values = constants()
    leds = values["Leds"][0]
    chips = -(-leds // _LEDS_PER_CHIP)
    resistors = sum("10 kOhm" in use for _, _, use in pins())
    parts = [
        (1, "Teensy 3.2", "controller"),
        (1, "EA DOGM128S-6 (FSTN negative) or DOGM128E-6 (STN positive)", "aperture glass"),
        (leds, "white LED, 3 mm, narrow beam (VLHW4100 or like)", "dome"),
        (chips, "TLC5940", "constant-current sinks for the LEDs"),
        (chips, "resistor at IREF, see below", f"{values['LedMilliamperes'][0]} mA a LED"),
        (resistors, "resistor 10 kOhm", "levels of lines in reset, see the wiring table"),
        (chips + 1, "capacitor 100 nF", "beside each chip and the glass"),
        (1, "capacitor 47 uF", "5 V rail of the LEDs"),
    ]
    rows = [f"| {count} | {part} | {use} |" for count, part, use in parts]
    return "\n".join(["| number | part | for |", "|---|---|---|", *rows])


def diagram() -> str:
    """The Teensy in the middle, a line for every pin to the part that it goes to."""
    sides = {"Lcd": ("glass", 20), "Led": ("LED drivers", 20), "Camera": ("camera", 20)}
    height = 60 + 30 * len(pins())
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 760 {height}" '
        'font-family="sans-serif" font-size="13">',
        f'<rect x="20" y="20" width="160" height="{height - 40}" fill="none" stroke="currentColor"/>',
        '<text x="100" y="40" text-anchor="middle">Teensy 3.2</text>',
    ]
    for row, (name, pin, _use) in enumerate(pins()):
        y = 65 + 30 * row
        part = next(sides[key][0] for key in sides if name.startswith(key))
        lines += [
            f'<text x="170" y="{y + 4}" text-anchor="end">{pin}</text>',
            f'<line x1="180" y1="{y}" x2="440" y2="{y}" stroke="currentColor"/>',
            f'<text x="310" y="{y - 5}" text-anchor="middle">k{name}</text>',
            f'<text x="450" y="{y + 4}">{part}</text>',
        ]
    return "\n".join([*lines, "</svg>", ""])


def page() -> str:
    """The page with its generated parts renewed."""
    text = PAGE.read_text(encoding="utf-8")
    for mark, table in (("wiring", wiring_table), ("limits", limits_table), ("parts", parts_table)):
        begin, end = f"<!-- {mark} -->\n", f"<!-- end of {mark} -->"
        head, rest = text.split(begin)
        text = head + begin + table() + "\n" + end + rest.split(end)[1]
    return text


def main() -> int:
    """Write or check; returns the exit code."""
    wanted = {PAGE: page(), DIAGRAM: diagram()}
    if "--check" in sys.argv[1:]:
        return int(any(p.read_text(encoding="utf-8") != text for p, text in wanted.items()))
    for path, text in wanted.items():
        path.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
