#include "ReadSvg.h"

#include "Error.h"
#include "PieceSampling.h"
#include "SvgPath.h"
#include "SvgShapes.h"

#include <expat.h>

#include <cstdint>

#include <algorithm>
#include <cmath>
#include <exception>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <type_traits>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
std::uint64_t LineNumber(XML_Parser parser)
{
#if XML_MAJOR_VERSION > 2 || (XML_MAJOR_VERSION == 2 && XML_MINOR_VERSION >= 9)
  return XML_GetCurrentLineNumber64(parser);
#else
  return XML_GetCurrentLineNumber(parser);
#endif
}

/// Collects the shapes while Expat reads the document.
class SvgReader
{
public:
  Drawing Read(std::string_view text, const std::string& file)
  {
    const std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)> parser(
      XML_ParserCreate(nullptr), &XML_ParserFree);
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(parser.get(), &SvgReader::OnStart, &SvgReader::OnEnd);
    this->Parser = parser.get();
    constexpr std::size_t Part = 1 << 20; // Expat's lengths are integers
    bool isGood = true;
    for (std::size_t at = 0; isGood && (at < text.size() || at == 0); at += Part)
    {
      const std::string_view part = text.substr(at, Part);
      isGood = XML_Parse(parser.get(), part.data(), static_cast<int>(part.size()),
                 at + Part >= text.size() ? 1 : 0) != XML_STATUS_ERROR;
    }
    if (this->Failure)
    {
      std::rethrow_exception(this->Failure);
    }
    if (!isGood)
    {
      throw Error("Line " + std::to_string(LineNumber(parser.get())) + " of '" + file +
        "' is no valid XML (" + XML_ErrorString(XML_GetErrorCode(parser.get())) +
        "); save the drawing again.");
    }
    if (!this->HasSvg)
    {
      throw Error(
        "The file '" + file + "' is no SVG document; give a drawing with the element svg.");
    }
    this->Finish(file);
    return std::move(this->Result);
  }

private:
  /// State inside an element.
  struct Level
  {
    AffineMap map = IdentityMap();
    std::string name;
    bool isDrawn = true;
    bool isFilled = true; ///< As SVG does it without an attribute.
  };

  // An exception must not pass through Expat, which is C.
  static void OnStart(void* data, const char* element, const char** attributes)
  {
    auto* self = static_cast<SvgReader*>(data);
    self->Try([&] { self->Start(element, attributes); });
  }
  static void OnEnd(void* data, const char*)
  {
    auto* self = static_cast<SvgReader*>(data);
    self->Try([&] { self->Levels.pop_back(); });
  }
  template <class Work>
  void Try(const Work& work)
  {
    try
    {
      if (!this->Failure)
      {
        work();
      }
    }
    catch (const std::exception&)
    {
      this->Failure = std::current_exception();
      XML_StopParser(this->Parser, XML_FALSE);
    }
  }

  void Start(const std::string& qualified, const char** pairs)
  {
    const std::string element = qualified.substr(qualified.rfind(':') + 1);
    SvgAttributes attributes;
    for (; *pairs != nullptr; pairs += 2)
    {
      attributes[pairs[0]] = pairs[1];
    }
    Level level = this->Levels.empty() ? Level() : this->Levels.back();
    const std::set<std::string> notDrawn = { "clipPath", "defs", "linearGradient", "marker", "mask",
      "metadata", "pattern", "radialGradient", "script", "style", "symbol", "title", "desc" };
    const bool isPrefixed = element != qualified && qualified.rfind("svg:", 0) != 0;
    level.isDrawn =
      level.isDrawn && notDrawn.count(element) == 0 && !isPrefixed && IsShown(attributes);
    level.isFilled = IsFilled(attributes, level.isFilled);
    if (level.isDrawn)
    {
      this->Draw(element, attributes, level);
    }
    this->Levels.push_back(std::move(level));
  }

  /// Returns an attribute without blanks; empty if it does not exist.
  static std::string ValueOf(const SvgAttributes& attributes, const char* name)
  {
    const auto found = attributes.find(name);
    std::string text = found == attributes.end() ? std::string() : found->second;
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
  }

  static bool IsShown(const SvgAttributes& attributes)
  {
    return ValueOf(attributes, "display") != "none" &&
      ValueOf(attributes, "visibility") != "hidden" &&
      ValueOf(attributes, "style").find("display:none") == std::string::npos;
  }

  /// Returns whether an element is filled, which closes its curves. The rules of a class are not read: with
  /// one an element counts as not filled.
  static bool IsFilled(const SvgAttributes& attributes, bool isParentFilled)
  {
    const std::string style = ";" + ValueOf(attributes, "style");
    const std::string fill = ValueOf(attributes, "fill");
    if (style.find(";fill:") != std::string::npos)
    {
      return style.find(";fill:none") == std::string::npos;
    }
    return fill.empty() ? isParentFilled && attributes.count("class") == 0 : fill != "none";
  }

  /// Adds the straight lines that close the curves of a filled shape of at least two pieces.
  void Close(std::vector<DrawingPiece>& pieces)
  {
    // Smaller gaps are rounding errors, which the joints of ends close.
    constexpr double SmallestGap = 1e-4;
    std::vector<DrawingPiece> closed;
    for (std::size_t begin = 0, end = 0; begin < pieces.size(); begin = end)
    {
      double length = ApproximateLength(pieces[begin]);
      for (end = begin + 1; end < pieces.size() && pieces[end].first == pieces[end - 1].last; ++end)
      {
        length += ApproximateLength(pieces[end]);
      }
      closed.insert(closed.end(), pieces.begin() + static_cast<std::ptrdiff_t>(begin),
        pieces.begin() + static_cast<std::ptrdiff_t>(end));
      const Point& first = pieces[begin].first;
      const Point& last = pieces[end - 1].last;
      if (end - begin > 1 && (last - first).norm() > SmallestGap * length)
      {
        closed.push_back(LinePiece(last, first));
        ++this->Closed;
      }
    }
    pieces = std::move(closed);
  }

  void Draw(const std::string& element, const SvgAttributes& attributes, Level& level)
  {
    if (const auto transform = attributes.find("transform"); transform != attributes.end())
    {
      level.map = Compose(level.map, SvgTransform(transform->second));
    }
    if (const auto id = attributes.find("id"); id != attributes.end() && element != "svg")
    {
      level.name = id->second;
    }
    if (element == "svg" && this->Levels.empty())
    {
      this->HasSvg = true;
      this->ReadUnit(attributes);
    }
    else if (IsSvgShape(element))
    {
      this->AddShape(element, attributes, level);
    }
    else if (element != "g" && element != "a" && element != "switch")
    {
      ++this->Ignored[element];
      level.isDrawn = false;
    }
  }

  void ReadUnit(const SvgAttributes& attributes)
  {
    const auto width = attributes.find("width");
    const auto box = attributes.find("viewBox");
    if (box != attributes.end())
    {
      this->View = SvgNumbers(box->second);
    }
    if (width == attributes.end() || box == attributes.end())
    {
      return;
    }
    const double millimetres = SvgMillimetres(width->second);
    if (this->View.size() != 4 || !(this->View[2] > 0.0) || !(millimetres > 0.0))
    {
      return;
    }
    const double unit = millimetres / this->View[2];
    std::ostringstream text;
    text << unit << " mm";
    // Sizes are written with few digits.
    this->Result.unit = std::abs(unit - 1.0) < 1e-4 ? "mm" : text.str();
  }

  /// Returns whether lines are the edges of the page.
  bool IsPage(const std::vector<DrawingPiece>& lines) const
  {
    constexpr double Rounding = 1e-6;
    return this->View.size() == 4 && lines.size() == 4 &&
      (lines[0].first - Point(this->View[0], this->View[1])).norm() <= Rounding * this->View[2] &&
      (lines[2].first - lines[0].first - Point(this->View[2], this->View[3])).norm() <=
      Rounding * this->View[2];
  }

  void AddShape(const std::string& element, const SvgAttributes& attributes, const Level& level)
  {
    AffineMap upward = IdentityMap();
    upward(1, 1) = -1.0;
    const std::string origin = "the " + element + " of line " +
      std::to_string(LineNumber(this->Parser)) +
      (level.name.empty() ? "" : " ('" + level.name + "')");
    std::vector<DrawingPiece> pieces = SvgShape(element, attributes);
    if (element == "rect" && level.map == IdentityMap() && this->IsPage(pieces))
    {
      this->Page = origin;
    }
    if (level.isFilled)
    {
      this->Close(pieces);
    }
    for (DrawingPiece& piece : pieces)
    {
      piece.origin = origin;
      piece.name = level.name;
      Transform(Compose(upward, level.map), piece);
      this->Result.pieces.push_back(std::move(piece));
    }
  }

  void Finish(const std::string& file)
  {
    if (this->Result.pieces.empty())
    {
      throw Error(
        "The file '" + file + "' has no visible shapes; draw the boundary of the domain.");
    }
    if (!this->Page.empty() && this->Result.pieces.size() > 4)
    {
      this->Result.warnings.push_back("The edges of the page, " + this->Page +
        ", are the outer boundary; remove it if it is a background.");
    }
    if (this->Closed > 0)
    {
      this->Result.warnings.push_back(std::to_string(this->Closed) +
        (this->Closed == 1 ? " filled curve of '" : " filled curves of '") + file +
        "' without Z at the end " + (this->Closed == 1 ? "was" : "were") +
        " closed by a straight line.");
    }
    std::string ignored;
    for (const auto& [element, count] : this->Ignored)
    {
      ignored += (ignored.empty() ? "" : ", ") + std::to_string(count) + " " + element;
    }
    if (!ignored.empty())
    {
      this->Result.warnings.push_back(
        "Elements of '" + file + "' that are no shapes were left out: " + ignored + ".");
    }
  }

  XML_Parser Parser = nullptr;
  std::exception_ptr Failure;
  bool HasSvg = false;
  std::vector<Level> Levels;
  std::map<std::string, std::size_t> Ignored;
  std::vector<double> View; ///< Of the page: left, top, width, height.
  std::string Page;         ///< The rect that is as large as the page.
  std::size_t Closed = 0;   ///< Curves that their fill closes.
  Drawing Result;
};
}

Drawing ReadSvg(std::string_view text, const std::string& file)
{
  return SvgReader().Read(text, file);
}
}
