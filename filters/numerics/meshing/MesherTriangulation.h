#pragma once

// Part of PlanarMesher.cxx.
#include "Plane.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <cstdint>

namespace crossfield::mesher
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr int None = -1;

/// Data of a vertex: its boundary loop, its index in the lattice if it is a border vertex of the
/// lattice's core, and its index in the extracted mesh.
struct VertexInfo
{
  int loop = None;
  std::int64_t lattice = None;
  int number = None;
};
/// Data of a face: the number of loops that enclose it.
struct FaceInfo
{
  int depth = None;
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<VertexInfo, Kernel,
  CGAL::Delaunay_mesh_vertex_base_2<Kernel>>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel,
  CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;
using CgalPoint = Triangulation::Point;

inline CgalPoint ToCgal(const Point& point)
{
  return { point.x(), point.y() };
}

inline Point FromCgal(const CgalPoint& point)
{
  return { point.x(), point.y() };
}
}
