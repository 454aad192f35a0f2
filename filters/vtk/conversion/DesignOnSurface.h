#ifndef DesignOnSurface_h
#define DesignOnSurface_h

#include "DesignModel.h"
#include "SurfaceDesign.h"

/** Designs on a surface in space. */
class DesignOnSurface final : public DesignModel
{
public:
  /** `featureAngle` is in degrees. */
  DesignOnSurface(vtkDataSet* data, double featureAngle);

  double Area() const override { return this->Surface.Area(); }
  const crossfield::DomainPlane& Plane() const override { return this->Space; }
  Rows Read(vtkDataSet* singularities) const override;
  std::vector<crossfield::CornerChoice> ReadCorners(vtkDataSet* corners) const override;
  const Rows& Choose(const DesignRequest& request, const crossfield::Progress& progress) override;
  Rows Change(const DesignRequest& request, const Rows& rows, std::vector<std::string>& events,
    const crossfield::Progress& progress) override;
  crossfield::LayoutDesign Design(
    const DesignRequest& request, const Rows& rows, const crossfield::Progress& progress) override;
  void WriteSingularities(
    const crossfield::LayoutDesign* design, const Rows& rows, vtkPolyData* output) const override;
  void WriteTriangles(vtkDoubleArray* output) const override;

private:
  const crossfield::DesignSurface Surface;
  const crossfield::DomainPlane Space; ///< Leaves positions as they are.
  Rows Chosen;
};

#endif
