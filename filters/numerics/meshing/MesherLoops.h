#pragma once

// Part of PlanarMesher.cxx: constrained triangulation of loops.
#include "Error.h"
#include "MesherTriangulation.h"
#include "TriangleMesh.h"

#include <utility>
#include <vector>

namespace crossfield::mesher
{
[[noreturn]] inline void ThrowTouching(const Point& point)
{
  throw Error("The boundary crosses or touches itself near " + Describe(point) +
    "; separate or remove the segments that meet there.");
}

/// Returns the place where a segment crosses a segment that was inserted, or else its start.
inline Point CrossingOf(const Triangulation& triangulation, const Point& from, const Point& to)
{
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end();
       ++edge)
  {
    if (triangulation.is_constrained(*edge))
    {
      const auto end = [&](int turn)
      { return FromCgal(edge->first->vertex((edge->second + turn) % 3)->point()); };
      const Point along = to - from;
      const Point other = end(2) - end(1);
      const double turn = Cross(along, other);
      const double part = Cross(end(1) - from, other) / turn;
      const double otherPart = Cross(end(1) - from, along) / turn;
      if (part > 0.0 && part < 1.0 && otherPart > 0.0 && otherPart < 1.0)
      {
        return from + part * along;
      }
    }
  }
  return from;
}

/// Inserts the segments of all loops. Throws Error if loops cross, overlap or touch.
inline Triangulation TriangulateLoops(const std::vector<Loop>& loops)
{
  Triangulation triangulation;
  std::size_t pointCount = 0;
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    std::vector<Triangulation::Vertex_handle> handles;
    Triangulation::Face_handle hint;
    for (const Point& point : loops[l])
    {
      handles.push_back(triangulation.insert(ToCgal(point), hint));
      hint = handles.back()->face();
      handles.back()->info().loop = static_cast<int>(l);
      if (triangulation.number_of_vertices() != ++pointCount)
      {
        ThrowTouching(point);
      }
    }
    for (std::size_t i = 0; i < handles.size(); ++i)
    {
      try
      {
        triangulation.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
      }
      catch (const Triangulation::Intersection_of_constraints_exception&)
      {
        ThrowTouching(CrossingOf(triangulation, loops[l][i], loops[l][(i + 1) % loops[l].size()]));
      }
    }
  }
  // A segment through another point is split there without an exception; the vertex then does not
  // have exactly two constrained edges.
  for (auto vertex = triangulation.finite_vertices_begin();
       vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    int constrained = 0;
    auto edge = triangulation.incident_edges(vertex);
    const auto end = edge;
    do
    {
      constrained += triangulation.is_constrained(*edge) ? 1 : 0;
    } while (++edge != end);
    if (constrained != 2)
    {
      ThrowTouching(FromCgal(vertex->point()));
    }
  }
  return triangulation;
}

/// Returns for each loop whether it is an imprinted circle, which separates nothing.
inline std::vector<bool> FindImprinted(const std::vector<BoundaryEdge>& loopMarks)
{
  std::vector<bool> imprinted;
  imprinted.reserve(loopMarks.size());
  for (const BoundaryEdge& mark : loopMarks)
  {
    imprinted.push_back(mark.kind == BoundaryKind::ImprintedCircle);
  }
  return imprinted;
}

/// Sets the depth of each face, the number of loops that enclose it, imprinted ones not counted.
/// Marks the faces of depth 1, the domain, for the mesher.
inline void ComputeDepths(Triangulation& triangulation, const std::vector<bool>& imprinted)
{
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
  {
    face->info().depth = None;
  }
  std::vector<Triangulation::Face_handle> current = { triangulation.infinite_face() };
  current.front()->info().depth = 0;
  for (int depth = 0; !current.empty(); ++depth)
  {
    std::vector<Triangulation::Face_handle> next;
    while (!current.empty())
    {
      const Triangulation::Face_handle face = current.back();
      current.pop_back();
      if (face->info().depth != depth)
      {
        continue; // reached on a shorter path in the meantime
      }
      face->set_in_domain(depth == 1);
      for (int i = 0; i < 3; ++i)
      {
        const Triangulation::Face_handle neighbour = face->neighbor(i);
        if (neighbour->info().depth == None)
        {
          // Loops do not touch, so both ends of a segment belong to the same loop.
          const bool crosses = triangulation.is_constrained({ face, i }) &&
            !imprinted[face->vertex(Triangulation::cw(i))->info().loop];
          neighbour->info().depth = depth + (crosses ? 1 : 0);
          (crosses ? next : current).push_back(neighbour);
        }
      }
    }
    current = std::move(next);
  }
}

/// Returns one point inside each inner loop: the centroid of the largest triangle there.
inline std::vector<CgalPoint> HoleSeeds(const Triangulation& triangulation, std::size_t loopCount)
{
  std::vector<double> areas(loopCount, 0.0);
  std::vector<CgalPoint> seeds(loopCount);
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end();
       ++face)
  {
    if (face->info().depth == 2)
    {
      // All corners of a triangle inside an inner loop are on that loop.
      const auto loop = static_cast<std::size_t>(face->vertex(0)->info().loop);
      const double area = triangulation.triangle(face).area();
      if (area > areas[loop])
      {
        areas[loop] = area;
        seeds[loop] = CGAL::centroid(triangulation.triangle(face));
      }
    }
  }
  std::vector<CgalPoint> result;
  for (std::size_t loop = 0; loop < loopCount; ++loop)
  {
    if (areas[loop] > 0.0)
    {
      result.push_back(seeds[loop]);
    }
  }
  return result;
}

/// Assigns the loop of a segment to the points that the mesher inserted on it.
inline void SpreadLoopNumbers(Triangulation& triangulation)
{
  std::vector<Triangulation::Vertex_handle> stack;
  for (auto vertex = triangulation.finite_vertices_begin();
       vertex != triangulation.finite_vertices_end(); ++vertex)
  {
    if (vertex->info().loop != None)
    {
      stack.push_back(vertex);
    }
  }
  while (!stack.empty())
  {
    const Triangulation::Vertex_handle vertex = stack.back();
    stack.pop_back();
    auto edge = triangulation.incident_edges(vertex);
    const auto end = edge;
    do
    {
      if (triangulation.is_constrained(*edge))
      {
        for (int other : { Triangulation::cw(edge->second), Triangulation::ccw(edge->second) })
        {
          const auto neighbour = edge->first->vertex(other);
          if (neighbour->info().loop == None)
          {
            neighbour->info().loop = vertex->info().loop;
            stack.push_back(neighbour);
          }
        }
      }
    } while (++edge != end);
  }
}
}
