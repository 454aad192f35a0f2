#include "BoundaryInput.h"

#include "ListText.h"
#include "NumberCheck.h"
#include "vtkBoundarySimplifier.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <optional>
#include <string>

namespace
{
namespace names = vtkCrossFieldArrayNames;

/** Changes to the boundary. */
struct Change
{
  long long before = 0; ///< Number of points before.
  long long after = 0;  ///< Number of points after.
  double moved = 0.0;   ///< Maximum distance that the boundary was moved.
};

/** Returns the changes to the boundary, if there are any. */
std::optional<Change> ChangeOf(vtkAlgorithm* domain)
{
  vtkFieldData* data = domain->GetOutputDataObject(0)->GetFieldData();
  vtkDataArray* points = data->GetArray(names::BoundaryPoints);
  vtkDataArray* moved = data->GetArray(names::BoundaryMoved);
  if (points == nullptr || moved == nullptr)
  {
    return std::nullopt;
  }
  return Change{ static_cast<long long>(points->GetComponent(0, 0)),
    static_cast<long long>(points->GetComponent(1, 0)), moved->GetComponent(0, 0) };
}

/** Adds an option with a name that may be repeated. */
void AddNames(CLI::App& command, const std::string& option, std::vector<std::string>& given,
  const std::string& help)
{
  command.add_option(option, given, help + "; may be repeated")
    ->type_name("NAME")
    ->expected(1)
    ->take_all();
}

/** Prints how many corners the boundary has no longer, and where the first of them was. */
void PrintRemovedCorners(vtkBoundarySimplifier* simplifier)
{
  vtkDataArray* removed =
    simplifier->GetOutputDataObject(0)->GetFieldData()->GetArray(names::BoundaryRemovedCorners);
  if (removed != nullptr)
  {
    const vtkIdType count = removed->GetNumberOfTuples();
    const double* first = removed->GetTuple3(0);
    std::cout << (count == 1 ? "A corner of the boundary at ("
                             : std::to_string(count) + " corners of the boundary, the first at (")
              << first[0] << ", " << first[1] << (count == 1 ? ")" : "),")
              << " merged with others nearby"
              << (simplifier->GetSmoothingLength() > 0.0 ? " or were smoothed" : "")
              << "; --thin-boundary 0 retains all corners.\n";
  }
}
}

void BoundaryOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--part", this->part,
      "part of a domain of several separate parts: largest, a number from 1 for the largest, or the name of a "
      "side that one part alone has")
    ->type_name("NAME|N|largest");
  AddNames(command, "--drawing-layer", this->drawing.layers,
    "use the curves of this layer of a drawing only");
  command.add_flag("--all-faces", this->drawing.allFaces,
    "all faces of a .step or .brep model, as a surface in space; default: its largest planar face, if it has one");
  command
    .add_option("--thin-boundary", this->thinning,
      "remove boundary detail below this length, 0 for none; default: 0.02 of the target edge "
      "length")
    ->check(NumberCheck::NotNegative());
  command
    .add_option("--smooth-boundary", this->smoothing,
      "smooth ragged boundaries: waves below this length, positive; default: no smoothing")
    ->check(NumberCheck::Positive());
  command
    .add_option("--join-tolerance", this->drawing.joinTolerance,
      "join open ends of the curves of a drawing within this distance, positive; default: 1e-5 of "
      "the drawing's diagonal")
    ->check(NumberCheck::Positive());
}

void BoundaryOptions::AddMaterialsTo(CLI::App& command)
{
  this->materials.clear();
  command
    .add_option_function<std::string>(
      "--materials",
      [this](const std::string& name)
      {
        this->drawing.closedCurvesAreRegions = name == "curves";
        this->materials = this->drawing.closedCurvesAreRegions ? "" : name;
      },
      "cell array of a mesh, strings or integers, with the materials of its cells: singularities are counted and "
      "chosen for each material; curves: every closed curve of a drawing bounds a material, except those "
      "whose names begin with hole; none: one material; default: Material or Region if the domain has it")
    ->type_name("ARRAY");
}

void BoundaryOptions::AddLinesTo(CLI::App& command)
{
  AddNames(command, "--line", this->lines,
    "line inside of the domain along which quads are aligned, such as a weld or a line of "
    "measurements: the name of lines beside the boundary, or of a layer of a drawing");
}

void BoundaryOptions::AddOpenLinesTo(CLI::App& command)
{
  AddNames(command, "--open", this->openLines,
    "line inside of the domain, or line between two materials, whose two sides have nodes of their "
    "own, such as a crack or a contact");
}

namespace BoundaryInput
{
vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double size, const BoundaryOptions& options)
{
  auto simplifier = vtkSmartPointer<vtkBoundarySimplifier>::New();
  DomainReader::DrawingOptions drawing = options.drawing;
  drawing.lines = options.lines;
  drawing.lines.insert(drawing.lines.end(), options.openLines.begin(), options.openLines.end());
  simplifier->SetInputConnection(DomainReader::Open(name, size, drawing)->GetOutputPort());
  simplifier->SetLines(ListText::Join(drawing.lines));
  simplifier->SetPart(options.part);
  simplifier->SetMeshSize(size);
  simplifier->SetThinningLength(options.thinning);
  simplifier->SetSmoothingLength(options.smoothing);
  simplifier->SetSideNameArray(options.names);
  simplifier->SetMaterialArray(options.materials);
  simplifier->SetCurves(options.curves);
  for (const auto& [side, length] : options.sizes)
  {
    simplifier->AddSideSize(side, length);
  }
  for (const std::string& side : options.kept)
  {
    simplifier->AddKeptSide(side);
  }
  return simplifier;
}

void Keep(vtkAlgorithm* domain, vtkAlgorithm* points, int port)
{
  if (auto* simplifier = vtkBoundarySimplifier::SafeDownCast(domain))
  {
    simplifier->AddKeptConnection(points->GetOutputPort(port));
  }
}

void Keep(vtkAlgorithm* domain, const std::string& file)
{
  if (!file.empty())
  {
    Keep(domain, DomainReader::OpenPoints(file));
  }
}

void Print(vtkAlgorithm* domain)
{
  vtkFieldData* data = domain->GetOutputDataObject(0)->GetFieldData();
  if (auto* unit = vtkStringArray::SafeDownCast(data->GetAbstractArray(names::DrawingUnit)))
  {
    std::cout << "The unit of the drawing is " << unit->GetValue(0) << ".\n";
  }
  if (const std::optional<Change> change = ChangeOf(domain))
  {
    std::cout << "The boundary has " << change->after << " of " << change->before
              << " points and was moved by at most " << change->moved << ".\n";
    PrintRemovedCorners(vtkBoundarySimplifier::SafeDownCast(domain));
  }
}
}
