#include "SvgPath.h"

#include "CurvePieces.h"
#include "Error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace crossfield
{
namespace
{
/// Reads commands and numbers of path data.
class PathText
{
public:
  explicit PathText(std::string_view text)
    : Text(text)
  {
  }

  /// Returns whether nothing but blanks is left.
  bool IsAtEnd()
  {
    this->SkipBlanks();
    return this->At == this->Text.size();
  }

  /// Returns the next command, or 0 if a number follows.
  char TakeCommand()
  {
    this->SkipBlanks();
    const char letter = this->At < this->Text.size() ? this->Text[this->At] : '\0';
    if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(letter) == std::string_view::npos ||
      letter == '\0')
    {
      return '\0';
    }
    ++this->At;
    return letter;
  }

  double TakeNumber()
  {
    this->SkipSeparators();
    std::size_t start = this->At;
    start += start < this->Text.size() && this->Text[start] == '+' ? 1U : 0U;
    double number = 0.0;
    const char* end = this->Text.data() + this->Text.size();
    const auto result = std::from_chars(this->Text.data() + start, end, number);
    if (result.ec != std::errc() || !std::isfinite(number))
    {
      this->Refuse();
    }
    this->At = static_cast<std::size_t>(result.ptr - this->Text.data());
    return number;
  }

  /// Reads 0 or 1, which no blank needs to follow.
  bool TakeFlag()
  {
    this->SkipSeparators();
    if (this->At == this->Text.size() ||
      (this->Text[this->At] != '0' && this->Text[this->At] != '1'))
    {
      this->Refuse();
    }
    return this->Text[this->At++] == '1';
  }

  [[noreturn]] void Refuse() const
  {
    throw Error("The path data of the drawing are not valid at '" +
      std::string(this->Text.substr(std::min(this->At, this->Text.size()), 20)) + "', character " +
      std::to_string(this->At + 1) + "; correct or remove this path.");
  }

private:
  void SkipBlanks()
  {
    while (this->At < this->Text.size() &&
      std::string_view(" \t\r\n\f").find(this->Text[this->At]) != std::string_view::npos)
    {
      ++this->At;
    }
  }

  void SkipSeparators()
  {
    this->SkipBlanks();
    if (this->At < this->Text.size() && this->Text[this->At] == ',')
    {
      ++this->At;
      this->SkipBlanks();
    }
  }

  std::string_view Text;
  std::size_t At = 0;
};

/// Executes the commands of path data.
class PathReader
{
public:
  explicit PathReader(std::string_view text)
    : Text(text)
  {
  }

  std::vector<DrawingPiece> Read()
  {
    char command = '\0';
    while (!this->Text.IsAtEnd())
    {
      const char next = this->Text.TakeCommand();
      const bool isFirst = command == '\0';
      if (next != '\0')
      {
        command = next;
      }
      else if (command == 'M' || command == 'm')
      {
        command = command == 'M' ? 'L' : 'l'; // further points of a move
      }
      if ((isFirst && command != 'M' && command != 'm') ||
        (next == '\0' && (command == 'Z' || command == 'z')))
      {
        this->Text.Refuse();
      }
      this->Run(command);
    }
    return std::move(this->Pieces);
  }

private:
  void Run(char command)
  {
    this->IsRelative = command >= 'a';
    const char upper = static_cast<char>(this->IsRelative ? command - 'a' + 'A' : command);
    switch (upper)
    {
    case 'M':
      this->Here = this->TakePoint();
      this->Start = this->Here;
      break;
    case 'Z':
      this->LineTo(this->Start);
      break;
    case 'L':
      this->LineTo(this->TakePoint());
      break;
    case 'H':
      this->LineTo(
        { this->Text.TakeNumber() + (this->IsRelative ? this->Here.x() : 0.0), this->Here.y() });
      break;
    case 'V':
      this->LineTo(
        { this->Here.x(), this->Text.TakeNumber() + (this->IsRelative ? this->Here.y() : 0.0) });
      break;
    case 'A':
      this->ArcTo();
      break;
    default:
      this->BezierTo(upper);
    }
    this->Before = upper;
  }

  Point TakePoint()
  {
    const double x = this->Text.TakeNumber();
    const double y = this->Text.TakeNumber();
    return this->IsRelative ? Point(this->Here + Point(x, y)) : Point(x, y);
  }

  void Add(const DrawingPiece& piece)
  {
    this->Pieces.push_back(piece);
    this->Here = piece.last;
  }

  void LineTo(const Point& last)
  {
    if (last != this->Here)
    {
      this->Add(LinePiece(this->Here, last));
    }
  }

  /// Reads a cubic (C, S) or quadratic (Q, T) Bézier curve. S and T continue the tangent of a
  /// preceding curve of the same degree.
  void BezierTo(char command)
  {
    const bool isCubic = command == 'C' || command == 'S';
    std::vector<Point> points = { this->Here };
    if (command == 'S' || command == 'T')
    {
      const bool continues = isCubic ? this->Before == 'C' || this->Before == 'S'
                                     : this->Before == 'Q' || this->Before == 'T';
      points.emplace_back(continues ? Point(2.0 * this->Here - this->Control) : this->Here);
    }
    while (points.size() < (isCubic ? 4U : 3U))
    {
      points.push_back(this->TakePoint());
    }
    this->Control = points[points.size() - 2];
    const bool isPoint = std::all_of(points.begin(), points.end(),
      [&points](const Point& point) { return point == points.front(); });
    if (!isPoint)
    {
      this->Add(BezierPiece(points));
    }
  }

  void ArcTo()
  {
    const double rx = std::abs(this->Text.TakeNumber());
    const double ry = std::abs(this->Text.TakeNumber());
    const double degrees = this->Text.TakeNumber();
    const bool isLarge = this->Text.TakeFlag();
    const bool isPositive = this->Text.TakeFlag();
    const Point last = this->TakePoint();
    if (rx == 0.0 || ry == 0.0)
    {
      this->LineTo(last);
    }
    else if (last != this->Here)
    {
      this->Add(SvgArc(this->Here, last, { rx, ry }, degrees, isLarge, isPositive));
    }
  }

  PathText Text;
  bool IsRelative = false;
  char Before = '\0'; ///< Command of the preceding segment.
  Point Here = Point::Zero();
  Point Start = Point::Zero();   ///< Of the current closed curve.
  Point Control = Point::Zero(); ///< Last control point of the preceding Bézier curve.
  std::vector<DrawingPiece> Pieces;
};
}

std::vector<double> SvgNumbers(std::string_view text)
{
  PathText numbers(text);
  std::vector<double> found;
  while (!numbers.IsAtEnd())
  {
    found.push_back(numbers.TakeNumber());
  }
  return found;
}

std::vector<DrawingPiece> SvgPath(std::string_view data)
{
  return PathReader(data).Read();
}

DrawingPiece SvgArc(const Point& first, const Point& last, const Point& radii, double degrees,
  bool isLarge, bool isPositive)
{
  // SVG 1.1, appendix F.6.5: on the unit circle, the centre is on the bisector of the chord.
  const double angle = degrees * Pi / 180.0;
  Eigen::Matrix2d turn;
  turn << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Point half = (turn.transpose() * (0.5 * (last - first))).cwiseQuotient(radii);
  const double length = half.norm();
  const double scale = std::max(length, 1.0); // enlarges radii that do not reach
  const Point unit = half / scale;
  const double height = std::sqrt(std::max(1.0 - unit.squaredNorm(), 0.0));
  const double side = isLarge == isPositive ? 1.0 : -1.0;
  const Point left(-unit.y(), unit.x());
  // Seen from the middle of the chord. Positive angles lead from x to y.
  const Point centre =
    length > 0.0 ? Point(-side * height * left.normalized()) : Point(Point::Zero());
  const Point start = -unit - centre;
  const Point stop = unit - centre;
  double sweep = AngleBetween(start, stop);
  if (isPositive && sweep < 0.0)
  {
    sweep += 2.0 * Pi;
  }
  else if (!isPositive && sweep > 0.0)
  {
    sweep -= 2.0 * Pi;
  }
  const Point scaled = scale * radii;
  DrawingPiece piece;
  piece.curve.kind =
    scaled.x() == scaled.y() ? PlaneCurve::Kind::Circle : PlaneCurve::Kind::Ellipse;
  piece.curve.centre = first + 0.5 * (last - first) + turn * centre.cwiseProduct(scaled);
  piece.curve.axis = scaled.x() * turn.col(0);
  piece.curve.ratio = scaled.y() / scaled.x();
  piece.begin = std::atan2(start.y(), start.x());
  piece.end = piece.begin + sweep;
  piece.first = first;
  piece.last = last;
  return piece;
}
}
