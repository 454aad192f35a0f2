#ifndef FilterPorts_h
#define FilterPorts_h

#include "Error.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"

#include <string>

/**
 * Data types of the ports of this module's filters. Every function returns 1, the result of
 * FillInputPortInformation and FillOutputPortInformation.
 */
namespace FilterPorts
{
/** Accepts a domain: boundary loops or a surface mesh, which may be structured. */
inline int AcceptDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

/** Accepts a domain, or the parts of one as blocks (CompositeInput.h). */
inline int AcceptDomains(vtkInformation* info)
{
  AcceptDomain(info);
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

/** Accepts a domain or no connection. */
inline int AcceptOptionalDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return AcceptDomain(info);
}

/** Accepts a mesh of vtkDrillHoles, with or without a field, or quads. */
inline int AcceptMesh(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

/** Accepts the boundary edges of vtkQuadMesher or no connection. */
inline int AcceptOptionalBoundary(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

/** Accepts points with arrays, singularities or corners, or no connection. */
inline int AcceptOptionalPoints(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

/** Accepts a table or no connection. */
inline int AcceptOptionalTable(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkTable");
  return 1;
}

/**
 * Accepts singularities that RequireSingularities reads. The port is optional for VTK, whose message
 * about a missing connection names neither the input nor a remedy.
 */
inline int AcceptSingularities(vtkInformation* info)
{
  return AcceptOptionalPoints(info);
}

/** Returns the data of a connection of a port; throws Error if there is none. */
inline vtkDataSet* RequireSingularities(
  vtkInformationVector* port, const char* name, int connection = 0)
{
  vtkDataSet* points = vtkDataSet::GetData(port, connection);
  if (points == nullptr)
  {
    throw crossfield::Error("The input " + std::string(name) +
      " has no connection; connect points with the array QuarterIndex, for example a Singularity "
      "Source.");
  }
  return points;
}

/** Produces data of a class. */
inline int Produce(vtkInformation* info, const char* type)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), type);
  return 1;
}
}

#endif
