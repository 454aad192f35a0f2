#ifndef FilterPorts_h
#define FilterPorts_h

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"

/** What the ports of this module's filters take and give; each returns 1, as VTK wants it. */
namespace FilterPorts
{
/** A domain: boundary loops or a surface mesh. */
inline int TakeDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

inline int TakeOptionalDomain(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return TakeDomain(info);
}

/** A mesh of vtkDrillHoles, with or without a field. */
inline int TakeMesh(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

/** Points with arrays: singularities or corners. */
inline int TakePoints(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  return 1;
}
inline int TakeOptionalPoints(vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return TakePoints(info);
}

/** Data of a class. */
inline int Give(vtkInformation* info, const char* type)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), type);
  return 1;
}
}

#endif
