#include "PlaneFrame.h"

#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

//------------------------------------------------------------------------------
PlaneFrame::PlaneFrame(const crossfield::DomainPlane& plane)
  : origin(plane.ToSpace({ 0.0, 0.0 }))
  , axis1(plane.DirectionToSpace({ 1.0, 0.0 }))
  , axis2(plane.DirectionToSpace({ 0.0, 1.0 }))
{
}

//------------------------------------------------------------------------------
bool PlaneFrame::IsHorizontal() const
{
  return this->axis1 == Eigen::Vector3d::UnitX() && this->axis2 == Eigen::Vector3d::UnitY();
}

//------------------------------------------------------------------------------
Eigen::Vector3d PlaneFrame::ToSpace(double x, double y) const
{
  return this->origin + x * this->axis1 + y * this->axis2;
}

//------------------------------------------------------------------------------
crossfield::Point PlaneFrame::ToPlane(const Eigen::Vector3d& place) const
{
  return { (place - this->origin).dot(this->axis1), (place - this->origin).dot(this->axis2) };
}

//------------------------------------------------------------------------------
void PlaneFrame::Write(vtkDoubleArray* numbers) const
{
  numbers->SetNumberOfComponents(3);
  numbers->SetNumberOfTuples(0);
  for (const Eigen::Vector3d* column : { &this->origin, &this->axis1, &this->axis2 })
  {
    numbers->InsertNextTuple(column->data());
  }
}

//------------------------------------------------------------------------------
void PlaneFrame::Record(vtkFieldData* data) const
{
  if (this->IsHorizontal())
  {
    return;
  }
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(vtkCrossFieldArrayNames::Plane);
  this->Write(numbers);
  data->AddArray(numbers);
}

//------------------------------------------------------------------------------
std::optional<PlaneFrame> PlaneFrame::Read(vtkFieldData* data)
{
  vtkDataArray* numbers = data->GetArray(vtkCrossFieldArrayNames::Plane);
  if (numbers == nullptr || numbers->GetNumberOfComponents() != 3 ||
    numbers->GetNumberOfTuples() != 3)
  {
    return std::nullopt;
  }
  PlaneFrame frame;
  numbers->GetTuple(0, frame.origin.data());
  numbers->GetTuple(1, frame.axis1.data());
  numbers->GetTuple(2, frame.axis2.data());
  return frame;
}
