#include "PeriodicConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "NodePairs.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::PairedSides;

/** Returns a motion of a plane as one of space that leaves the normal of the plane as it is. */
Eigen::Matrix4d InSpace(const crossfield::RigidMotion& motion, const crossfield::DomainPlane& plane)
{
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topRightCorner<3, 1>() = plane.DirectionToSpace(motion.shift);
  if (motion.angle != 0.0)
  {
    Eigen::Matrix3d axes;
    axes.col(0) = plane.DirectionToSpace(crossfield::Point::UnitX());
    axes.col(1) = plane.DirectionToSpace(crossfield::Point::UnitY());
    axes.col(2) = axes.col(0).cross(axes.col(1));
    Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
    turned.topLeftCorner<2, 2>() = motion.Rotation();
    const Eigen::Matrix3d rotation = axes * turned * axes.transpose();
    const Eigen::Vector3d origin = plane.ToSpace(crossfield::Point::Zero());
    matrix.topLeftCorner<3, 3>() = rotation;
    matrix.topRightCorner<3, 1>() += origin - rotation * origin;
  }
  return matrix;
}
}

namespace PeriodicConversion
{
//------------------------------------------------------------------------------
std::vector<crossfield::SidePair> Read(
  vtkFieldData* data, const std::vector<std::string>& sideNames)
{
  std::vector<crossfield::SidePair> pairs;
  auto* sides = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::PeriodicSides));
  vtkDataArray* motions = data->GetArray(names::PeriodicMotion);
  if (sides == nullptr && motions == nullptr)
  {
    return pairs;
  }
  if (sides == nullptr || motions == nullptr || motions->GetNumberOfComponents() != 16 ||
    sides->GetNumberOfValues() != 2 * motions->GetNumberOfTuples())
  {
    throw crossfield::Error(
      "The field data PeriodicSides and PeriodicMotion do not have two names and 16 numbers for "
      "each pair; remove both, or make the mesh again.");
  }
  const auto sideAt = [&](vtkIdType i)
  {
    const std::string name = sides->GetValue(i);
    const auto found = std::find(sideNames.begin(), sideNames.end(), name);
    if (found == sideNames.end())
    {
      throw crossfield::Error("The mesh has no side '" + name +
        "', which the field data PeriodicSides names; remove PeriodicSides and PeriodicMotion.");
    }
    return static_cast<int>(found - sideNames.begin());
  };
  for (vtkIdType pair = 0; pair < motions->GetNumberOfTuples(); ++pair)
  {
    crossfield::SidePair one;
    one.first = sideAt(2 * pair);
    one.second = sideAt(2 * pair + 1);
    for (int i = 0; i < 16; ++i)
    {
      one.motion(i / 4, i % 4) = motions->GetComponent(pair, i);
    }
    pairs.push_back(one);
  }
  return pairs;
}

//------------------------------------------------------------------------------
void Write(
  const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  data->RemoveArray(names::PeriodicSides);
  data->RemoveArray(names::PeriodicMotion);
  if (mesh.periodic.empty())
  {
    return;
  }
  vtkNew<vtkStringArray> sides;
  sides->SetName(names::PeriodicSides);
  sides->SetNumberOfComponents(2);
  const auto pairs = static_cast<vtkIdType>(mesh.periodic.size());
  auto motions = ColumnWriting::NewArray<vtkDoubleArray>(data, names::PeriodicMotion, 16, pairs);
  for (vtkIdType i = 0; i < pairs; ++i)
  {
    const PairedSides& pair = mesh.periodic[i];
    for (const int side : { pair.first, pair.second })
    {
      sides->InsertNextValue(mesh.sideNames[side]);
    }
    const Eigen::Matrix4d matrix = InSpace(pair.motion, plane);
    for (int k = 0; k < 16; ++k)
    {
      motions->SetComponent(i, k, matrix(k / 4, k % 4));
    }
  }
  data->AddArray(sides);
}

//------------------------------------------------------------------------------
void WriteReport(
  const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkFieldData* data)
{
  Write(mesh, plane, data);
  if (mesh.periodic.empty())
  {
    return;
  }
  const auto isRotation = [](const PairedSides& pair) { return pair.motion.angle != 0.0; };
  ColumnWriting::AddColumn<vtkStringArray>(data, names::PeriodicKind, mesh.periodic,
    [&](const PairedSides& pair) { return isRotation(pair) ? "rotation" : "translation"; });
  ColumnWriting::AddColumn<vtkDoubleArray>(data, names::PeriodicAngle, mesh.periodic,
    [](const PairedSides& pair) { return pair.motion.angle; });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::PeriodicEdges, mesh.periodic,
    [](const PairedSides& pair) { return static_cast<int>(pair.nodes.size()) - 1; });
  ColumnWriting::AddColumn<vtkDoubleArray>(data, names::PeriodicMismatch, mesh.periodic,
    [&](const PairedSides& pair) { return LargestMismatch(pair, mesh); });
  const auto pairs = static_cast<vtkIdType>(mesh.periodic.size());
  auto vectors = ColumnWriting::NewArray<vtkDoubleArray>(data, names::PeriodicVector, 3, pairs);
  auto centres = ColumnWriting::NewArray<vtkDoubleArray>(data, names::PeriodicCentre, 3, pairs);
  for (vtkIdType i = 0; i < pairs; ++i)
  {
    const PairedSides& pair = mesh.periodic[i];
    if (isRotation(pair))
    {
      centres->SetTuple(i, plane.ToSpace(pair.motion.Centre()).data());
    }
    else
    {
      vectors->SetTuple(i, plane.DirectionToSpace(pair.motion.shift).data());
    }
  }
}

//------------------------------------------------------------------------------
void Copy(vtkFieldData* from, vtkFieldData* to)
{
  for (const char* name : { names::PeriodicSides, names::PeriodicMotion })
  {
    if (vtkAbstractArray* array = from->GetAbstractArray(name))
    {
      to->AddArray(array);
    }
  }
}
}
