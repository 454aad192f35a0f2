#include "vtkDrawingReader.h"

#include "CadLibrary.h"
#include "DrawingConversion.h"
#include "DrawingFormats.h"
#include "DrawingLayers.h"
#include "DrawingOutline.h"
#include "DrawingRegions.h"
#include "Error.h"
#include "FilterRun.h"
#include "LineNetwork.h"
#include "PointTable.h"
#include "ReadAerofoil.h"
#include "SideText.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <vtksys/SystemTools.hxx>

#include <optional>

vtkStandardNewMacro(vtkDrawingReader);

namespace
{
using crossfield::DrawingFormat;

std::string EndingOf(const std::string& file)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(file));
}

crossfield::Drawing ReadFile(const std::string& file, const CadRequest& request)
{
  if (!vtksys::SystemTools::FileExists(file, true))
  {
    throw crossfield::Error("There is no file '" + file + "'; check the name of the drawing.");
  }
  if (CadLibrary::IsCad(EndingOf(file)))
  {
    return CadLibrary::Read(file, request);
  }
  const DrawingFormat format = crossfield::FormatOfEnding(EndingOf(file));
  return crossfield::ReadDrawing(format, PointTable::ReadFile(file), file);
}
}

//------------------------------------------------------------------------------
vtkDrawingReader::vtkDrawingReader()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkDrawingReader::CanReadFile(const char* fileName)
{
  if (fileName == nullptr || !vtksys::SystemTools::FileExists(fileName, true))
  {
    return 0;
  }
  const std::string ending = EndingOf(fileName);
  const DrawingFormat format = crossfield::FormatOfEnding(ending);
  if (format == DrawingFormat::Aerofoil)
  {
    return crossfield::IsAerofoil(PointTable::ReadFile(fileName)) ? 1 : 0;
  }
  return format != DrawingFormat::None || CadLibrary::IsCad(ending) ? 1 : 0;
}

//------------------------------------------------------------------------------
bool vtkDrawingReader::CanReadCad()
{
  return CadLibrary::IsAvailable();
}

//------------------------------------------------------------------------------
int vtkDrawingReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return FilterRun::Run(this, this->ErrorCode,
    [&](const crossfield::Progress& progress)
    {
      const double turn = this->SamplingAngle * crossfield::Pi / 180.0;
      crossfield::Drawing drawing = ReadFile(this->FileName, { this->AllFaces, turn });
      if (!drawing.surface.polygons.empty())
      {
        DrawingConversion::WriteSurface(drawing, vtkPolyData::GetData(outputVector));
        return;
      }
      crossfield::KeepLayers(SideText::ReadNames(this->Layers), drawing);
      constexpr double ReadShare = 0.5;
      progress.Report(ReadShare);
      const std::vector<crossfield::DrawnLine> lines =
        crossfield::TakeLines(SideText::ReadNames(this->Lines), this->JoinTolerance, turn, drawing);
      std::optional<crossfield::DrawingOutline> outline;
      const bool areRegions = this->ClosedCurvesAreRegions && drawing.faces.empty() &&
        crossfield::TraceRegions(
          this->JoinTolerance, turn, crossfield::ClosedCurves::Regions, drawing);
      if (!areRegions && drawing.faces.empty())
      {
        try
        {
          outline = crossfield::TraceOutline(drawing, this->JoinTolerance, turn);
        }
        catch (const crossfield::Error&)
        {
          // Curves that branch may bound regions.
          if (!crossfield::TraceRegions(
                this->JoinTolerance, turn, crossfield::ClosedCurves::Holes, drawing))
          {
            throw;
          }
        }
      }
      if (!outline)
      {
        DrawingConversion::WriteFaces(drawing, lines, vtkPolyData::GetData(outputVector));
      }
      else
      {
        DrawingConversion::WriteOutline(
          drawing, *outline, lines, vtkPolyData::GetData(outputVector));
      }
      for (const std::string& warning : outline ? outline->warnings : drawing.warnings)
      {
        vtkWarningMacro(<< warning);
      }
    });
}

//------------------------------------------------------------------------------
void vtkDrawingReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
  os << indent << "Layers: " << this->Layers << "\n";
  os << indent << "Lines: " << this->Lines << "\n";
  os << indent << "JoinTolerance: " << this->JoinTolerance << "\n";
  os << indent << "AllFaces: " << (this->AllFaces ? "on" : "off") << "\n";
  os << indent << "ClosedCurvesAreRegions: " << (this->ClosedCurvesAreRegions ? "on" : "off")
     << "\n";
  os << indent << "SamplingAngle: " << this->SamplingAngle << "\n";
}
