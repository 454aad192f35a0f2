#include "FoamMesh.h"

#include "ElementNodes.h"
#include "Error.h"
#include "FormatNames.h"
#include "SidePairs.h"

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
  FaceWriting(const SolverMesh& mesh, const MeshFaces& faces, FoamMesh& result)
    : Mesh(mesh)
    , Faces(faces)
    , OfSide(faces.OfSides())
    , Numbering(mesh, NodeOrder::Abaqus, 0)
    , Added(faces.Count(), -1)
    , Result(result)
  {
    this->Result.point = this->Numbering.UsedPoints();
    this->Result.starts = { 0 };
    this->RequireFaces();
    const std::size_t count = faces.Count(); // each inner face twice
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
        const int partner = this->Faces.PartnerOf(this->Faces.NumberOf({ cell, face }));
        const int other = partner < 0 ? -1 : this->Faces.FaceOf(Index(partner)).cell;
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
    for (const SidePair& pair : this->Mesh.pairs)
    {
      const PairMatch match = MatchPair(this->Mesh, this->Faces, pair);
      const std::vector<CellFace>& first = this->Faces.OfSide(pair.first);
      const std::vector<CellFace>& second = this->Faces.OfSide(pair.second);
      for (std::size_t i = 0; i < first.size(); ++i)
      {
        const CellFace& image = second[match.faces[i]];
        this->OfSide[pair.second][i] = image;
        this->FirstCorner[this->Faces.NumberOf(image)] = this->Numbering.NumberOf(
          match.nodes.at(this->Numbering.UsedPoints()[this->Numbering.OfFace(first[i])[0]]));
      }
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
        if (patchOf[side] != static_cast<int>(patch) ||
          this->Faces.IsInside(static_cast<int>(side)))
        {
          continue;
        }
        for (const CellFace& face : this->OfSide[side])
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
      this->Result.cellZones[this->Mesh.region[cell]].members.push_back(cell);
    }
    const std::vector<std::string> sides = FormatNames(this->Mesh.sideNames, {});
    for (std::size_t side = 0; side < sides.size(); ++side)
    {
      if (this->Faces.IsInside(static_cast<int>(side)))
      {
        this->Result.faceZones.push_back({ sides[side], this->InnerFaces(side) });
      }
    }
  }

private:
  void RequireFaces() const
  {
    for (std::size_t i = 0; i < this->Faces.Count(); ++i)
    {
      const int partner = this->Faces.PartnerOf(i);
      if (partner < 0)
      {
        continue;
      }
      const bool isPair = this->Faces.PartnerOf(Index(partner)) == static_cast<int>(i);
      if (!isPair || this->Faces.FaceOf(i).cell == this->Faces.FaceOf(Index(partner)).cell)
      {
        throw Error("The face at " + PlaceOf(this->Mesh, this->Faces.KeyOf(i)[0]) +
          (isPair ? " occurs twice in a cell; use more layers."
                  : " is between more than two cells, which OpenFOAM cannot have."));
      }
    }
  }

  void Add(const CellFace& face)
  {
    std::vector<int> nodes = this->Numbering.OfFace(face);
    const auto first = this->FirstCorner.find(this->Faces.NumberOf(face));
    if (first != this->FirstCorner.end())
    {
      std::rotate(nodes.begin(), std::find(nodes.begin(), nodes.end(), first->second), nodes.end());
    }
    this->Result.corners.insert(this->Result.corners.end(), nodes.begin(), nodes.end());
    this->Added[this->Faces.NumberOf(face)] = static_cast<int>(this->Result.owner.size());
    this->Result.starts.push_back(static_cast<int>(this->Result.corners.size()));
    this->Result.owner.push_back(face.cell);
  }

  /// Returns the numbers of the faces of a side that is inside.
  std::vector<int> InnerFaces(std::size_t side) const
  {
    std::vector<int> faces;
    for (const CellFace& face : this->OfSide[side])
    {
      const std::size_t own = this->Faces.NumberOf(face);
      const int partner = this->Faces.PartnerOf(own);
      if (partner < 0)
      {
        throw Error("The side '" + this->Mesh.sideNames[side] +
          "' is in part on the boundary and in part inside; give the parts two names.");
      }
      faces.push_back(std::max(this->Added[own], this->Added[partner]));
    }
    return faces;
  }

  const SolverMesh& Mesh;
  const MeshFaces& Faces;
  /// Per side its faces; those of the second of periodic sides in the order of their partners.
  std::vector<std::vector<CellFace>> OfSide;
  const ElementNodes Numbering;
  std::map<std::size_t, int>
    FirstCorner; ///< Per face of a cyclic patch, the number of its first node.
  std::vector<int>
    Added; ///< Per face of a cell its number in the result, −1 if it is that of its partner.
  FoamMesh& Result;
};
}

std::vector<FoamPatch> FoamPatches(const SolverMesh& mesh, std::vector<int>& patchOf)
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
    names.push_back(mesh.sideNames[side]);
    const auto given = mesh.patchTypes.find(mesh.sideNames[side]);
    types.emplace_back(isEnd ? "wedge" : given != mesh.patchTypes.end() ? given->second : "patch");
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
  for (const SidePair& pair : mesh.pairs)
  {
    FoamPatch& first = patches[patchOf[pair.first]];
    FoamPatch& second = patches[patchOf[pair.second]];
    first.type = second.type = "cyclic";
    first.neighbour = second.name;
    second.neighbour = first.name;
  }
  return patches;
}

FoamMesh MakeFoamMesh(const SolverMesh& mesh, const MeshFaces& faces)
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
