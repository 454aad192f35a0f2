#include "FoamMesh.h"

#include "CellLattice.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "PeriodicNodes.h"

#include <algorithm>
#include <map>

namespace crossfield
{
namespace
{
/// Adds the faces of a mesh.
class FaceWriting
{
public:
  FaceWriting(const ExportMesh& mesh, const MeshFaces& faces, FoamMesh& result)
    : Mesh(mesh)
    , Buckets(faces.buckets)
    , Partners(faces.partners)
    , Sides(faces.sides)
    , Result(result)
  {
    const CellLattice lattice(3, 1);
    for (int face = 0; face < lattice.FaceCount(); ++face)
    {
      this->Corners.push_back(lattice.FaceCorners(face));
    }
    MeshNumbering numbering = NumberNodes(mesh, lattice.AbaqusOrder(), 0);
    this->Number = std::move(numbering.number);
    this->Result.point = std::move(numbering.point);
    this->Result.starts = { 0 };
    this->RequireFaces();
    const std::size_t count = faces.partners.size(); // each inner face twice
    this->Result.owner.reserve(count);
    this->Result.neighbour.reserve(count / 2);
    this->Result.starts.reserve(count);
    this->Result.corners.reserve(4 * count);
  }

  void AddInner()
  {
    constexpr int FacesOfCell = 6;
    std::vector<std::array<int, 2>> upper; // neighbours and faces of a cell
    for (int cell = 0; cell < this->Mesh.CellCount(); ++cell)
    {
      upper.clear();
      for (int face = 0; face < FacesOfCell; ++face)
      {
        const int partner = this->Partners[this->Buckets.NumberOf({ cell, face })];
        const int other = partner < 0 ? -1 : this->Buckets.FaceOf(Index(partner)).cell;
        if (other > cell)
        {
          upper.push_back({ other, face });
        }
      }
      std::sort(upper.begin(), upper.end());
      for (const auto& [other, face] : upper)
      {
        this->Add({ cell, face });
        this->Result.neighbour.push_back(other);
      }
    }
  }

  /// Brings the faces of the second side of each periodic pair into the order of the first one.
  void MatchPeriodic()
  {
    for (const PeriodicPair& pair : this->Mesh.periodic)
    {
      std::map<int, int> images;
      for (const auto& [node, image] : PeriodicNodes(this->Mesh, pair))
      {
        images[node] = image;
      }
      std::map<FaceBuckets::Key, SideFace> second;
      for (const SideFace& face : this->Sides.ofSide[Index(pair.second)])
      {
        second[this->Buckets.KeyOf(this->Buckets.NumberOf(face))] = face;
      }
      std::vector<SideFace> ordered;
      for (const SideFace& face : this->Sides.ofSide[Index(pair.first)])
      {
        std::array<int, 4> corners{};
        for (std::size_t i = 0; i < corners.size(); ++i)
        {
          corners[i] = images.at(this->Mesh.Cell(face.cell)[this->Corners[Index(face.face)][i]]);
        }
        const auto match = second.find(FaceBuckets::MakeKey(corners.data(), corners.size()));
        if (match == second.end())
        {
          throw Error("The periodic sides '" + this->Mesh.sideNames[Index(pair.first)] + "' and '" +
            this->Mesh.sideNames[Index(pair.second)] +
            "' have different faces; make the mesh again.");
        }
        ordered.push_back(match->second);
        this->FirstCorner[this->Buckets.NumberOf(match->second)] = corners[0];
      }
      this->Sides.ofSide[Index(pair.second)] = ordered;
    }
  }

  void AddPatches()
  {
    std::vector<int> patchOf;
    std::vector<FoamPatch> patches = FoamPatches(this->Mesh, patchOf);
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
      patches[patch].start = static_cast<int>(this->Result.owner.size());
      for (std::size_t side = 0; side < patchOf.size(); ++side)
      {
        if (patchOf[side] != static_cast<int>(patch) || this->Sides.isInside[side])
        {
          continue;
        }
        for (const SideFace& face : this->Sides.ofSide[side])
        {
          this->Add(face);
        }
      }
      patches[patch].count = static_cast<int>(this->Result.owner.size()) - patches[patch].start;
      if (patches[patch].count > 0)
      {
        this->Result.patches.push_back(patches[patch]);
      }
    }
  }

  void AddZones()
  {
    const std::vector<std::string> names = FormatNames(this->Mesh.regionNames, {});
    for (std::size_t region = 0; region < names.size() && names.size() > 1; ++region)
    {
      this->Result.cellZones.push_back({ names[region], {} });
    }
    for (int cell = 0; cell < this->Mesh.CellCount() && names.size() > 1; ++cell)
    {
      this->Result.cellZones[Index(this->Mesh.region[Index(cell)])].members.push_back(cell);
    }
    const std::vector<std::string> sides = FormatNames(this->Mesh.sideNames, {});
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
      if (this->Sides.isInside[side])
      {
        this->Result.faceZones.push_back({ sides[side], this->InnerFaces(side) });
      }
    }
  }

private:
  void RequireFaces() const
  {
    for (std::size_t i = 0; i < this->Partners.size(); ++i)
    {
      const int partner = this->Partners[i];
      if (partner < 0)
      {
        continue;
      }
      const bool isPair = this->Partners[Index(partner)] == static_cast<int>(i);
      if (!isPair || this->Buckets.FaceOf(i).cell == this->Buckets.FaceOf(Index(partner)).cell)
      {
        throw Error("The face at " + PlaceOf(this->Mesh, this->Buckets.KeyOf(i)[0]) +
          (isPair ? " occurs twice in a cell; use more layers."
                  : " is between more than two cells, which OpenFOAM cannot have."));
      }
    }
  }

  void Add(const SideFace& face)
  {
    const int* nodes = this->Mesh.Cell(face.cell);
    this->Nodes.clear();
    for (const int position : this->Corners[Index(face.face)])
    {
      this->Nodes.push_back(nodes[position]);
    }
    RemoveRepeated(this->Nodes);
    const auto first = this->FirstCorner.find(this->Buckets.NumberOf(face));
    if (first != this->FirstCorner.end())
    {
      std::rotate(this->Nodes.begin(),
        std::find(this->Nodes.begin(), this->Nodes.end(), first->second), this->Nodes.end());
    }
    for (const int node : this->Nodes)
    {
      this->Result.corners.push_back(this->Number[Index(node)]);
    }
    this->Result.starts.push_back(static_cast<int>(this->Result.corners.size()));
    this->Result.owner.push_back(face.cell);
  }

  /// Returns the numbers of the faces of a side that is inside.
  std::vector<int> InnerFaces(std::size_t side) const
  {
    std::vector<int> faces;
    for (const SideFace& face : this->Sides.ofSide[side])
    {
      const int partner = this->Partners[this->Buckets.NumberOf(face)];
      if (partner < 0)
      {
        throw Error("The side '" + this->Mesh.sideNames[side] +
          "' is in part on the boundary and in part inside; give the parts two names.");
      }
      const int other = this->Buckets.FaceOf(Index(partner)).cell;
      const int owner = std::min(face.cell, other);
      const auto first = std::lower_bound(this->Result.owner.begin(),
        this->Result.owner.begin() + static_cast<std::ptrdiff_t>(this->Result.neighbour.size()),
        owner);
      auto number = static_cast<std::size_t>(first - this->Result.owner.begin());
      while (this->Result.neighbour[number] != std::max(face.cell, other))
      {
        ++number;
      }
      faces.push_back(static_cast<int>(number));
    }
    return faces;
  }

  const ExportMesh& Mesh;
  const FaceBuckets& Buckets;
  const std::vector<int>& Partners;
  SideFaces Sides; ///< Those of periodic sides in the order of their partners.
  std::vector<std::vector<int>> Corners;  ///< Per face of a cell, positions of its corners.
  std::vector<int> Number;                ///< Per point of the mesh, that of OpenFOAM.
  std::map<std::size_t, int> FirstCorner; ///< Per face of a cyclic patch, its first node.
  std::vector<int> Nodes;                 ///< Of a face.
  FoamMesh& Result;
};
}

std::vector<FoamPatch> FoamPatches(const ExportMesh& mesh, std::vector<int>& patchOf)
{
  const SweepEnds& sweep = mesh.sweep;
  const bool isLayer = sweep.layers == 1 && sweep.back >= 0 && sweep.front >= 0;
  const bool isFlat = isLayer && !sweep.isRotation;
  std::vector<std::string> names;
  std::vector<std::string> types;
  patchOf.clear();
  for (int side = 0; side < static_cast<int>(mesh.sideNames.size()); ++side)
  {
    const bool isEnd = isLayer && (side == sweep.back || side == sweep.front);
    if (isEnd && isFlat)
    {
      patchOf.push_back(-1);
      continue;
    }
    patchOf.push_back(static_cast<int>(names.size()));
    names.push_back(mesh.sideNames[Index(side)]);
    types.emplace_back(isEnd ? "wedge" : "patch");
  }
  if (isFlat)
  {
    std::replace(patchOf.begin(), patchOf.end(), -1, static_cast<int>(names.size()));
    names.emplace_back("frontAndBack");
    types.emplace_back("empty");
  }
  names = FormatNames(names, {});
  std::vector<FoamPatch> patches;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    patches.push_back({ names[i], types[i], "", 0, 0 });
  }
  for (const PeriodicPair& pair : mesh.periodic)
  {
    FoamPatch& first = patches[Index(patchOf[Index(pair.first)])];
    FoamPatch& second = patches[Index(patchOf[Index(pair.second)])];
    first.type = second.type = "cyclic";
    first.neighbour = second.name;
    second.neighbour = first.name;
  }
  return patches;
}

FoamMesh MakeFoamMesh(const ExportMesh& mesh, const MeshFaces& faces)
{
  FoamMesh result;
  FaceWriting writing(mesh, faces, result);
  writing.MatchPeriodic();
  writing.AddInner();
  writing.AddPatches();
  writing.AddZones();
  return result;
}
}
