"""Strict pydantic models and the one way to read them from YAML."""

from __future__ import annotations

import difflib
from pathlib import Path
from typing import Any, TypeVar, Union, get_args, get_origin

import yaml
from pydantic import BaseModel, ConfigDict, ValidationError
from pydantic_core import ErrorDetails

from reliefscope.errors import InvalidInputError


class StrictModel(BaseModel):
    """Frozen model that refuses unknown keys."""

    model_config = ConfigDict(extra="forbid", frozen=True, ser_json_inf_nan="constants")


ModelT = TypeVar("ModelT", bound=StrictModel)


def read_yaml(path: Path) -> Any:
    """Content of a YAML file (safe loader), or a clear error that names line and column."""
    try:
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise InvalidInputError(
            f"{path} does not exist.", hint=f"Check the path: `ls {path.parent}`."
        ) from None
    except (OSError, UnicodeDecodeError) as error:
        raise InvalidInputError(
            f"{path} cannot be read: {error}.", hint="Give a readable UTF-8 text file."
        ) from error
    try:
        return yaml.safe_load(text)
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        place = f" (line {mark.line + 1}, column {mark.column + 1})" if mark else ""
        problem = getattr(error, "problem", None) or "it cannot be parsed"
        raise InvalidInputError(
            f"{path} is not valid YAML{place}: {problem}.",
            hint="Check indentation, colons and quotes at that place.",
        ) from error


def load_model(model: type[ModelT], path: Path) -> ModelT:
    """Read ``path`` (YAML, or JSON as its subset) and check it against ``model``."""
    return parse_model(model, read_yaml(path), str(path))


def parse_model(model: type[ModelT], content: Any, source: str) -> ModelT:
    """Check ``content`` against ``model``; the error names each wrong key and the nearest known one."""
    if not isinstance(content, dict):
        known = ", ".join(model.model_fields)
        raise InvalidInputError(
            f"{source} holds no mapping of keys to values.", hint=f"Known keys: {known}."
        )
    try:
        return model.model_validate(content)
    except ValidationError as error:
        problems = "\n".join(f"  {_describe(model, detail)}" for detail in error.errors())
        raise InvalidInputError(
            f"{source} is not a valid {_words(model.__name__)}:\n{problems}",
            hint="Correct the keys named above; nothing was changed.",
        ) from None


def _describe(model: type[BaseModel], detail: ErrorDetails) -> str:
    place = ".".join(str(part) for part in detail["loc"]) or "(top level)"
    if detail["type"] == "extra_forbidden":
        known = _known_keys(model, detail["loc"][:-1])
        nearest = difflib.get_close_matches(str(detail["loc"][-1]), known, n=1, cutoff=0.4)
        advice = f"did you mean `{nearest[0]}`?" if nearest else f"known keys: {', '.join(known)}"
        return f"{place}: unknown key; {advice}"
    given = detail.get("input")
    shown = f" (given: {given!r})" if isinstance(given, str | int | float | bool) else ""
    return f"{place}: {detail['msg']}{shown}"


def _known_keys(model: type[BaseModel], location: tuple[int | str, ...]) -> list[str]:
    """Keys that the model allows at ``location``; every member of a union counts."""
    models = [model]
    for part in location:
        if not isinstance(part, str):
            continue
        found: list[type[BaseModel]] = []
        for candidate in models:
            field = candidate.model_fields.get(part)
            if field is not None:
                found.extend(_models_in(field.annotation))
        models = found or models
    return sorted({name for candidate in models for name in candidate.model_fields})


def _models_in(annotation: Any) -> list[type[BaseModel]]:
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    if get_origin(annotation) is None and annotation is not Union:
        return []
    return [model for argument in get_args(annotation) for model in _models_in(argument)]


def _words(name: str) -> str:
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in name).strip()
