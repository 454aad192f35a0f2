#pragma once

// Part of PlanarMesher.cxx: the mesh from the triangulation.
#include "HilbertOrder.h"
#include "LatticeCore.h"
#include "MesherTriangulation.h"
#include "PlanarDomain.h"
#include "TriangleMesh.h"

#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/property_map.h>

#include <utility>

namespace crossfield::mesher
{
/// Returns whether a directed piece of a convex loop has the direction of the loop.
inline bool RunsAlong(const Loop& loop, const Point& from, const Point& to)
{
  const Point middle = 0.5 * (loop[0] + loop[loop.size() / 2]); // inside, because it is on a chord
  return (Cross(from - middle, to - middle) > 0.0) == (SignedArea(loop) > 0.0);
}

/// Extracts the triangles of the core and the faces of the domain in the order of a Hilbert curve
/// through their centroids. Neighbours are then close in memory, and in files, where zlib finds the
/// value of an edge in both of its triangles.
class MeshExtractor
{
public:
  MeshExtractor(const Triangulation& triangulation, const PlanarDomain& domain,
    const std::vector<BoundaryEdge>& loopMarks, const LatticeCore& core)
    : Domain(domain)
    , LoopMarks(loopMarks)
    , Core(core)
    , NumberInCore(core.GetLattice().Count(), None)
  {
    std::vector<Triangulation::Face_handle> faces;
    const std::vector<Place> order = this->Order(triangulation, faces);
    this->Mesh.triangles.reserve(order.size());
    const std::size_t inCore = core.GetTriangles().size();
    for (const Place& place : order)
    {
      if (place.second < inCore)
      {
        this->Add(core.GetTriangles()[place.second]);
      }
      else
      {
        this->Add(faces[place.second - inCore]);
      }
    }
  }

  TriangleMesh Release() { return std::move(this->Mesh); }

private:
  /// Centroid and index of a triangle; triangles of the core come first, then faces.
  using Place = std::pair<CgalPoint, std::size_t>;

  /// Returns the triangles in order and collects the faces of the domain.
  std::vector<Place> Order(
    const Triangulation& triangulation, std::vector<Triangulation::Face_handle>& faces) const
  {
    std::vector<Place> places;
    places.reserve(this->Core.GetTriangles().size() + triangulation.number_of_faces());
    for (const LatticeCore::Triangle& triangle : this->Core.GetTriangles())
    {
      const TriangularLattice& lattice = this->Core.GetLattice();
      places.emplace_back(
        ToCgal((lattice.At(triangle[0]) + lattice.At(triangle[1]) + lattice.At(triangle[2])) / 3.0),
        places.size());
    }
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
         ++face)
    {
      if (face->is_in_domain())
      {
        faces.push_back(face);
        places.emplace_back(CGAL::centroid(triangulation.triangle(face)), places.size());
      }
    }
    HilbertOrder(
      CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::First_of_pair_property_map<Place>>())
      .Sort(places.begin(), places.end());
    return places;
  }

  int Number(std::size_t inLattice)
  {
    int& number = this->NumberInCore[inLattice];
    if (number == None)
    {
      number = static_cast<int>(this->Mesh.points.size());
      this->Mesh.points.push_back(this->Core.GetLattice().At(inLattice));
    }
    return number;
  }

  int Number(const Triangulation::Vertex_handle& vertex)
  {
    VertexInfo& info = vertex->info();
    if (info.lattice != None)
    {
      info.number = this->Number(static_cast<std::size_t>(info.lattice));
    }
    else if (info.number == None)
    {
      info.number = static_cast<int>(this->Mesh.points.size());
      this->Mesh.points.push_back(FromCgal(vertex->point()));
    }
    return info.number;
  }

  void Add(const LatticeCore::Triangle& triangle)
  {
    this->Mesh.triangles.push_back(
      { this->Number(triangle[0]), this->Number(triangle[1]), this->Number(triangle[2]) });
  }

  void Add(const Triangulation::Face_handle& face)
  {
    this->Mesh.triangles.push_back({ this->Number(face->vertex(0)), this->Number(face->vertex(1)),
      this->Number(face->vertex(2)) });
    for (int i = 0; i < 3; ++i)
    {
      const auto from = face->vertex(Triangulation::ccw(i));
      const auto to = face->vertex(Triangulation::cw(i));
      if (face->is_constrained(i) && from->info().loop != None) // not on the border of the core
      {
        const auto loop = static_cast<std::size_t>(from->info().loop);
        BoundaryEdge edge = this->LoopMarks[loop];
        edge.vertices = { from->info().number, to->info().number };
        if (edge.kind != BoundaryKind::ImprintedCircle)
        {
          this->Mesh.boundary.push_back(edge);
        }
        else if (RunsAlong(
                   this->Domain.loops[loop], FromCgal(from->point()), FromCgal(to->point())))
        {
          // seen from the outside; the face inside has the same edge
          this->Mesh.imprinted.push_back(edge);
        }
      }
    }
  }

  const PlanarDomain& Domain;
  const std::vector<BoundaryEdge>& LoopMarks;
  const LatticeCore& Core;
  std::vector<int> NumberInCore; ///< Mesh vertex of each lattice point.
  TriangleMesh Mesh;
};
}
