#include "SideLabels.h"

#include "vtkCoordinate.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

//------------------------------------------------------------------------------
SideLabels::~SideLabels()
{
  this->Show(nullptr, {}, 1);
}

//------------------------------------------------------------------------------
void SideLabels::Show(vtkRenderer* renderer, const std::vector<Label>& labels, double pixelRatio)
{
  for (const auto& actor : this->Actors)
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveViewProp(actor);
    }
  }
  this->Actors.clear();
  this->Renderer = renderer;
  if (!renderer)
  {
    return;
  }
  for (const Label& label : labels)
  {
    auto actor = vtkSmartPointer<vtkTextActor>::New();
    actor->SetInput(label.Name.c_str());
    actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
    actor->GetPositionCoordinate()->SetValue(label.Place[0], label.Place[1], label.Place[2]);
    vtkTextProperty* text = actor->GetTextProperty();
    text->SetFontSize(static_cast<int>(13 * pixelRatio));
    text->SetColor(0, 0, 0);
    text->SetBackgroundColor(1, 1, 1);
    text->SetBackgroundOpacity(0.8);
    text->SetJustificationToCentered();
    text->SetVerticalJustificationToCentered();
    renderer->AddViewProp(actor);
    this->Actors.push_back(actor);
  }
}
