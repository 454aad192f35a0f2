#include "ModelFile.h"

#include "Error.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_AsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <ios>
#include <iostream>
#include <map>
#include <sstream>

namespace
{
/** Names of a unit: in the report, and in Open CASCADE. */
struct UnitNames
{
  const char* reported;
  const char* parameter;
};

/** Returns the names of a unit of a .step file; null if it is not known. */
const UnitNames* FindUnit(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  static const std::map<std::string, UnitNames> Units = { { "millimetre", { "mm", "MM" } },
    { "metre", { "m", "M" } }, { "centimetre", { "cm", "CM" } }, { "micrometre", { "µm", "UM" } },
    { "kilometre", { "km", "KM" } }, { "inch", { "in", "INCH" } }, { "foot", { "ft", "FT" } },
    { "mile", { "mi", "MI" } }, { "mil", { "mil", "MIL" } } };
  const auto found = Units.find(text);
  return found == Units.end() ? nullptr : &found->second;
}

/** Drops what Open CASCADE prints on standard output, which belongs to the results of the program. */
class QuietOutput
{
public:
  QuietOutput()
    : Original(std::cout.rdbuf(this->Dropped.rdbuf()))
  {
  }
  ~QuietOutput() { std::cout.rdbuf(this->Original); }
  QuietOutput(const QuietOutput&) = delete;
  QuietOutput& operator=(const QuietOutput&) = delete;

private:
  std::ostringstream Dropped;
  std::streambuf* Original;
};

[[noreturn]] void Refuse(const std::string& file)
{
  throw crossfield::Error(
    "The model '" + file + "' is damaged or empty; export it again as .step or .brep.");
}
}

//------------------------------------------------------------------------------
ModelFile::ModelFile(const std::string& file)
  : Name(file)
{
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer));
  const std::size_t dot = file.rfind('.');
  const bool isBrep = dot != std::string::npos && (file[dot + 1] == 'b' || file[dot + 1] == 'B');
  isBrep ? this->ReadBrep() : this->ReadStep();
  if (this->Model.IsNull())
  {
    Refuse(file);
  }
}

//------------------------------------------------------------------------------
void ModelFile::ReadStep()
{
  this->Reader = std::make_unique<STEPControl_Reader>();
  if (this->Reader->ReadFile(this->Name.c_str()) != IFSelect_RetDone)
  {
    Refuse(this->Name);
  }
  TColStd_SequenceOfAsciiString lengths;
  TColStd_SequenceOfAsciiString angles;
  TColStd_SequenceOfAsciiString solidAngles;
  this->Reader->FileUnits(lengths, angles, solidAngles);
  const UnitNames* unit = lengths.IsEmpty() ? nullptr : FindUnit(lengths.First().ToCString());
  // Open CASCADE converts coordinates to this unit. Unknown units become millimetres.
  Interface_Static::SetCVal("xstep.cascade.unit", unit != nullptr ? unit->parameter : "MM");
  this->UnitOfFile = unit != nullptr ? unit->reported : "mm";
  this->Reader->TransferRoots();
  this->Model = this->Reader->OneShape();
}

//------------------------------------------------------------------------------
void ModelFile::ReadBrep()
{
  // Open CASCADE searches for words beyond the end of a file for ever, unless the stream throws.
  std::ifstream stream(this->Name, std::ios::binary);
  stream.exceptions(std::ios::failbit | std::ios::badbit);
  const QuietOutput quiet;
  const BRep_Builder builder;
  try
  {
    BRepTools::Read(this->Model, stream, builder);
  }
  catch (const std::ios::failure&)
  {
    Refuse(this->Name);
  }
}

//------------------------------------------------------------------------------
std::string ModelFile::NameOf(const TopoDS_Shape& shape) const
{
  if (!this->Reader)
  {
    return {};
  }
  const Handle(Standard_Transient) entity =
    this->Reader->WS()->TransferReader()->EntityFromShapeResult(shape, 1);
  const Handle(StepRepr_RepresentationItem) item =
    Handle(StepRepr_RepresentationItem)::DownCast(entity);
  if (item.IsNull() || item->Name().IsNull())
  {
    return {};
  }
  const std::string name = item->Name()->ToCString();
  return name == "NONE" ? std::string() : name; // as some programs write for no name
}
