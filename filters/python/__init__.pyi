# Public names; the classes and functions are typed where they are defined.
from . import names as names
from ._boundary import simplify as simplify
from ._configurations import energy as energy, optimize as optimize, propose as propose
from ._functions import (
    check as check, corners as corners, drill as drill, hfield as hfield, separatrices as separatrices,
    solve as solve)
from ._input import configuration as configuration, read as read
from ._quads import QuadMesh as QuadMesh, quads as quads
from ._results import (
    Configuration as Configuration, Corners as Corners, CrossField as CrossField, HField as HField,
    Mesh as Mesh, Separatrices as Separatrices, ConsistencyCheck as ConsistencyCheck)
from ._run import Error as Error
from ._solid import SolidMesh as SolidMesh
from .vtkCrossFieldFilters import *

__version__: str
