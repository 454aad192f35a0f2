#include "CommandLine.h"

#include "DomainReader.h"

#include "vtkCellType.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

void MeshOptions::AddTo(CLI::App& command)
{
  command.add_option("DOMAIN", this->domain, DomainReader::Help)->required();
  command
    .add_option("-s,--singularities", this->singularities,
      "configuration: .csv with the header x,y,quarter_index[,radius]")
    ->required();
  command.add_option("-o,--output", this->output, "the .vtu file to write");
  command.add_option(
    "--size", this->size, "target edge length; default: 1/40 of the domain's diagonal");
}

long long CountTriangles(vtkUnstructuredGrid* mesh)
{
  long long count = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    count += mesh->GetCellType(cell) == VTK_TRIANGLE ? 1 : 0;
  }
  return count;
}
