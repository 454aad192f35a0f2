#ifndef SideLabels_h
#define SideLabels_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>
#include <vector>

class vtkRenderer;
class vtkTextActor;

/** The names of the sides of a domain in a 3D view, each at a point of its side. */
class SideLabels
{
public:
  struct Label
  {
    std::string Name;
    std::array<double, 3> Place;
  };

  SideLabels() = default;
  ~SideLabels();
  SideLabels(const SideLabels&) = delete;
  SideLabels& operator=(const SideLabels&) = delete;

  /** Shows labels in a renderer, null for none, instead of those shown before. */
  void Show(vtkRenderer* renderer, const std::vector<Label>& labels, double pixelRatio);

  bool IsShown() const { return !this->Actors.empty(); }

private:
  vtkWeakPointer<vtkRenderer> Renderer;
  std::vector<vtkSmartPointer<vtkTextActor>> Actors;
};

#endif
