# The classes and functions are typed where they are defined; this says which of them are public.
from . import names as names
from ._functions import check as check, corners as corners, drill as drill, solve as solve
from ._input import configuration as configuration, read as read
from ._results import (
    Corners as Corners, CrossField as CrossField, Mesh as Mesh, Verdict as Verdict)
from ._run import Error as Error
from .vtkCrossFieldFilters import *

__version__: str
