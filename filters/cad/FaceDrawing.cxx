#include "FaceDrawing.h"

#include "CurvePieces.h"
#include "Error.h"
#include "TextEncoding.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Circ.hxx>
#include <gp_Elips.hxx>
#include <gp_Pln.hxx>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{
using crossfield::DomainPlane;
using crossfield::DrawingPiece;
using crossfield::Error;
using crossfield::PlaneCurve;
using crossfield::Point;

struct PlanarFace
{
  TopoDS_Face face;
  double area = 0.0;
  gp_Dir normal;
  gp_Pnt centre;
};

std::vector<PlanarFace> PlanarFaces(const TopoDS_Shape& shape, int& faces)
{
  std::vector<PlanarFace> planar;
  for (TopExp_Explorer explorer(shape, TopAbs_FACE); explorer.More(); explorer.Next())
  {
    ++faces;
    const TopoDS_Face& face = TopoDS::Face(explorer.Current());
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() == GeomAbs_Plane)
    {
      GProp_GProps properties;
      BRepGProp::SurfaceProperties(face, properties);
      planar.push_back(
        { face, properties.Mass(), surface.Plane().Axis().Direction(), properties.CentreOfMass() });
    }
  }
  return planar;
}

/**
 * Returns the largest face. Two sides of a plate are equal and parallel; the first one is used.
 * Equal faces with one centre are copies of one: some programs write a solid twice.
 */
const PlanarFace& Largest(const std::vector<PlanarFace>& faces, const std::string& file)
{
  constexpr double SameArea = 1e-6;
  constexpr double Parallel = 1e-6; // radians
  const PlanarFace* largest = &faces.front();
  for (const PlanarFace& face : faces)
  {
    largest = face.area > largest->area * (1.0 + SameArea) ? &face : largest;
  }
  constexpr double SamePlace = 1e-6; // of the side of a square of that area
  std::vector<const PlanarFace*> equal;
  for (const PlanarFace& face : faces)
  {
    const bool isCopy = std::any_of(equal.begin(), equal.end(),
      [&](const PlanarFace* other)
      { return other->centre.Distance(face.centre) <= SamePlace * std::sqrt(face.area); });
    if (face.area > largest->area * (1.0 - SameArea) && !isCopy)
    {
      equal.push_back(&face);
      if (equal.size() > 2 || !face.normal.IsParallel(largest->normal, Parallel))
      {
        throw Error("The model '" + file +
          "' has several planar faces of the same, largest area; give a model of one face, or take all "
          "faces as a surface (AllFaces, --all-faces).");
      }
    }
  }
  return *largest;
}

Eigen::Vector3d ToVector(const gp_XYZ& place)
{
  return { place.X(), place.Y(), place.Z() };
}

/** Converts edges to pieces in a plane. */
class EdgeConversion
{
public:
  explicit EdgeConversion(const DomainPlane& plane)
    : Plane(plane)
  {
    this->Axes.row(0) = plane.DirectionToSpace({ 1.0, 0.0 }).transpose();
    this->Axes.row(1) = plane.DirectionToSpace({ 0.0, 1.0 }).transpose();
  }

  std::vector<DrawingPiece> Convert(const TopoDS_Edge& edge, const std::string& origin) const
  {
    const BRepAdaptor_Curve curve(edge);
    const double begin = curve.FirstParameter();
    const double end = curve.LastParameter();
    switch (curve.GetType())
    {
    case GeomAbs_Line:
      return { crossfield::LinePiece(
        this->At(curve.Value(begin).XYZ()), this->At(curve.Value(end).XYZ())) };
    case GeomAbs_Circle:
    {
      const gp_Circ circle = curve.Circle();
      return { this->Conic(
        circle.Position(), circle.Radius(), circle.Radius(), begin, end, origin) };
    }
    case GeomAbs_Ellipse:
    {
      const gp_Elips ellipse = curve.Ellipse();
      return { this->Conic(
        ellipse.Position(), ellipse.MajorRadius(), ellipse.MinorRadius(), begin, end, origin) };
    }
    default:
      return this->Spline(edge, origin);
    }
  }

private:
  Point At(const gp_XYZ& place) const { return this->Plane.ToPlane(ToVector(place)); }
  Point Along(const gp_Dir& direction) const { return this->Axes * ToVector(direction.XYZ()); }

  DrawingPiece Conic(const gp_Ax2& axes, double major, double minor, double begin, double end,
    const std::string& origin) const
  {
    const Point axis = major * this->Along(axes.XDirection());
    const bool isPositive = crossfield::Cross(axis, this->Along(axes.YDirection())) > 0.0;
    const double sign = isPositive ? 1.0 : -1.0;
    return crossfield::EllipsePiece(
      this->At(axes.Location().XYZ()), axis, minor / major, sign * begin, sign * end, origin);
  }

  std::vector<DrawingPiece> Spline(const TopoDS_Edge& edge, const std::string& origin) const
  {
    double begin = 0.0;
    double end = 0.0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, begin, end); // placed in space
    const Handle(Geom_TrimmedCurve) part = new Geom_TrimmedCurve(curve, begin, end);
    const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(part);
    if (spline->IsPeriodic())
    {
      spline->SetNotPeriodic();
    }
    std::vector<double> knots;
    for (int i = 1; i <= spline->NbKnots(); ++i)
    {
      knots.insert(knots.end(), static_cast<std::size_t>(spline->Multiplicity(i)), spline->Knot(i));
    }
    std::vector<Point> points;
    std::vector<double> weights;
    for (int i = 1; i <= spline->NbPoles(); ++i)
    {
      points.push_back(this->At(spline->Pole(i).XYZ()));
      weights.push_back(spline->Weight(i));
    }
    return crossfield::SplitAtKinks(crossfield::NurbsPiece(
      spline->Degree(), std::move(knots), std::move(points), std::move(weights), origin));
  }

  const DomainPlane& Plane;
  Eigen::Matrix<double, 2, 3> Axes;
};

/** Returns the edges of a face that have a length. */
std::vector<TopoDS_Edge> EdgesOf(const TopoDS_Face& face)
{
  std::vector<TopoDS_Edge> edges;
  for (TopExp_Explorer explorer(face, TopAbs_EDGE); explorer.More(); explorer.Next())
  {
    const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
    if (!BRep_Tool::Degenerated(edge))
    {
      edges.push_back(edge);
    }
  }
  return edges;
}

/** Returns the plane of points along edges. */
DomainPlane PlaneOf(const std::vector<TopoDS_Edge>& edges)
{
  constexpr int Points = 5;
  Eigen::Matrix3Xd places(3, static_cast<Eigen::Index>(Points * edges.size()));
  Eigen::Index column = 0;
  for (const TopoDS_Edge& edge : edges)
  {
    const BRepAdaptor_Curve curve(edge);
    for (int i = 0; i < Points; ++i)
    {
      const double part = static_cast<double>(i) / (Points - 1);
      places.col(column++) = ToVector(
        curve.Value((1.0 - part) * curve.FirstParameter() + part * curve.LastParameter()).XYZ());
    }
  }
  return DomainPlane::Find(places);
}
}

//------------------------------------------------------------------------------
bool HasPlanarFace(const ModelFile& model)
{
  int count = 0;
  return !PlanarFaces(model.Shape(), count).empty();
}

//------------------------------------------------------------------------------
crossfield::Drawing DrawLargestFace(const ModelFile& model)
{
  int count = 0;
  const std::vector<PlanarFace> faces = PlanarFaces(model.Shape(), count);
  const std::vector<TopoDS_Edge> edges = EdgesOf(Largest(faces, model.File()).face);
  crossfield::Drawing drawing;
  drawing.unit = model.Unit();
  drawing.plane = PlaneOf(edges);
  const EdgeConversion conversion(drawing.plane);
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    const std::string origin = "edge " + std::to_string(i + 1) + " of the face";
    for (DrawingPiece& piece : conversion.Convert(edges[i], origin))
    {
      piece.name = crossfield::ToUtf8(model.NameOf(edges[i]));
      piece.origin = origin;
      drawing.pieces.push_back(std::move(piece));
    }
  }
  if (count > 1)
  {
    drawing.warnings.push_back("The largest planar face of '" + model.File() +
      "' was used; it has " + std::to_string(count) +
      " faces. All of them are a surface with AllFaces (--all-faces).");
  }
  return drawing;
}
