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
  bool HasHeight() const override { return true; }
  Rows Read(vtkDataSet* singularities) const override;
  std::vector<crossfield::CornerChoice> ReadCorners(vtkDataSet* corners) const override;
  const Rows& Choose(const DesignRequest& request, const crossfield::Progress& progress) override;
  Rows Change(const DesignRequest& request, const Rows& rows, std::vector<std::string>& events,
    const crossfield::Progress& progress) override;
  crossfield::LayoutDesign Design(
    const DesignRequest& request, const Rows& rows, const crossfield::Progress& progress) override;
  int RequiredSum(const DesignRequest& request, const Rows& rows) override;
  Rows NodesOf(const crossfield::LayoutDesign& design) const override;
  void WriteSingularities(const Rows& rows, vtkPolyData* output) const override;
  void WriteTriangles(vtkDoubleArray* output) const override;

private:
  const crossfield::DesignSurface Surface;
  const crossfield::DomainPlane Space; ///< Leaves positions as they are.
  Rows Chosen;
  std::optional<int> Required; ///< Sum of quarter indices, once it was computed.
};

#endif
