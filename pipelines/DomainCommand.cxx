/**
 * crossfield domain NAME -o F.vtp: writes a built-in domain.
 *
 *   crossfield domain ring --inner-radius 0.46 -o ring.vtp
 */
#include "CommandLine.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkPlanarDomainSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <memory>

void AddDomainCommand(CLI::App& app, int& status)
{
  struct Options
  {
    std::string name;
    std::string output;
    double radius = 1.0;
    double innerRadius = 0.4;
    double width = 2.0;
    double height = 1.0;
    double edgeLength = 0.0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("domain", "write a built-in domain");
  command->footer("Example: crossfield domain ring --inner-radius 0.46 -o ring.vtp");
  command
    ->add_option("NAME", options->name,
      "name of the domain: disk, ring, ellipse, quarter-disk, square, rectangle, l-shape, "
      "hexagonal, star, "
      "angular-balanced, angular-negative, angular-positive or angular-hole")
    ->required();
  command
    ->add_option("-o,--output", options->output,
      "write the boundary loops to this .vtp file, or to standard output for -")
    ->required();
  command
    ->add_option("--radius", options->radius,
      "radius of disk, ring, quarter-disk, hexagonal and star, positive")
    ->capture_default_str();
  command
    ->add_option("--inner-radius", options->innerRadius,
      "radius of the hole of ring, or of the notches of star, positive and smaller than the radius")
    ->capture_default_str();
  command
    ->add_option("--width", options->width,
      "width of ellipse, square, rectangle, l-shape and the angular domains, positive")
    ->capture_default_str();
  command->add_option("--height", options->height, "height of ellipse and rectangle, positive")
    ->capture_default_str();
  command->add_option("--size", options->edgeLength,
    "length of the segments that approximate curves, positive; default: 1/40 of the domain's "
    "diagonal");
  command->callback(
    [options, &status]
    {
      // 1. Check the output before any work.
      OutputFile::RequireWritable({ { options->output, ".vtp" } });

      // 2. Build the boundary loops.
      vtkNew<vtkPlanarDomainSource> source;
      source->SetDomainName(options->name);
      source->SetRadius(options->radius);
      source->SetInnerRadius(options->innerRadius);
      source->SetWidth(options->width);
      source->SetHeight(options->height);
      source->SetEdgeLength(options->edgeLength);
      PipelineRun::Update(source, "domain");

      // 3. Write them.
      OutputTransaction outputs;
      OutputFile::Write(source->GetOutput(), options->output, outputs);
      outputs.Commit();
      status = Done;
    });
}
