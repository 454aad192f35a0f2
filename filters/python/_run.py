"""Runs filters without output on the console; their errors are raised."""
from __future__ import annotations

import contextlib
import re
import warnings
from typing import Any, Iterator

from vtkmodules.vtkCommonCore import vtkLogger, vtkOutputWindow, vtkStringOutputWindow

from .vtkCrossFieldFilters import vtkCrossFieldErrorCodes


class Error(RuntimeError):
    """Error of every function of this package: one sentence that names cause, place and remedy.

    `inconsistent` is true when the input is valid, but no cross field with these singularities
    exists (exit status 1 of the program), and false when the input is bad (exit status 2).
    """

    def __init__(self, sentence: str, inconsistent: bool = False) -> None:
        super().__init__(sentence)
        self.inconsistent = inconsistent


class ArgumentError(Error, TypeError):
    """Error of an argument of a wrong type, also a TypeError."""


def _sentence(text: str) -> str:
    """Returns the sentence in a text of VTK, "ERROR: In FILE, line N\\nvtkClass (0x...):
    sentence\\n\\n"."""
    return text.split("): ", 1)[-1].strip()


@contextlib.contextmanager
def _quiet() -> Iterator[vtkStringOutputWindow]:
    """Collects the messages of objects inside filters, which have no observer."""
    window, verbosity = vtkOutputWindow.GetInstance(), vtkLogger.GetCurrentVerbosityCutoff()
    kept = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(kept)
    vtkLogger.SetStderrVerbosity(vtkLogger.VERBOSITY_OFF)
    try:
        yield kept
    finally:
        vtkLogger.SetStderrVerbosity(verbosity)
        vtkOutputWindow.SetInstance(window)


class Pipeline:
    """Filters whose errors and warnings are collected, in the order in which they occur."""

    def __init__(self) -> None:
        self._filters: list[Any] = []
        self._errors: list[str] = []
        self._warnings: list[str] = []

    def add(self, algorithm: Any) -> Any:
        """Observes a filter and returns it."""
        self._filters.append(algorithm)
        algorithm.AddObserver("ErrorEvent", self._keep_error)
        algorithm.AddObserver("WarningEvent", self._keep_warning)
        # The executive reports once more that its filter has failed.
        algorithm.GetExecutive().AddObserver("ErrorEvent", lambda *_: None)
        return algorithm

    def update(self, algorithm: Any) -> Any:
        """Updates a filter and those upstream; raises Error if one of them fails."""
        with _quiet() as inside:
            algorithm.Update()
        self._errors += re.findall(r"^ERROR: In .*\n(.*)", inside.GetOutput(), re.MULTILINE)
        for text in self._warnings:
            warnings.warn(_sentence(text), RuntimeWarning, stacklevel=4)
        self._warnings.clear()  # for the next filter
        codes = [found.GetErrorCode() for found in self._filters]
        if self._errors or any(codes):
            text = self._errors[0] if self._errors else "VTK failed without a message; check the input."
            raise Error(_sentence(text), vtkCrossFieldErrorCodes.Inconsistent in codes)
        return algorithm

    def update_one(self, algorithm: Any) -> Any:
        """Observes and updates a single filter."""
        return self.update(self.add(algorithm))

    def _keep_error(self, caller: Any, event: str, text: str) -> None:
        self._errors.append(text)

    def _keep_warning(self, caller: Any, event: str, text: str) -> None:
        self._warnings.append(text)

    _keep_error.CallDataType = "string0"  # type: ignore[attr-defined]
    _keep_warning.CallDataType = "string0"  # type: ignore[attr-defined]
