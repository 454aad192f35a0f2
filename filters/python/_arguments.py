"""Checks the types of arguments, so that a mistake gives a sentence and not an error inside of VTK."""
from __future__ import annotations

import functools
import inspect
from numbers import Real
from typing import Any, Callable, Mapping, TypeVar, cast

import numpy as np

from ._run import ArgumentError

Function = TypeVar("Function", bound=Callable[..., Any])

_LARGEST = 2 ** 31 - 1  # numbers of VTK are 32-bit integers


def _refuse(value: Any, what: str, expected: str) -> None:
    text = repr(value)
    if len(text) > 40:  # a whole array or dictionary
        text = "a value of the type " + type(value).__name__
    raise ArgumentError("The %s is %s; give %s." % (what, text, expected))


def _item(value: Any) -> Any:
    return value.item() if isinstance(value, (np.ndarray, np.generic)) and np.ndim(value) == 0 else value


def number(value: Any, what: str, expected: str = "a number") -> Any:
    """Returns a real number."""
    value = _item(value)
    if not isinstance(value, Real) or isinstance(value, bool):
        _refuse(value, what, expected)
    return value


def whole(value: Any, what: str, expected: str = "a whole number") -> int:
    """Returns a whole number as int."""
    value = number(value, what, expected)
    if abs(value) > _LARGEST:
        expected = expected.replace("whole number", "whole number of at most %d" % _LARGEST)
    if not abs(value) <= _LARGEST or value != int(value):
        _refuse(value, what, expected)
    return int(value)


def flag(value: Any, what: str, expected: str = "True or False") -> bool:
    """Returns a flag; 0 and 1 are flags."""
    value = _item(value)
    if not isinstance(value, Real) or value not in (0, 1):
        _refuse(value, what, expected)
    return bool(value)


def text(value: Any, what: str, expected: str = "a text") -> str:
    """Returns a text."""
    if not isinstance(value, str):
        _refuse(value, what, expected)
    return cast(str, value)


def dictionary(value: Any, what: str, example: str) -> Mapping[Any, Any]:
    """Returns a dictionary whose keys are names of sides."""
    if not isinstance(value, Mapping) or not all(isinstance(key, str) for key in value):
        _refuse(value, what, "a dictionary by the names of sides, as %s" % example)
    return cast(Mapping[Any, Any], value)


_KINDS: dict[str, tuple[Callable[[Any, str, str], Any], str]] = {
    "float": (number, "a number"), "int": (whole, "a whole number"), "bool": (flag, "True or False"),
    "str": (text, "a text")}


def checks_arguments(function: Function) -> Function:
    """Makes a function check the arguments that are annotated as numbers, flags or texts, or None beside these."""
    signature = inspect.signature(function)
    checks = {}
    for name, parameter in signature.parameters.items():
        kind = str(parameter.annotation)
        is_optional = kind.startswith("Optional[")
        kind = kind[len("Optional["):-1] if is_optional else kind
        if kind in _KINDS:
            check, expected = _KINDS[kind]
            checks[name] = check, expected + (", or None" if is_optional else ""), is_optional

    @functools.wraps(function)
    def checked(*arguments: Any, **options: Any) -> Any:
        bound = signature.bind(*arguments, **options)
        for name, (check, expected, is_optional) in checks.items():
            if name in bound.arguments and not (is_optional and bound.arguments[name] is None):
                bound.arguments[name] = check(bound.arguments[name], "argument " + name, expected)
        return function(*bound.args, **bound.kwargs)

    return cast(Function, checked)
