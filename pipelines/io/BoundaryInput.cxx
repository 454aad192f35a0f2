#include "BoundaryInput.h"

#include "DomainReader.h"
#include "vtkBoundarySimplifier.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <optional>

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
}

void BoundaryOptions::AddTo(CLI::App& command)
{
  command
    .add_option("--thin-boundary", this->thinning,
      "remove boundary detail below this length, 0 for none; default: 0.02 of the target edge "
      "length")
    ->check(CLI::NonNegativeNumber);
  command
    .add_option("--smooth-boundary", this->smoothing,
      "smooth ragged boundaries: waves below this length, positive; default: no smoothing")
    ->check(CLI::PositiveNumber);
}

namespace BoundaryInput
{
vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double size, const BoundaryOptions& options)
{
  auto simplifier = vtkSmartPointer<vtkBoundarySimplifier>::New();
  simplifier->SetInputConnection(DomainReader::Open(name, size)->GetOutputPort());
  simplifier->SetMeshSize(size);
  simplifier->SetThinningLength(options.thinning);
  simplifier->SetSmoothingLength(options.smoothing);
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
  if (const std::optional<Change> change = ChangeOf(domain))
  {
    std::cout << "The boundary has " << change->after << " of " << change->before
              << " points and was moved by at most " << change->moved << ".\n";
  }
}
}
