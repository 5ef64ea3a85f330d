"""Colours of the screen: dark, so that it does not light up the bench; amber means light."""

from textual.theme import Theme

THEME = Theme(
    name="bench",
    primary="#5fb3b3",
    secondary="#7aa2c8",
    accent="#e6b450",
    warning="#e6b450",
    error="#e06c6c",
    success="#8fbf7f",
    foreground="#d4d8dd",
    background="#0e1216",
    surface="#141a20",
    panel="#1b232b",
    dark=True,
    variables={
        "footer-key-foreground": "#e6b450",
        "footer-background": "#1b232b",
        "surface-lighten-1": "#222b34",
        "surface-lighten-2": "#34404c",
        "surface-lighten-3": "#4b5a69",
    },
)
