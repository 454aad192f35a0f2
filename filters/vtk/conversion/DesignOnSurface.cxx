#include "DesignOnSurface.h"

#include "Error.h"
#include "NamedSurface.h"
#include "SurfaceConversion.h"

#include "vtkDoubleArray.h"
#include "vtkMath.h"

#include <array>
#include <string>
#include <utility>

namespace
{
using Singularities = std::vector<crossfield::SurfaceSingularity>;

Singularities SingularitiesOf(const DesignModel::Rows& rows)
{
  Singularities singularities;
  for (const auto& [x, y, quarterIndex, z] : rows)
  {
    singularities.push_back({ { x, y, z }, static_cast<int>(quarterIndex) });
  }
  return singularities;
}

DesignModel::Rows RowsOf(const Singularities& singularities)
{
  DesignModel::Rows rows;
  for (const crossfield::SurfaceSingularity& one : singularities)
  {
    rows.push_back(
      { one.place.x(), one.place.y(), static_cast<double>(one.quarterIndex), one.place.z() });
  }
  return rows;
}

crossfield::Error NotSupported(const std::string& what)
{
  return crossfield::Error(
    "Layouts of a surface in space do not support " + what + " yet; leave this option out.");
}

crossfield::DesignSurface ReadSurface(vtkDataSet* data, double featureAngle)
{
  NamedSurface surface = NamedSurface::Read(data);
  return { std::move(surface.mesh), std::move(surface.names),
    vtkMath::RadiansFromDegrees(featureAngle) };
}
}

//------------------------------------------------------------------------------
DesignOnSurface::DesignOnSurface(vtkDataSet* data, double featureAngle)
  : Surface(ReadSurface(data, featureAngle))
{
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignOnSurface::Read(vtkDataSet* singularities) const
{
  return RowsOf(SurfaceConversion::ReadSingularities(singularities));
}

//------------------------------------------------------------------------------
std::vector<crossfield::CornerChoice> DesignOnSurface::ReadCorners(vtkDataSet* corners) const
{
  if (corners != nullptr)
  {
    throw NotSupported("prescribed corners");
  }
  return {};
}

//------------------------------------------------------------------------------
const DesignModel::Rows& DesignOnSurface::Choose(
  const DesignRequest& request, const crossfield::Progress& progress)
{
  if (this->Chosen.empty())
  {
    this->Chosen = RowsOf(this->Surface.Choose(request.QuadSizeOn(this->Area()), progress));
  }
  return this->Chosen;
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignOnSurface::Change(const DesignRequest& request, const Rows& rows,
  std::vector<std::string>& events, const crossfield::Progress& progress)
{
  if (request.command != DesignCommand::Optimise)
  {
    events.emplace_back("Snap and Add Pair do not work on a surface in space yet: singularities "
                        "are moved and added by hand.");
    return rows;
  }
  Rows moved = RowsOf(this->Surface.Move(SingularitiesOf(rows), progress));
  events.emplace_back(moved == rows
      ? "No singularity was moved: sizes are as even as they become by small moves."
      : "Singularities were moved to where sizes are more even.");
  return moved;
}

//------------------------------------------------------------------------------
crossfield::LayoutDesign DesignOnSurface::Design(
  const DesignRequest& request, const Rows& rows, const crossfield::Progress& progress)
{
  if (request.meshSize > 0.0)
  {
    throw NotSupported("a mesh size");
  }
  if (request.options.clean)
  {
    throw NotSupported("fewer blocks by moving singularities");
  }
  const Singularities singularities = SingularitiesOf(rows);
  if (request.isDragging)
  {
    return this->Surface.DesignCoarse(singularities, request.options.earlier, progress);
  }
  std::optional<crossfield::SurfaceQuadOptions> quads;
  if (request.options.quads)
  {
    quads = { request.quadSize, request.quadCount, false, request.options.quads->smooth,
      request.options.quads->coarse };
  }
  return this->Surface.Design(
    singularities, request.QuadSizeOn(this->Area()), quads, request.options.earlier, progress);
}

//------------------------------------------------------------------------------
int DesignOnSurface::RequiredSum(const DesignRequest&, const Rows&)
{
  if (!this->Required)
  {
    this->Required = this->Surface.RequiredSum();
  }
  return *this->Required;
}

//------------------------------------------------------------------------------
DesignModel::Rows DesignOnSurface::NodesOf(const crossfield::LayoutDesign& design) const
{
  return RowsOf(design.onSurface);
}

//------------------------------------------------------------------------------
void DesignOnSurface::WriteSingularities(const Rows& rows, vtkPolyData* output) const
{
  SurfaceConversion::WriteConfiguration(SingularitiesOf(rows), output);
}

//------------------------------------------------------------------------------
void DesignOnSurface::WriteTriangles(vtkDoubleArray* output) const
{
  const crossfield::SurfaceMesh& mesh = this->Surface.Coarse();
  for (const std::array<int, 3>& triangle : mesh.triangles)
  {
    std::array<double, 9> numbers{};
    for (std::size_t i = 0; i < 9; ++i)
    {
      numbers[i] =
        mesh.points[static_cast<std::size_t>(triangle[i / 3])][static_cast<Eigen::Index>(i % 3)];
    }
    output->InsertNextTuple(numbers.data());
  }
}
