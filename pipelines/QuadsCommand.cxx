/**
 * crossfield quads DOMAIN [-s S.csv] -o Q.vtu|Q.msh|Q.inp|Q.su2|Q.cgns|CASE/|...: makes an all-quad mesh with exactly
 * the chosen irregular nodes.
 *
 *   crossfield quads builtin:disk -s four.csv -o quads.vtu --quads 1000 --blocks blocks.vtm
 */
#include "BoundaryInput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "ListText.h"
#include "NumberCheck.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "QuadsOutput.h"
#include "SideOptions.h"
#include "SingularityInput.h"
#include "SweepOptions.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkExtrudeQuads.h"
#include "vtkQuadMeshWriter.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <limits>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct QuadsOptions
{
  BoundaryOptions boundary;
  SideOptions sides;
  SweepOptions sweep;
  std::string domain;
  std::string singularities;
  std::string corners;
  std::string output;
  std::string blocks;
  std::string layout;
  std::string json;
  std::string savedSingularities;
  double size = 0.0;
  double meshSize = 0.0;
  int quads = 1000;
  bool countIsGiven = false;
  std::vector<std::string> sizing = { "auto" };
  int merge = vtkQuadMesher::MergeNone;
  int prefer = vtkQuadMesher::PreferEnergy;
  int alternative = 0;
  double clearance = 0.0;
  int pairs = 0;
  bool capCorners = true;
  bool hold = false;
  double featureAngle = 35.0;
  double chordError = 0.0;
  bool repairHolonomy = false;
  double repairPart = 1.0;
  bool split = false;
  bool verbose = false;
  std::vector<std::string> layers;
  std::vector<std::string> cornerRows;
  int order = 1;
  int mshVersion = vtkQuadMeshWriter::Msh41;
  std::vector<std::string> patchTypes;
};

/** Returns the singularities that the mesh was made of, at the positions of their nodes. */
vtkDataSet* Singularities(vtkQuadMesher* mesher)
{
  return vtkDataSet::SafeDownCast(mesher->GetOutputDataObject(3));
}

/** Returns whether the boundary of a domain has curves. */
bool HasCurves(vtkAlgorithm* domain)
{
  return vtkDataSet::SafeDownCast(domain->GetOutputDataObject(0))
           ->GetCellData()
           ->GetAbstractArray(names::Curve) != nullptr;
}

const std::map<std::string, int> SizingsWithoutArray = { { "auto", vtkQuadMesher::SizingAutomatic },
  { "conformal", vtkQuadMesher::SizingConformal }, { "uniform", vtkQuadMesher::SizingUniform } };

void SetSizing(const QuadsOptions& options, vtkQuadMesher* mesher)
{
  const std::string& sizing = options.sizing[0];
  if (sizing == "field")
  {
    mesher->SetSizingToField();
    mesher->SetSizeArray(options.sizing[1]);
    mesher->SetQuadSize(options.countIsGiven ? 0.0 : 1.0); // factor of the array's lengths
  }
  else
  {
    mesher->SetSizing(SizingsWithoutArray.at(sizing));
  }
}

/** Returns an error message for options that contradict each other, empty if there are none. */
std::string CheckOptions(const QuadsOptions& options)
{
  const std::string& sizing = options.sizing[0];
  if (SizingsWithoutArray.count(sizing) == 0 && sizing != "field")
  {
    return "--sizing: there is no '" + sizing + "'; give auto, conformal, uniform or field NAME";
  }
  if (options.sizing.size() != (sizing == "field" ? 2U : 1U))
  {
    return "--sizing: give auto, conformal, uniform, or field and the name of a point array of the "
           "domain";
  }
  if (options.order > 2 && options.sweep.IsSet())
  {
    return "--order: quads of order 3 cannot be swept; give order 1 or 2";
  }
  if (!options.patchTypes.empty() && !vtkQuadMeshWriter::HasPatchTypes(options.output))
  {
    return "--patch-type: only a case of OpenFOAM has types of patches; give -o NAME/ or NAME.foam";
  }
  return sizing == "field" && options.size > 0.0
    ? "--sizing field has the sizes in the array; leave --size out, or give --quads"
    : "";
}

int Mesh(const QuadsOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable(
    { { options.output, ".vtu " + vtkQuadMeshWriter::GetEndings() }, { options.blocks, ".vtm" },
      { options.layout, ".vtp" }, { options.json, "" }, { options.savedSingularities, ".csv" } });
  OutputFile::RequireOrder(options.output, options.order);

  // 2. Read the domain and the configuration.
  BoundaryOptions boundary = options.boundary;
  boundary.sizes = options.sides.ReadSizes();
  boundary.kept = options.sides.PeriodicNames();
  boundary.curves = options.sides.CurvesText();
  const auto domain = BoundaryInput::Open(options.domain, options.meshSize, boundary);
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputConnection(domain->GetOutputPort());
  mesher->SetQuadSize(options.size);
  // Without a number, prescribed sizes decide it.
  const bool hasSizes = options.sides.HasSizes() || options.chordError > 0.0;
  mesher->SetQuadCount(options.countIsGiven || !hasSizes ? options.quads : 0);
  SetSizing(options, mesher);
  mesher->SetSideNameArray(options.boundary.names);
  mesher->SetMaterialArray(options.boundary.materials);
  mesher->SetLines(ListText::Join(options.boundary.lines));
  mesher->SetOpenLines(ListText::Join(options.boundary.openLines));
  options.sides.SetOn(mesher);
  mesher->SetMerge(options.merge);
  mesher->SetPrefer(options.prefer);
  mesher->SetAlternative(options.alternative);
  mesher->SetMeshSize(options.meshSize);
  mesher->SetCapCorners(options.capCorners);
  mesher->SetHoldSingularities(options.hold);
  mesher->SetFeatureAngle(options.featureAngle);
  mesher->SetChordError(options.chordError);
  mesher->SetRepairHolonomy(options.repairHolonomy || options.repairPart < 1.0);
  mesher->SetRepairPart(options.repairPart);
  mesher->SetSplitSingularities(options.split);
  mesher->SetPairs(options.pairs);
  mesher->SetClearance(options.clearance);
  mesher->SetLayers(ListText::Join(options.layers));
  mesher->SetCornerRows(ListText::Join(options.cornerRows));
  if (!options.singularities.empty())
  {
    mesher->SetSingularitiesConnection(
      OpenPointsOf(domain, options.singularities)->GetOutputPort());
  }
  if (!options.corners.empty())
  {
    mesher->SetCornersConnection(OpenPointsOf(domain, options.corners)->GetOutputPort());
  }

  // 3. Mesh.
  PipelineRun::Update(domain, "reading");
  if (!HasCurves(domain)) // a surface with sizes passes the simplification without them
  {
    mesher->SetCurves(boundary.curves);
  }
  PipelineRun::Update(mesher, "meshing");
  const vtkNew<vtkUnstructuredGrid> quads;
  mesher->CopyMesh(quads);
  if (options.order > 1)
  {
    vtkNew<vtkQuadsToHigherOrder> raiser;
    raiser->SetInputData(quads);
    raiser->SetSurfaceConnection(domain->GetOutputPort()); // of use if it is curved
    raiser->SetOrder(options.order);
    raiser->SetFeatureAngle(options.featureAngle);
    PipelineRun::Update(raiser, "curving");
    quads->ShallowCopy(raiser->GetOutput());
  }
  auto grids = vtkSmartPointer<vtkMultiBlockDataSet>(
    vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1)));
  if (const auto extruder = options.sweep.Make())
  {
    extruder->SetInputData(quads);
    PipelineRun::Update(extruder, "extruding");
    quads->ShallowCopy(extruder->GetOutput());
    grids = vtkMultiBlockDataSet::SafeDownCast(extruder->GetOutputDataObject(1));
  }

  // 4. Write.
  OutputTransaction outputs;
  OutputFile::WriteQuads(
    quads, options.output, options.mshVersion, ListText::Join(options.patchTypes), outputs);
  OutputFile::WriteIfNamed(mesher->GetOutputDataObject(2), options.layout, outputs);
  if (!options.blocks.empty())
  {
    OutputFile::Blocks blocks;
    for (unsigned int b = 0; b < grids->GetNumberOfBlocks(); ++b)
    {
      blocks.emplace_back("block" + std::to_string(b), grids->GetBlock(b));
    }
    OutputFile::WriteBlocks(blocks, options.blocks, outputs);
  }
  const bool hasHeight = vtkCrossFieldReport::HasHeight(domain->GetOutputDataObject(0));
  if (!options.savedSingularities.empty())
  {
    OutputFile::WriteConfiguration(
      Singularities(mesher), hasHeight, options.savedSingularities, outputs);
  }
  if (!options.json.empty())
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", quads);
    report->SetSource("singularities", Singularities(mesher));
    report->SetSource("domain", domain->GetOutputDataObject(0));
    report->SetSeconds({ mesher->GetStageSeconds(), mesher->GetStageSeconds() + 8 });
    outputs.Write(report->Write("quads"), options.json);
  }
  const bool prints = (options.json.empty() || options.verbose) && !outputs.PrintsData();
  if (prints)
  {
    BoundaryInput::Print(domain);
    PrintStretch(quads->GetFieldData());
    if (options.verbose)
    {
      PrintRepair(quads->GetFieldData());
      if (options.singularities.empty())
      {
        PrintChosen(Singularities(mesher), hasHeight);
      }
      else
      {
        PrintEvents(quads);
      }
    }
    QuadsOutput::Print(quads);
    if (options.verbose)
    {
      PrintAmbiguous(quads->GetFieldData());
      QuadsOutput::PrintSides(quads->GetFieldData());
    }
  }
  outputs.Commit();
  if (prints)
  {
    QuadsOutput::PrintFiles(
      { options.output, options.blocks, options.layout, options.savedSingularities, options.json });
  }
  const bool isInverted = FieldValue(quads, names::Inverted) > 0.0 ||
    (options.order > 1 && FieldValue(quads, names::CurvedInverted) > 0.0);
  return isInverted ? AnswerIsNo : Done;
}
}

void AddQuadsCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<QuadsOptions>();
  CLI::App* command = app.add_subcommand(
    "quads", "make an all-quad mesh with exactly the chosen irregular nodes, and its blocks");
  command->footer(
    "Example: crossfield quads builtin:disk -s four.csv -o quads.vtu --quads 1000 --json -");
  command->add_option("DOMAIN", options->domain, DomainReader::Help)->required();
  options->boundary.AddTo(*command);
  AddSingularitiesTo(*command, options->singularities);
  command
    ->add_option("-o,--output", options->output,
      "write the quads to this .vtu file, or .msh of Gmsh, .inp of Abaqus and CalculiX, .su2 of SU2, "
      ".cgns, .xyz of PLOT3D, .ex2 of Exodus or legacy .vtk, or into a case of OpenFOAM, a folder "
      "with / at its end or a .foam file in it; "
      "as .vtu to standard output for -")
    ->required();
  CLI::Option* size = command
                        ->add_option("--size", options->size,
                          "mean side length of the quads, positive; default: from --quads")
                        ->check(NumberCheck::Positive());
  CLI::Option* count =
    command
      ->add_option("--quads", options->quads, "target number of quads, positive; default: 1000")
      ->transform(NumberCheck::Whole(1, std::numeric_limits<int>::max()))
      ->excludes(size);
  command
    ->add_option("--sizing", options->sizing,
      "conformal: the sizes of the cross field, with the best shapes; uniform: the same size "
      "everywhere, for which singularities may move; field NAME: the lengths in a point array of the "
      "domain, or with --quads their proportions; auto: conformal if sizes are nearly uniform, "
      "or singularities are given and sizes not very different, "
      "otherwise uniform as far as the worst quad stays good; default: auto")
    ->expected(1, 2)
    ->type_name("WORD");
  command
    ->add_option("--names", options->boundary.names,
      "cell array of the domain's lines, strings or integers, with the names of the sides of the "
      "boundary; default: Side if the domain has it, otherwise outer0, outer1, ..., hole0, ... between "
      "corners")
    ->type_name("ARRAY");
  options->boundary.AddMaterialsTo(*command);
  options->boundary.AddLinesTo(*command);
  options->boundary.AddOpenLinesTo(*command);
  options->sides.AddTo(*command);
  const std::vector<std::pair<std::string, int>> merges = { { "none", vtkQuadMesher::MergeNone },
    { "clean", vtkQuadMesher::MergeClean }, { "coarse", vtkQuadMesher::MergeCoarse } };
  CLI::Option* merge =
    command
      ->add_option("--merge", options->merge,
        "separatrices that nearly meet: none keeps them apart; clean moves singularities until they "
        "meet, as far as the quads stay as good; coarse merges them in place, for the fewest blocks "
        "whose worst quad is at least half as good; default: none")
      ->transform(NumberCheck::Word(merges))
      ->type_name("WORD");
  command
    ->add_flag_callback(
      "--coarse", [options] { options->merge = vtkQuadMesher::MergeCoarse; },
      "short for --merge coarse")
    ->excludes(merge);
  const std::vector<std::pair<std::string, int>> preferences = { { "nodes",
                                                                   vtkQuadMesher::PreferNodes },
    { "blocks", vtkQuadMesher::PreferBlocks }, { "uniform", vtkQuadMesher::PreferUniform } };
  command
    ->add_option("--prefer", options->prefer,
      "what matters most where several configurations of singularities are chosen and each has quads "
      "as good: few irregular nodes, few blocks, or uniform sizes; default: low energy and "
      "symmetry")
    ->transform(NumberCheck::Word(preferences))
    ->type_name("WORD");
  command
    ->add_option("--alternative", options->alternative,
      "which of several chosen configurations is used, in the order of alternatives in the report; "
      "default: 0, the preferred one")
    ->transform(NumberCheck::Whole(0, 1000));
  command
    ->add_option("--mesh-size", options->meshSize,
      "target edge length of the triangles on which the map is computed, positive; default: 1/40 of "
      "the domain's diagonal")
    ->check(NumberCheck::Positive());
  command->add_option("--blocks", options->blocks, "write the structured blocks to this .vtm file");
  command->add_option(
    "--layout", options->layout, "write the sides of the blocks to this .vtp file");
  AddClearanceTo(
    *command, options->clearance, "0.7 of the size of quads, up to 1.5 at holes far from others");
  AddPairsTo(*command, options->pairs);
  AddCapCornersTo(*command, options->capCorners, "--cap-corners,!--no-cap-corners");
  command->add_flag("--hold", options->hold,
    "keep the nodes of given singularities where these are; otherwise they move where shapes or "
    "sizes are poor without this, and the report lists their moves");
  AddFeatureAngleTo(*command, options->featureAngle);
  command
    ->add_option("--chord-error", options->chordError,
      "on a surface in space, how far the centres of quads may be from it, positive: quads are small where it is curved")
    ->check(NumberCheck::Positive());
  AddRepairHolonomyTo(*command, options->repairHolonomy);
  command
    ->add_option("--repair-part", options->repairPart,
      "repair the holonomy, but move the singularities only this part of the way, 0 to 1: quads are "
      "then stretched by a part of what they would be; default: 1")
    ->check(CLI::Range(0.0, 1.0));
  command->add_flag("--split", options->split,
    "split singularities of quarter index 2 or more, or -2 or less, into ones of index 1 or -1, "
    "about 1.5 quads apart");
  command
    ->add_option("--layers", options->layers,
      "boundary layer of a side, or of all sides of holes for the name holes: height of the first row, "
      "normal to the wall (empty: that of the quads), maximum growth from row to row (default: 1.2) and "
      "number of rows (default: as many as the growth needs); may be repeated")
    ->type_name("NAME:[FIRST][,GROWTH[,ROWS]]")
    ->expected(1)
    ->take_all();
  command
    ->add_option("--corner", options->cornerRows,
      "what rows of quads do at the corner at a position, at corners with interior angles between two "
      "values in degrees, or at those of a side: end on the next side, turn around the corner, or "
      "leave it along a grid line; may be repeated")
    ->type_name("X,Y|ANGLE-ANGLE|NAME:end|turn|leave")
    ->expected(1)
    ->take_all();
  command
    ->add_option("--order", options->order,
      "order of the quads: 1, or 2 or 3 with boundary edges along the curves; default: 1")
    ->check(CLI::Range(1, 3));
  options->sweep.AddTo(*command);
  const std::vector<std::pair<std::string, int>> versions = { { "2.2", vtkQuadMeshWriter::Msh22 },
    { "4.1", vtkQuadMeshWriter::Msh41 } };
  command
    ->add_option("--msh-version", options->mshVersion,
      "version of a .msh file: 4.1, or 2.2 for programs such as gmshToFoam; default: 4.1")
    ->transform(NumberCheck::Word(versions))
    ->type_name("WORD");
  command
    ->add_option("--patch-type", options->patchTypes,
      "type of the patch of a side in a case of OpenFOAM, such as wall or symmetry; default: wall for "
      "sides with a boundary layer, patch for others; may be repeated")
    ->type_name("NAME:TYPE")
    ->expected(1)
    ->take_all();
  AddCornersTo(*command, options->corners);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->callback(
    [options, count, &status]
    {
      options->countIsGiven = count->count() > 0;
      options->sweep.Read();
      const std::string problem = CheckOptions(*options);
      if (!problem.empty())
      {
        throw CLI::ValidationError(problem);
      }
      status = Mesh(*options);
    });
}
