"""How to go on with an acquisition that ended early."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from reliefscope.dataset.spec import resume_command_of
from reliefscope.dataset.writer import partial_path
from reliefscope.errors import OutputExistsError, ReliefscopeError


@contextmanager
def resumable(run: Path) -> Iterator[None]:
    """Tell how to go on with ``run``, given with or without ``.partial``, where its acquisition ends early."""
    try:
        yield
    except OutputExistsError:
        raise
    except ReliefscopeError as error:
        folder = run if run.is_dir() else partial_path(run)
        if folder.is_dir() and "--resume" not in error.hint:
            advice = f"Go on with: {resume_command_of(folder)}."
            error.hint = f"{error.hint}\n{advice}" if error.hint else advice
        raise
