#include "SideOptions.h"

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
  command.add_option("--min-size", this->minimumSize, "lower bound of target sizes, positive")
    ->check(NumberCheck::Positive());
  command.add_option("--max-size", this->maximumSize, "upper bound of target sizes, positive")
    ->check(NumberCheck::Positive());
}

std::vector<std::pair<std::string, double>> SideOptions::ReadSizes() const
{
  std::vector<std::pair<std::string, double>> read;
  for (const std::string& text : this->sizes)
  {
    const auto [name, value] = Divide("--size-at", text);
    std::istringstream stream(value);
    stream.imbue(std::locale::classic());
    double size = 0.0;
    if (stream >> size && size > 0.0)
    {
      read.emplace_back(name, size);
    }
  }
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
  std::string pairs;
  for (const std::string& pair : this->periodic)
  {
    pairs += pair + ";";
  }
  mesher->SetPeriodic(pairs);
  mesher->SetMinimumSize(this->minimumSize);
  mesher->SetMaximumSize(this->maximumSize);
}
