/**
 * crossfield drill DOMAIN [-s S.csv] -o F.vtu: triangulates a domain with a hole at every
 * singularity.
 *
 *   crossfield drill builtin:disk -s four.csv -o drilled.vtu --size 0.05
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkDrillHoles.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace
{
struct DrillCommandOptions : MeshOptions
{
  std::string mode = "perforate";
  std::string savedSingularities;
};
}

void AddDrillCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<DrillCommandOptions>();
  CLI::App* command =
    app.add_subcommand("drill", "triangulate a domain with a hole at every singularity");
  command->footer("Example: crossfield drill builtin:disk -s four.csv -o drilled.vtu --size 0.05");
  options->AddTo(*command);
  command->get_option("--output")->required();
  AddModeTo(*command, options->mode);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  command->callback(
    [options, &status]
    {
      // 1. Check the output before any work.
      OutputFile::RequireWritable(
        { { options->output, ".vtu" }, { options->savedSingularities, ".csv" } });

      // 2. Read the domain and the configuration.
      const auto domain = BoundaryInput::Open(options->domain, options->size, options->boundary);
      SingularityInput singularities(options->singularities, domain, options->size, "");
      singularities.Update();

      // 3. Mesh.
      vtkNew<vtkDrillHoles> drill;
      drill->SetInputConnection(domain->GetOutputPort());
      drill->SetSingularitiesConnection(singularities.GetOutputPort());
      drill->SetMeshSize(options->size);
      drill->SetMode(DrillModeCode(options->mode));
      PipelineRun::Update(drill, "drilling");

      // 4. Write the mesh.
      OutputTransaction outputs;
      OutputFile::Write(drill->GetOutput(), options->output, outputs);
      singularities.Save(options->savedSingularities, outputs);
      if (!outputs.PrintsData())
      {
        BoundaryInput::Print(domain);
        singularities.PrintChoice(options->verbose);
        std::cout << options->output << ": " << CountTriangles(drill->GetOutput())
                  << " triangles\n";
      }
      outputs.Commit();
      status = Done;
    });
}
