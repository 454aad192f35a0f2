#ifndef Json_h
#define Json_h

// Headers of VTK 9.4 declare functions with types of this library, with VTK's own copy of it. The copy
// renames the namespace to vtknlohmann by a macro, so the library cannot be used beside it.
#include "vtkAbstractArray.h"

#ifdef VTK_NLOHMANN_JSON
#include VTK_NLOHMANN_JSON(json.hpp)
#else
#include <nlohmann/json.hpp>
#endif

#endif
