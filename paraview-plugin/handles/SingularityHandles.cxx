#include "SingularityHandles.h"

#include "vtkActor2D.h"
#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>
#include <string>
#include <utility>

namespace
{
// Pixels at a pixel ratio of 1. A disc is large enough to hit and small enough not to hide the
// mesh.
constexpr double DiscRadius = 8;
constexpr double LabelSize = 16;

/**
 * Offsets to the right and up of the copies that outline a label; the label itself is last, on top.
 */
constexpr std::array<std::array<double, 2>, 5> LabelCopies = { { { -1, -1 }, { 1, -1 }, { -1, 1 },
  { 1, 1 }, { 0, 0 } } };

using Colour = std::array<double, 4>;

/**
 * Returns red, blue or grey as in the documentation, which colour-blind readers can distinguish.
 */
std::array<double, 3> ColourOf(int quarterIndex)
{
  if (quarterIndex == 0)
  {
    return { 0.4, 0.4, 0.4 };
  }
  return quarterIndex > 0 ? std::array<double, 3>{ 0.85, 0.1, 0.1 }
                          : std::array<double, 3>{ 0.1, 0.2, 0.85 };
}

/** Ring of a disc: its colour starts at this radius and blends into that of the next ring. */
struct Ring
{
  double Radius;
  Colour Shade;
};

/**
 * Returns the rings of a disc with a white rim, a thin dark rim around it, and anti-aliased edges.
 */
std::vector<Ring> RingsOf(int quarterIndex, bool isChosen)
{
  const auto [red, green, blue] = ColourOf(quarterIndex);
  const Colour fill{ red, green, blue, 1 };
  const Colour white{ 1, 1, 1, 1 };
  const Colour dark{ 0, 0, 0, isChosen ? 1.0 : 0.55 };
  const double white0 = DiscRadius - 1.5;
  const double dark0 = DiscRadius + 0.5;
  const double end = isChosen ? dark0 + 2.5 : dark0 + 0.5;
  return { { 0, fill }, { white0 - 0.5, fill }, { white0 + 0.5, white }, { dark0 - 0.5, white },
    { dark0 + 0.5, dark }, { end, dark }, { end + 1, { dark[0], dark[1], dark[2], 0 } } };
}

vtkSmartPointer<vtkPolyData> DiscOf(const std::vector<Ring>& rings, double pixelRatio)
{
  constexpr int sides = 48;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (const Ring& ring : rings)
  {
    for (int i = 0; i < sides; ++i)
    {
      const double angle = 2 * vtkMath::Pi() * i / sides;
      const double radius = ring.Radius * pixelRatio;
      points->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0);
      const Colour& shade = ring.Shade;
      colours->InsertNextTuple4(255 * shade[0], 255 * shade[1], 255 * shade[2], 255 * shade[3]);
    }
  }
  for (vtkIdType r = 0; r + 1 < static_cast<vtkIdType>(rings.size()); ++r)
  {
    for (vtkIdType i = 0; i < sides; ++i)
    {
      const vtkIdType next = (i + 1) % sides;
      const vtkIdType inner = r * sides;
      const vtkIdType outer = inner + sides;
      const std::array<vtkIdType, 4> quad{ inner + i, outer + i, outer + next, inner + next };
      cells->InsertNextCell(4, quad.data());
    }
  }
  auto disc = vtkSmartPointer<vtkPolyData>::New();
  disc->SetPoints(points);
  disc->SetPolys(cells);
  disc->GetPointData()->SetScalars(colours);
  return disc;
}

std::string TextOf(int quarterIndex)
{
  if (quarterIndex == 0)
  {
    return "0";
  }
  // U+2212, the minus sign, is as wide as the plus sign.
  return (quarterIndex > 0 ? "+" : "\u2212") + std::to_string(std::abs(quarterIndex));
}
}

//------------------------------------------------------------------------------
SingularityHandles::SingularityHandles()
{
  this->Render->SetCallback(&SingularityHandles::OnRender);
  this->Render->SetClientData(this);
}

//------------------------------------------------------------------------------
SingularityHandles::~SingularityHandles()
{
  this->SetRenderer(nullptr);
}

//------------------------------------------------------------------------------
vtkRenderer* SingularityHandles::GetRenderer() const
{
  return this->Renderer;
}

//------------------------------------------------------------------------------
SingularityHandles::Handle SingularityHandles::MakeHandle() const
{
  Handle handle;
  handle.Disc = vtkSmartPointer<vtkActor2D>::New();
  vtkCoordinate* position = handle.Disc->GetPositionCoordinate();
  position->SetCoordinateSystemToWorld();
  vtkNew<vtkPolyDataMapper2D> mapper;
  handle.Disc->SetMapper(mapper);
  handle.Disc->PickableOff();

  for (const auto& [right, up] : LabelCopies)
  {
    auto label = vtkSmartPointer<vtkTextActor>::New();
    // Placed relative to the disc, at its upper right.
    vtkCoordinate* corner = label->GetPositionCoordinate();
    corner->SetCoordinateSystemToViewport();
    corner->SetReferenceCoordinate(position);
    corner->SetValue((DiscRadius + 3 + right) * this->PixelRatio, (3 + up) * this->PixelRatio);
    vtkTextProperty* text = label->GetTextProperty();
    text->SetFontFamilyToArial();
    text->SetFontSize(static_cast<int>(LabelSize * this->PixelRatio));
    text->BoldOn();
    text->SetColor(1, 1, 1);
    label->PickableOff();
    handle.Labels.push_back(label);
  }
  return handle;
}

//------------------------------------------------------------------------------
void SingularityHandles::Add(const Handle& handle)
{
  if (this->Renderer)
  {
    for (const auto& label : handle.Labels)
    {
      this->Renderer->AddActor2D(label);
    }
    this->Renderer->AddActor2D(handle.Disc);
  }
}

//------------------------------------------------------------------------------
void SingularityHandles::Remove(const Handle& handle)
{
  if (this->Renderer)
  {
    this->Renderer->RemoveActor2D(handle.Disc);
    for (const auto& label : handle.Labels)
    {
      this->Renderer->RemoveActor2D(label);
    }
  }
}

//------------------------------------------------------------------------------
void SingularityHandles::SetRenderer(vtkRenderer* renderer, double pixelRatio)
{
  for (const Handle& handle : this->Handles)
  {
    this->Remove(handle);
  }
  this->Handles.clear();
  if (this->Renderer)
  {
    this->Renderer->RemoveObserver(this->Render);
  }
  this->Renderer = renderer;
  this->PixelRatio = pixelRatio;
  if (renderer)
  {
    renderer->AddObserver(vtkCommand::StartEvent, this->Render);
    const std::vector<SingularityRow> rows = this->Rows;
    this->SetRows(rows, this->Chosen);
  }
}

//------------------------------------------------------------------------------
void SingularityHandles::SetPlane(const HandlePlane& plane)
{
  this->Plane = plane;
}

//------------------------------------------------------------------------------
const HandlePlane& SingularityHandles::GetPlane() const
{
  return this->Plane;
}

//------------------------------------------------------------------------------
void SingularityHandles::SetSurface(HandleSurface surface)
{
  this->Surface = std::move(surface);
}

//------------------------------------------------------------------------------
const HandleSurface& SingularityHandles::GetSurface() const
{
  return this->Surface;
}

//------------------------------------------------------------------------------
HandlePlane::Vector SingularityHandles::PlaceOf(const SingularityRow& row) const
{
  return this->Surface.IsEmpty() ? this->Plane.ToSpace({ row[0], row[1] })
                                 : HandlePlane::Vector{ row[0], row[1], row[3] };
}

//------------------------------------------------------------------------------
void SingularityHandles::SetRows(const std::vector<SingularityRow>& rows, int chosen)
{
  this->Rows = rows;
  this->Chosen = chosen;
  if (!this->Renderer)
  {
    return; // SetRenderer creates the discs
  }
  while (this->Handles.size() > rows.size())
  {
    this->Remove(this->Handles.back());
    this->Handles.pop_back();
  }
  while (this->Handles.size() < rows.size())
  {
    this->Handles.push_back(this->MakeHandle());
    this->Add(this->Handles.back());
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    Handle& handle = this->Handles[i];
    const int quarterIndex = QuarterIndexOf(rows[i]);
    const bool isChosen = static_cast<int>(i) == chosen;
    HandlePlane::Vector place = this->PlaceOf(rows[i]);
    handle.Disc->GetPositionCoordinate()->SetValue(place.data());
    if (handle.Drawn == std::pair(quarterIndex, isChosen))
    {
      continue; // only moved
    }
    handle.Drawn = { quarterIndex, isChosen };
    const auto [red, green, blue] = ColourOf(quarterIndex);
    static_cast<vtkPolyDataMapper2D*>(handle.Disc->GetMapper())
      ->SetInputData(DiscOf(RingsOf(quarterIndex, isChosen), this->PixelRatio));
    for (const auto& label : handle.Labels)
    {
      label->SetInput(TextOf(quarterIndex).c_str());
    }
    handle.Labels.back()->GetTextProperty()->SetColor(red, green, blue);
  }
}

//------------------------------------------------------------------------------
std::array<double, 2> SingularityHandles::PixelOf(const SingularityRow& row) const
{
  const auto [x, y, z] = this->PlaceOf(row);
  this->Renderer->SetWorldPoint(x, y, z, 1);
  this->Renderer->WorldToDisplay();
  const double* pixel = this->Renderer->GetDisplayPoint();
  return { pixel[0], pixel[1] };
}

//------------------------------------------------------------------------------
double SingularityHandles::GetSpacing() const
{
  return 5 * DiscRadius * this->PixelRatio;
}

//------------------------------------------------------------------------------
SingularityRow SingularityHandles::FindFreeRow(const std::vector<SingularityRow>& others,
  const SingularityRow& row, const std::array<double, 2>& pixel) const
{
  // Handles on the far side count as well.
  std::vector<SingularityRow> taken;
  for (const SingularityRow& other : others)
  {
    const std::array<double, 2> place = this->PixelOf(other);
    taken.push_back({ place[0], place[1], 0, 0 });
  }
  while (taken.size() < 2 * others.size() + 100)
  {
    const std::array<double, 2> free = FindFreePosition(taken, pixel, this->GetSpacing());
    if (const auto found = this->Moved(row, free[0], free[1]))
    {
      return *found;
    }
    taken.push_back({ free[0], free[1], 0, 0 }); // beside the surface
  }
  return row;
}

//------------------------------------------------------------------------------
int SingularityHandles::RowAt(int x, int y) const
{
  int nearest = -1;
  // A margin of three pixels around the disc makes it easier to hit.
  double smallest = (DiscRadius + 3) * this->PixelRatio;
  for (std::size_t i = 0; this->Renderer && i < this->Rows.size(); ++i)
  {
    if (!this->Handles[i].Disc->GetVisibility())
    {
      continue;
    }
    const std::array<double, 2> pixel = this->PixelOf(this->Rows[i]);
    const double distance = std::hypot(pixel[0] - x, pixel[1] - y);
    if (distance < smallest)
    {
      smallest = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

//------------------------------------------------------------------------------
/** Returns the points of the near and the far plane of the camera on a line of sight. */
std::array<HandlePlane::Vector, 2> SingularityHandles::SightThrough(double x, double y) const
{
  std::array<HandlePlane::Vector, 2> ends{};
  for (int end = 0; end < 2; ++end)
  {
    this->Renderer->SetDisplayPoint(x, y, end);
    this->Renderer->DisplayToWorld();
    const double* world = this->Renderer->GetWorldPoint();
    for (std::size_t i = 0; i < 3; ++i)
    {
      ends[end][i] = world[i] / world[3];
    }
  }
  return ends;
}

//------------------------------------------------------------------------------
std::optional<SingularityRow> SingularityHandles::Moved(
  const SingularityRow& row, double x, double y) const
{
  if (!this->Renderer)
  {
    return std::nullopt;
  }
  const auto [eye, beyond] = this->SightThrough(x, y);
  SingularityRow moved = row;
  if (this->Surface.IsEmpty())
  {
    const auto point = this->Plane.IntersectRay(eye, beyond);
    if (!point)
    {
      return std::nullopt;
    }
    moved[0] = (*point)[0];
    moved[1] = (*point)[1];
    return moved;
  }
  const auto place = this->Surface.IntersectRay(eye, beyond);
  if (!place)
  {
    return std::nullopt;
  }
  moved[0] = (*place)[0];
  moved[1] = (*place)[1];
  moved[3] = (*place)[2];
  return moved;
}

//------------------------------------------------------------------------------
void SingularityHandles::OnRender(vtkObject*, unsigned long, void* self, void*)
{
  static_cast<SingularityHandles*>(self)->ShowVisible();
}

//------------------------------------------------------------------------------
void SingularityHandles::ShowVisible()
{
  for (std::size_t i = 0; i < this->Handles.size() && i < this->Rows.size(); ++i)
  {
    bool isVisible = true;
    if (!this->Surface.IsEmpty())
    {
      const std::array<double, 2> pixel = this->PixelOf(this->Rows[i]);
      const HandlePlane::Vector eye = this->SightThrough(pixel[0], pixel[1])[0];
      isVisible = !this->Surface.Hides(eye, this->PlaceOf(this->Rows[i]));
    }
    this->Handles[i].Disc->SetVisibility(isVisible);
    for (const auto& label : this->Handles[i].Labels)
    {
      label->SetVisibility(isVisible);
    }
  }
}
