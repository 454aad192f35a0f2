#ifndef FilterPorts_h
#define FilterPorts_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"

/**
 * Data types of the ports of this module's filters. Every function returns 1, the result of
 * FillInputPortInformation and FillOutputPortInformation.
 */
namespace FilterPorts
{
/** Accepts a domain: boundary loops or a surface mesh. */
inline int AcceptDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

/** Accepts a domain or no connection. */
inline int AcceptOptionalDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return AcceptDomain(info);
}

/** Accepts a mesh of vtkDrillHoles, with or without a field. */
inline int AcceptMesh(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

/** Accepts points with arrays: singularities or corners. */
inline int AcceptPoints(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}

/** Accepts points or no connection. */
inline int AcceptOptionalPoints(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return AcceptPoints(info);
}

/** Produces data of a class. */
inline int Produce(vtkInformation* info, const char* type)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), type);
  return 1;
}
}

#endif
