#include "SideOptions.h"

#include "ListText.h"
#include "NumberCheck.h"
#include "PipelineRun.h"
#include "vtkQuadMesher.h"

#include <CLI/CLI.hpp>

#include <locale>
#include <sstream>
#include <utility>

namespace
{
/** Divides NAME:VALUE at the last colon, or before `both:`; the name may contain colons. */
std::pair<std::string, std::string> Divide(const std::string& option, const std::string& text)
{
  const std::string both = ":both:";
  std::size_t colon = text.rfind(both);
  colon = colon == std::string::npos ? text.rfind(':') : colon;
  if (colon == std::string::npos || colon == 0 || colon + 1 == text.size())
  {
    throw PipelineRun::Error(
      option + ": '" + text + "' has no name of a side or no value; give NAME:VALUE.");
  }
  return { text.substr(0, colon), text.substr(colon + 1) };
}

/** Returns the numbers of a text between commas; nothing if there is anything else. */
std::vector<double> ReadNumbers(const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  char comma = ',';
  double number = 0.0;
  while (comma == ',' && stream >> number)
  {
    numbers.push_back(number);
    comma = '\0';
    stream >> comma;
  }
  return stream.eof() && comma == '\0' ? numbers : std::vector<double>();
}

/** Adds the size of an entry of --size-near. */
void AddSizeNear(const std::string& text, vtkQuadMesher* mesher)
{
  const std::size_t colon = text.find(':');
  std::vector<double> place = ReadNumbers(text.substr(0, colon));
  std::vector<double> size =
    ReadNumbers(colon == std::string::npos ? std::string() : text.substr(colon + 1));
  const bool isRead =
    (place.size() == 2 || place.size() == 3) && (size.size() == 1 || size.size() == 2);
  place.resize(3, 0.0);
  size.resize(2, 0.0);
  if (!isRead || !(size[0] > 0.0) || !(size[1] >= 0.0))
  {
    throw PipelineRun::Error("--size-near: '" + text +
      "' is no position with a positive size; give X,Y:H or X,Y:H,RADIUS.");
  }
  mesher->AddSizeNear(place[0], place[1], place[2], size[0], size[1]);
}

/** Adds the position of an entry of --node. */
void AddNode(const std::string& text, vtkQuadMesher* mesher)
{
  std::vector<double> place = ReadNumbers(text);
  if (place.size() != 2 && place.size() != 3)
  {
    throw PipelineRun::Error("--node: '" + text + "' is no position; give X,Y or X,Y,Z.");
  }
  place.resize(3, 0.0);
  mesher->AddNode(place[0], place[1], place[2]);
}
}

void SideOptions::AddTo(CLI::App& command)
{
  const auto add = [&command](const char* option, std::vector<std::string>& values,
                     const char* help, const char* type)
  { command.add_option(option, values, help)->type_name(type)->allow_extra_args(false); };
  add("--count", this->counts, "number of edges along a side; repeatable", "NAME:N");
  add("--progression", this->progressions,
    "last edge of a side over the first, in the direction with the domain on the left; both: the same "
    "towards both ends; or the lengths FIRST,LAST of these edges; repeatable",
    "NAME:[both:]RATIO");
  add("--size-at", this->sizes,
    "length of the edges of a side, met within 20 %, from which sizes grow; repeatable", "NAME:H");
  add("--size-near", this->sizesNear,
    "target size of quads near a position, up to RADIUS from it, from where sizes grow; repeatable",
    "X,Y[,Z]:H[,RADIUS]");
  add("--size-in", this->sizesInside,
    "target size of quads in what a side encloses, which is a closed curve, and at its edges; repeatable",
    "NAME:H");
  command.add_option("--growth", this->growth,
    "largest ratio of target sizes of neighbours, above 1, where sizes grow; default: 1.25");
  add("--periodic", this->periodic,
    "sides that are images of each other under a translation or rotation, such as those of a rotor's "
    "sector: they get equal numbers of edges and nodes that match; repeatable",
    "A:B");
  add("--curve", this->curves,
    "curve that a side stands for, on which its nodes are placed: circle, ellipse, spline (cubic "
    "through its points) or line; repeatable",
    "NAME:KIND");
  command
    .add_option("--curves", this->otherCurves,
      "auto: recognise arcs of circles on all sides that no --curve names; default: none, except that a "
      "drawing has its curves")
    ->check(CLI::IsMember({ "auto" }))
    ->type_name("WORD");
  add("--node", this->nodes,
    "position where the mesh has a node, such as that of a load: the nearest node is moved there, by at "
    "most one quad; repeatable",
    "X,Y[,Z]");
  command.add_option("--min-size", this->minimumSize, "lower bound of target sizes, positive")
    ->check(NumberCheck::Positive());
  command.add_option("--max-size", this->maximumSize, "upper bound of target sizes, positive")
    ->check(NumberCheck::Positive());
}

bool SideOptions::HasSizes() const
{
  return !this->sizes.empty() || !this->sizesNear.empty() || !this->sizesInside.empty() ||
    this->minimumSize > 0.0 || this->maximumSize > 0.0;
}

std::vector<std::pair<std::string, double>> SideOptions::ReadSizes() const
{
  std::vector<std::pair<std::string, double>> read;
  const auto add = [&read](const char* option, const std::vector<std::string>& texts)
  {
    for (const std::string& text : texts)
    {
      const auto [name, value] = Divide(option, text);
      const std::vector<double> size = ReadNumbers(value);
      if (size.size() == 1 && size[0] > 0.0)
      {
        read.emplace_back(name, size[0]);
      }
    }
  };
  add("--size-at", this->sizes);
  add("--size-in", this->sizesInside);
  return read;
}

std::vector<std::string> SideOptions::PeriodicNames() const
{
  std::vector<std::string> names;
  for (const std::string& pair : this->periodic)
  {
    const auto [first, second] = Divide("--periodic", pair);
    names.push_back(first);
    names.push_back(second);
  }
  return names;
}

std::string SideOptions::CurvesText() const
{
  std::string text = this->otherCurves;
  for (const std::string& entry : this->curves)
  {
    text += (text.empty() ? "" : ";") + entry;
  }
  return text;
}

void SideOptions::SetOn(vtkQuadMesher* mesher) const
{
  for (const std::string& text : this->counts)
  {
    const auto [name, value] = Divide("--count", text);
    mesher->AddSide(name, value, "", "");
  }
  for (const std::string& text : this->progressions)
  {
    const auto [name, value] = Divide("--progression", text);
    mesher->AddSide(name, "", value, "");
  }
  for (const std::string& text : this->sizes)
  {
    const auto [name, value] = Divide("--size-at", text);
    mesher->AddSide(name, "", "", value);
  }
  for (const std::string& text : this->sizesInside)
  {
    const auto [name, value] = Divide("--size-in", text);
    mesher->AddSizeInside(name, value);
  }
  for (const std::string& text : this->sizesNear)
  {
    AddSizeNear(text, mesher);
  }
  for (const std::string& text : this->nodes)
  {
    AddNode(text, mesher);
  }
  if (this->growth != 0.0)
  {
    mesher->SetGrowth(this->growth);
  }
  mesher->SetPeriodic(ListText::Join(this->periodic));
  mesher->SetMinimumSize(this->minimumSize);
  mesher->SetMaximumSize(this->maximumSize);
}
