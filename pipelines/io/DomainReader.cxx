#include "DomainReader.h"

#include "IsolatedReading.h"
#include "ListText.h"
#include "PipelineRun.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkDrawingReader.h"
#include "vtkPlanarDomainReader.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkAlgorithm.h"
#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSTLReader.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <vtksys/SystemTools.hxx>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace
{
using PipelineRun::Error;

/** Sets the file of a reader, or the text if the reader supports one. */
template <class Reader>
auto SetInput(Reader* reader, const std::string& file, const std::string* text, int)
  -> decltype(reader->ReadFromInputStringOn())
{
  reader->SetFileName(file.c_str());
  if (text != nullptr)
  {
    reader->SetReadFromInputString(1);
    reader->SetInputString(*text);
  }
}
template <class Reader>
void SetInput(Reader* reader, const std::string& file, const std::string*, long)
{
  reader->SetFileName(file.c_str());
}

/** Reads the file, or the text if it was read already. */
template <class Reader>
vtkSmartPointer<vtkAlgorithm> Read(const std::string& file, const std::string* text = nullptr)
{
  vtkNew<Reader> reader;
  SetInput(reader.Get(), file, text, 0);
  try
  {
    return IsolatedReading::Read(file, reader);
  }
  catch (const Error& error)
  {
    // The VTKs of Debian 12 cannot parse files with appended data, for example.
    throw Error("The file '" + file + "' cannot be read (" + error.what() +
      "); check it, or save it again as binary or ASCII, not appended.");
  }
}

template <class Reader>
vtkSmartPointer<vtkAlgorithm> OpenWith(const std::string& file, const std::string* text = nullptr)
{
  auto source = Read<Reader>(file, text);
  auto* data = vtkDataSet::SafeDownCast(source->GetOutputDataObject(0));
  if (data == nullptr || data->GetNumberOfCells() == 0)
  {
    throw Error("The file '" + file + "' holds no cells; give boundary lines or a triangle mesh.");
  }
  return source;
}

/** Throws unless a line begins with three finite numbers: the readers of VTK would take 0 for others. */
void RequireNumbers(std::istream& words, int number, const std::string& file)
{
  for (int i = 0; i < 3; ++i)
  {
    double value = 0.0;
    if (!(words >> value))
    {
      throw Error("Line " + std::to_string(number) + " of '" + file +
        "' does not hold three finite numbers; correct it.");
    }
  }
}

/**
 * Throws if a property lacks words, for which vtkPLYReader would read uninitialised memory, or if a coordinate in ASCII is
 * not a number.
 */
void RequireProperties(const std::string& file)
{
  std::ifstream stream(file);
  std::string line;
  bool isText = false;
  bool beginsWithPoints = false; // x, y and z are the first properties of the first element
  long long points = 0;
  std::string properties;
  int number = 1;
  for (; std::getline(stream, line) && line.compare(0, 10, "end_header") != 0; ++number)
  {
    std::istringstream stringOfWords(line);
    const std::vector<std::string> words{ std::istream_iterator<std::string>(stringOfWords), {} };
    isText = isText || (words.size() > 1 && words[0] == "format" && words[1] == "ascii");
    if (words.size() > 2 && words[0] == "element" && points == 0 && properties.empty())
    {
      points = words[1] == "vertex" ? std::strtoll(words[2].c_str(), nullptr, 10) : -1;
    }
    if (words.size() == 3 && words[0] == "property")
    {
      properties += words[2];
      beginsWithPoints = beginsWithPoints || properties == "xyz";
    }
    if (!words.empty() && words[0] == "property" &&
      words.size() != (words.size() > 1 && words[1] == "list" ? 5 : 3))
    {
      throw Error("Line " + std::to_string(number) + " of '" + file +
        "' must be 'property TYPE NAME' or 'property list TYPE TYPE NAME'; correct it.");
    }
  }
  for (long long i = 0; isText && beginsWithPoints && i < points && std::getline(stream, line); ++i)
  {
    std::istringstream words(line);
    RequireNumbers(words, ++number, file);
  }
}

/** Throws if a coordinate is not a number: vtkOBJReader would read 0. */
void RequireNumbers(const std::string& file)
{
  std::ifstream stream(file);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v")
    {
      RequireNumbers(words, number, file);
    }
  }
}

/** Returns the text of a file, a pipe or a device. */
std::string ReadText(const std::string& file)
{
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/** Reads the loops of a table or an aerofoil from a file, or from a text that was read already. */
vtkSmartPointer<vtkAlgorithm> OpenLoops(const std::string& file, const std::string* text = nullptr)
{
  auto reader = vtkSmartPointer<vtkPlanarDomainReader>::New();
  reader->SetFileName(file);
  if (text != nullptr)
  {
    reader->ReadFromInputStringOn();
    reader->SetInputString(*text);
  }
  PipelineRun::Update(reader, "reading");
  return reader;
}

/** Reads a drawing. Open CASCADE may crash on a damaged model, so models are read in isolation. */
vtkSmartPointer<vtkAlgorithm> OpenDrawing(
  const std::string& file, const std::string& ending, const DomainReader::DrawingOptions& options)
{
  vtkNew<vtkDrawingReader> reader;
  reader->SetFileName(file);
  reader->SetLayers(ListText::Join(options.layers));
  reader->SetJoinTolerance(options.joinTolerance);
  reader->SetClosedCurvesAreRegions(options.closedCurvesAreRegions);
  reader->SetAllFaces(options.allFaces);
  reader->SetLines(ListText::Join(options.lines));
  if (ending == ".step" || ending == ".stp" || ending == ".brep")
  {
    try
    {
      return IsolatedReading::Read(file, reader);
    }
    catch (const IsolatedReading::Crash& crash)
    {
      throw Error("The model '" + file + "' cannot be read (" + crash.what() +
        "); export it again as .step or .brep.");
    }
  }
  PipelineRun::Update(reader, "reading");
  return reader.Get();
}

bool BeginsWith(const std::string& text, const std::string& part)
{
  return text.compare(0, part.size(), part) == 0;
}

/** Reads a pipe: only once, and without an ending that indicates the type. */
vtkSmartPointer<vtkAlgorithm> OpenStream(const std::string& file)
{
  const std::string text = ReadText(file);
  if (BeginsWith(text, "<?xml") || BeginsWith(text, "<VTKFile"))
  {
    return text.find("\"UnstructuredGrid\"") != std::string::npos
      ? OpenWith<vtkXMLUnstructuredGridReader>(file, &text)
      : OpenWith<vtkXMLPolyDataReader>(file, &text);
  }
  if (BeginsWith(text, "# vtk DataFile"))
  {
    return OpenWith<vtkGenericDataObjectReader>(file, &text);
  }
  return OpenLoops(file, &text);
}

/** Returns the file to read; "-" is standard input. */
std::string NameOfInput(const std::string& argument)
{
  return argument == "-" ? "/dev/stdin" : argument;
}

/** Returns whether a file is a pipe or a device. */
bool IsStream(const std::string& file)
{
  struct stat status = {};
  return stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}
}

namespace DomainReader
{
const char* const Help =
  "domain: boundary loops or a triangle mesh in a .vtp .vtu .vtk .stl .obj .ply file, a .csv file "
  "with the points x,y or x,y,z of loops, an aerofoil .dat, a drawing .dxf .svg .geojson .msh .poly .off .step "
  ".brep, - for standard input, or builtin:NAME (see `crossfield domain --help`)";

vtkSmartPointer<vtkAlgorithm> Open(
  const std::string& name, double edgeLength, const DrawingOptions& drawing)
{
  const std::string argument = NameOfInput(name);
  const std::string builtin = "builtin:";
  const bool isBuiltin = argument.compare(0, builtin.size(), builtin) == 0;
  const bool isFile = vtksys::SystemTools::FileExists(argument, true);
  const bool isDrawing =
    !isBuiltin && (!isFile || vtkDrawingReader::CanReadFile(argument.c_str()) != 0);
  if (!isDrawing && (!drawing.layers.empty() || drawing.closedCurvesAreRegions))
  {
    throw Error(std::string(drawing.layers.empty() ? "--materials curves" : "--drawing-layer") +
      ": the domain '" + argument + "' is no drawing; leave the option out.");
  }
  if (isBuiltin)
  {
    auto source = vtkSmartPointer<vtkPlanarDomainSource>::New();
    source->SetDomainName(argument.substr(builtin.size()));
    source->SetEdgeLength(edgeLength);
    return source;
  }
  if (!isFile)
  {
    throw Error("There is no file '" + argument + "'; check the name of the domain.");
  }
  if (IsStream(argument))
  {
    return OpenStream(argument);
  }
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(argument));
  if (ending == ".vtp")
  {
    return OpenWith<vtkXMLPolyDataReader>(argument);
  }
  if (ending == ".vtu")
  {
    return OpenWith<vtkXMLUnstructuredGridReader>(argument);
  }
  if (ending == ".vtk")
  {
    return OpenWith<vtkGenericDataObjectReader>(argument);
  }
  if (ending == ".stl")
  {
    return OpenWith<vtkSTLReader>(argument);
  }
  if (ending == ".obj")
  {
    RequireNumbers(argument);
    return OpenWith<vtkOBJReader>(argument);
  }
  if (ending == ".ply")
  {
    RequireProperties(argument);
    return OpenWith<vtkPLYReader>(argument);
  }
  if (vtkDrawingReader::CanReadFile(argument.c_str()) != 0)
  {
    return OpenDrawing(argument, ending, drawing);
  }
  if (ending == ".csv" || ending == ".dat")
  {
    return OpenLoops(argument);
  }
  throw Error("The domain '" + argument +
    "' has an unknown ending; give a .vtp, .vtu, .vtk, .stl, .obj, .ply, .csv, .dat, .dxf, .svg, .geojson, .msh, "
    ".poly, .off, .step or .brep file.");
}

vtkSmartPointer<vtkAlgorithm> OpenPoints(const std::string& name)
{
  const std::string file = NameOfInput(name);
  if (vtksys::SystemTools::FileExists(file, true) &&
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file)) == ".vtp")
  {
    return Read<vtkXMLPolyDataReader>(file);
  }
  auto source = vtkSmartPointer<vtkSingularitySource>::New();
  source->SetFileName(file);
  return source;
}

bool IsDrilled(vtkDataObject* domain)
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(domain);
  return grid != nullptr &&
    grid->GetCellData()->GetArray(vtkCrossFieldArrayNames::BoundaryKind) != nullptr;
}

std::array<double, 6> Bounds(vtkDataSet* domain)
{
  vtkBoundingBox box;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < domain->GetNumberOfCells(); ++cell)
  {
    domain->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; ids->GetNumberOfIds() > 1 && i < ids->GetNumberOfIds(); ++i)
    {
      box.AddPoint(domain->GetPoint(ids->GetId(i)));
    }
  }
  std::array<double, 6> bounds{};
  box.GetBounds(bounds.data());
  return bounds;
}
}
