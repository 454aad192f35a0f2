#include "NodePairs.h"

#include "Error.h"
#include "QuadSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Distance up to which two points are the same end of periodic sides, relative to their loop: ten
/// times that of the sides.
constexpr double SamePlace = 10.0 * PairReach;

/// Moves the first point of a pair along its side to the position halfway to the image of the second.
void MoveHalfway(
  const BoundaryCurves& curves, const PairedSides& pair, const QuadPoint& second, QuadPoint& point)
{
  const double loop = curves.Length(point.curve.loop);
  const SpacePoint image = pair.motion.Inverse().ImageOf(second.place);
  const double length =
    curves.ImageOn(pair, 0, point.curve.loop, second.curve, image).at - point.curve.at;
  point.curve.at += 0.5 * (length - loop * std::round(length / loop));
  point.MoveToCurve(curves);
}

/// Pairs the points of two loops, of which each has its first point at the end again: those with the
/// smallest sum of squared distances between points and the images of their partners. Points that are fixed at
/// the same place on both sides are partners. Throws Error if there are none.
void PairAround(const BoundaryCurves& curves, const QuadMesh& mesh, const std::vector<int>& first,
  const std::vector<int>& second, PairedSides& pair)
{
  const std::size_t count = first.size() - 1;
  const double reach = SamePlace * curves.Length(mesh.points[first[0]].curve.loop);
  const auto imageOf = [&](std::size_t i, std::size_t turn)
  { return second[(turn + count - i) % count]; };
  std::vector<SpacePoint> images;
  std::vector<int> partner(count, -1); // fixed at the same place
  for (std::size_t i = 0; i < count; ++i)
  {
    const QuadPoint& point = mesh.points[first[i]];
    images.push_back(pair.motion.ImageOf(point.place));
    for (std::size_t j = 0; j < count && point.fixed; ++j)
    {
      const QuadPoint& other = mesh.points[second[j]];
      const bool isThere = other.fixed && (other.place - images[i]).norm() <= reach;
      partner[i] = isThere ? second[j] : partner[i];
    }
  }
  std::size_t best = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < count; ++turn)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < count && sum < smallest; ++i)
    {
      const int image = imageOf(i, turn);
      const bool areFixed = mesh.points[first[i]].fixed && mesh.points[image].fixed;
      const bool isAllowed = partner[i] < 0 ? !areFixed : image == partner[i];
      sum += isAllowed ? (mesh.points[image].place - images[i]).squaredNorm()
                       : std::numeric_limits<double>::infinity();
    }
    if (sum < smallest)
    {
      smallest = sum;
      best = turn;
    }
  }
  if (std::isinf(smallest))
  {
    throw Error(pair.name +
      " has fixed nodes at different places on its two sides; mesh all materials as one "
      "(MaterialArray none, --materials none).");
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    pair.nodes.push_back({ first[i], imageOf(i, best) });
  }
}

void MatchPair(
  const BoundaryCurves& curves, const PairedSides& pair, QuadPoint& first, QuadPoint& second)
{
  const RigidMotion& motion = pair.motion;
  if (pair.spans && first.fixed && second.fixed)
  {
    return; // ends of a slit, which are apart
  }
  const double distance = (motion.ImageOf(first.place) - second.place).norm();
  const bool isNear = distance <= SamePlace * curves.Length(first.curve.loop);
  if (second.fixed && !first.fixed)
  {
    first.place = motion.Inverse().ImageOf(second.place);
    first.curve = curves.ImageOn(pair, 0, first.curve.loop, second.curve, first.place);
    first.triangle = curves.TriangleAt(first.curve, first.triangle);
  }
  else if (first.fixed == second.fixed && !isNear)
  {
    MoveHalfway(curves, pair, second, first);
  }
  first.fixed = second.fixed = first.fixed || second.fixed;
  second.place = motion.ImageOf(first.place);
  second.curve = curves.ImageOn(pair, 1, second.curve.loop, first.curve, second.place);
  second.triangle = curves.TriangleAt(second.curve, second.triangle);
}
}

void FindPairs(const BoundaryCurves& curves, QuadMesh& mesh)
{
  for (PairedSides& pair : mesh.periodic)
  {
    const std::vector<int> first = PiecesOf(mesh, pair.first).front();
    const std::vector<int> second = PiecesOf(mesh, pair.second).front();
    if (first.size() != second.size())
    {
      throw Error("With the layers, the periodic sides '" + mesh.sideNames[pair.first] + "' and '" +
        mesh.sideNames[pair.second] + "' have " + std::to_string(first.size() - 1) + " and " +
        std::to_string(second.size() - 1) +
        " edges; give equal numbers of rows to the layers that end on them, or leave the pair out.");
    }
    pair.nodes.clear();
    if (pair.isClosed)
    {
      PairAround(curves, mesh, first, second, pair);
      continue;
    }
    for (std::size_t i = 0; i < first.size(); ++i)
    {
      pair.nodes.push_back({ first[i], second[second.size() - 1 - i] });
    }
  }
}

void MatchPairs(const BoundaryCurves& curves, QuadMesh& mesh)
{
  // Twice, because a corner may belong to two pairs.
  for (int round = 0; round < 2; ++round)
  {
    for (const PairedSides& pair : mesh.periodic)
    {
      for (const auto& [first, second] : pair.nodes)
      {
        if (first != second)
        {
          MatchPair(curves, pair, mesh.points[first], mesh.points[second]);
        }
      }
    }
  }
}

double LargestMismatch(const PairedSides& pair, const QuadMesh& mesh)
{
  double largest = 0.0;
  for (const auto& [first, second] : pair.nodes)
  {
    const SpacePoint image = pair.motion.ImageOf(mesh.points[first].place);
    largest = std::max(largest, (image - mesh.points[second].place).norm());
  }
  return largest;
}

double LargestMismatch(const QuadMesh& mesh)
{
  double largest = 0.0;
  for (const PairedSides& pair : mesh.periodic)
  {
    largest = std::max(largest, LargestMismatch(pair, mesh));
  }
  return largest;
}

void MovePairsTogether(const QuadMesh& mesh, std::vector<bool>& moves)
{
  for (const PairedSides& pair : mesh.periodic)
  {
    for (const auto& [first, second] : pair.nodes)
    {
      moves[first] = moves[second] = moves[first] && moves[second];
    }
  }
}

std::vector<int> CopyPairs(const QuadMesh& mesh, const std::vector<int>& number, QuadMesh& part)
{
  std::vector<int> singles;
  for (const PairedSides& pair : mesh.periodic)
  {
    PairedSides copied = pair;
    copied.nodes.clear();
    for (const auto& [first, second] : pair.nodes)
    {
      const int a = number[first];
      const int b = number[second];
      if (a >= 0 && b >= 0)
      {
        copied.nodes.push_back({ a, b });
      }
      else if (a >= 0 || b >= 0)
      {
        singles.push_back(std::max(a, b));
      }
    }
    part.periodic.push_back(std::move(copied));
  }
  return singles;
}
}
