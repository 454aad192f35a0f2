#include "CurveText.h"

#include "Error.h"

#include <map>
#include <sstream>

namespace CurveText
{
//------------------------------------------------------------------------------
crossfield::CurveRequest Read(const std::string& text)
{
  using Kind = crossfield::CurveDeclaration::Kind;
  static const std::map<std::string, Kind> kinds = { { "line", Kind::Line },
    { "circle", Kind::Circle }, { "ellipse", Kind::Ellipse }, { "spline", Kind::Spline } };
  crossfield::CurveRequest request;
  std::istringstream stream(text);
  std::string entry;
  while (std::getline(stream, entry, ';'))
  {
    const std::size_t first = entry.find_first_not_of(" \t\n");
    if (first == std::string::npos)
    {
      continue;
    }
    entry = entry.substr(first, entry.find_last_not_of(" \t\n") - first + 1);
    if (entry == "auto")
    {
      request.findsArcs = true;
      continue;
    }
    const std::size_t colon = entry.rfind(':');
    const auto kind =
      colon == std::string::npos ? kinds.end() : kinds.find(entry.substr(colon + 1));
    if (kind == kinds.end() || colon == 0)
    {
      throw crossfield::Error("The curve '" + entry +
        "' is not of the form NAME:circle, NAME:ellipse, NAME:spline, NAME:line or auto; correct "
        "it.");
    }
    request.declared.push_back({ entry.substr(0, colon), kind->second });
  }
  return request;
}
}
