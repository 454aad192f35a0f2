#include "UsedPoints.h"

#include "CellLoop.h"

#include "vtkDataSet.h"

//------------------------------------------------------------------------------
UsedPoints::UsedPoints(vtkDataSet* input)
  : Indices(static_cast<std::size_t>(input->GetNumberOfPoints()), -1)
{
  CellLoop::ForEachCell(input,
    [this](vtkIdType, int type, const auto& points)
    {
      if (type == VTK_EMPTY_CELL || type == VTK_VERTEX || type == VTK_POLY_VERTEX)
      {
        return;
      }
      for (const auto point : points)
      {
        this->Indices[point] = 0;
      }
    });
  for (vtkIdType point = 0; point < input->GetNumberOfPoints(); ++point)
  {
    if (this->Indices[point] == 0)
    {
      this->Indices[point] = static_cast<int>(this->Ids.size());
      this->Ids.push_back(point);
    }
  }
}

//------------------------------------------------------------------------------
Eigen::Matrix3Xd UsedPoints::PlacesOf(vtkDataSet* input) const
{
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(this->Ids.size()));
  for (Eigen::Index i = 0; i < places.cols(); ++i)
  {
    input->GetPoint(this->Ids[i], places.col(i).data());
  }
  return places;
}

//------------------------------------------------------------------------------
crossfield::DomainPlane UsedPoints::FindPlane(vtkDataSet* input) const
{
  return crossfield::DomainPlane::Find(this->PlacesOf(input));
}

//------------------------------------------------------------------------------
crossfield::DomainPlane UsedPoints::NearestPlane(vtkDataSet* input) const
{
  return crossfield::DomainPlane::Nearest(this->PlacesOf(input));
}
