#include "FaceSurface.h"

#include "Error.h"
#include "TextEncoding.h"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
using crossfield::Error;

/**
 * Triangles of all faces. Faces that share an edge share its points, which follow from the edge and not from their
 * places.
 */
class FaceTriangulation
{
public:
  explicit FaceTriangulation(const ModelFile& model)
    : Model(model)
  {
    TopExp::MapShapes(model.Shape(), TopAbs_FACE, this->Faces);
    TopExp::MapShapes(model.Shape(), TopAbs_EDGE, this->Edges);
    TopExp::MapShapes(model.Shape(), TopAbs_VERTEX, this->Vertices);
    this->PointsOfEdge.resize(static_cast<std::size_t>(this->Edges.Extent()) + 1);
    this->PointOfVertex.resize(static_cast<std::size_t>(this->Vertices.Extent()) + 1, -1);
  }

  crossfield::DrawingSurface Run(double angle)
  {
    if (this->Faces.IsEmpty())
    {
      throw Error("The model '" + this->Model.File() + "' has no face; give a model with faces.");
    }
    constexpr double Part = 1e-3; // distance of triangles from a face, of the diagonal
    Bnd_Box box;
    BRepBndLib::Add(this->Model.Shape(), box);
    const BRepMesh_IncrementalMesh mesher(
      this->Model.Shape(), Part * std::sqrt(box.SquareExtent()), false, angle);
    for (int f = 1; f <= this->Faces.Extent(); ++f)
    {
      this->AddFace(f);
    }
    this->AddLines();
    return std::move(this->Surface);
  }

private:
  int AddPoint(const gp_Pnt& place)
  {
    this->Surface.points.emplace_back(place.X(), place.Y(), place.Z());
    return static_cast<int>(this->Surface.points.size()) - 1;
  }

  /** Returns the point of a vertex. */
  int PointAt(const TopoDS_Vertex& vertex)
  {
    int& point = this->PointOfVertex[static_cast<std::size_t>(this->Vertices.FindIndex(vertex))];
    point = point < 0 ? this->AddPoint(BRep_Tool::Pnt(vertex)) : point;
    return point;
  }

  /** Sets the points of the nodes of a face that are on an edge. */
  void SetNodes(const TopoDS_Edge& edge, const Handle(Poly_Triangulation) & triangles,
    const TopLoc_Location& location, std::vector<int>& pointOf)
  {
    const Handle(Poly_PolygonOnTriangulation) polygon =
      BRep_Tool::PolygonOnTriangulation(edge, triangles, location);
    const TopoDS_Vertex first = TopExp::FirstVertex(edge);
    const TopoDS_Vertex last = TopExp::LastVertex(edge);
    if (polygon.IsNull() || first.IsNull() || last.IsNull())
    {
      return; // an edge without ends, whose points follow from their places
    }
    std::vector<int>& points =
      this->PointsOfEdge[static_cast<std::size_t>(this->Edges.FindIndex(edge))];
    const int count = polygon->NbNodes();
    if (points.empty())
    {
      points.push_back(this->PointAt(first));
      for (int i = 2; i < count; ++i)
      {
        points.push_back(BRep_Tool::Degenerated(edge)
            ? points.front()
            : this->AddPoint(
                triangles->Node(polygon->Node(i)).Transformed(location.Transformation())));
      }
      points.push_back(this->PointAt(last));
    }
    for (int i = 1; i <= count && points.size() == static_cast<std::size_t>(count); ++i)
    {
      pointOf[static_cast<std::size_t>(polygon->Node(i))] = points[static_cast<std::size_t>(i) - 1];
    }
  }

  void AddFace(int number)
  {
    const TopoDS_Face& face = TopoDS::Face(this->Faces(number));
    TopLoc_Location location;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, location);
    if (triangles.IsNull())
    {
      throw Error("Face " + std::to_string(number) + " of the model '" + this->Model.File() +
        "' cannot be divided into triangles; repair it, or leave it out.");
    }
    std::vector<int> pointOf(static_cast<std::size_t>(triangles->NbNodes()) + 1, -1);
    for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next())
    {
      this->SetNodes(TopoDS::Edge(explorer.Current()), triangles, location, pointOf);
    }
    const std::string given = crossfield::ToUtf8(this->Model.NameOf(face));
    const std::string name = given.empty() ? "face" + std::to_string(number) : given;
    for (int t = 1; t <= triangles->NbTriangles(); ++t)
    {
      std::array<int, 3> nodes{};
      triangles->Triangle(t).Get(nodes[0], nodes[1], nodes[2]);
      std::vector<int> polygon;
      for (const int node : nodes)
      {
        int& point = pointOf[static_cast<std::size_t>(node)];
        point = point < 0
          ? this->AddPoint(triangles->Node(node).Transformed(location.Transformation()))
          : point;
        polygon.push_back(point);
      }
      if (polygon[0] == polygon[1] || polygon[1] == polygon[2] || polygon[2] == polygon[0])
      {
        continue; // at the pole of a sphere
      }
      if (face.Orientation() == TopAbs_REVERSED)
      {
        std::swap(polygon[1], polygon[2]);
      }
      this->Surface.polygons.push_back(std::move(polygon));
      this->Surface.regions.push_back(name);
    }
  }

  /** Adds the edges with a name. */
  void AddLines()
  {
    for (int e = 1; e <= this->Edges.Extent(); ++e)
    {
      const TopoDS_Edge& edge = TopoDS::Edge(this->Edges(e));
      const std::string name = crossfield::ToUtf8(this->Model.NameOf(edge));
      const std::vector<int>& points = this->PointsOfEdge[static_cast<std::size_t>(e)];
      if (!name.empty() && !points.empty() && !BRep_Tool::Degenerated(edge))
      {
        this->Surface.lines.push_back({ points, name });
      }
    }
  }

  const ModelFile& Model;
  TopTools_IndexedMapOfShape Faces; ///< Numbers begin with 1, as those of edges and vertices.
  TopTools_IndexedMapOfShape Edges;
  TopTools_IndexedMapOfShape Vertices;
  std::vector<std::vector<int>> PointsOfEdge;
  std::vector<int> PointOfVertex; ///< −1 if it has none yet.
  crossfield::DrawingSurface Surface;
};
}

//------------------------------------------------------------------------------
crossfield::Drawing TriangulateFaces(const ModelFile& model, double angle)
{
  crossfield::Drawing drawing;
  drawing.unit = model.Unit();
  drawing.surface = FaceTriangulation(model).Run(angle);
  return drawing;
}
