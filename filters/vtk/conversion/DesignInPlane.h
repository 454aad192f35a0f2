#ifndef DesignInPlane_h
#define DesignInPlane_h

#include "AutomaticConfiguration.h"
#include "CachedDomain.h"
#include "DesignModel.h"

#include <optional>

/** Designs on a planar domain. */
class DesignInPlane final : public DesignModel
{
public:
  explicit DesignInPlane(vtkDataSet* data);

  double Area() const override { return this->Domain.Get().Area(); }
  const crossfield::DomainPlane& Plane() const override { return this->DomainsPlane; }
  bool HasHeight() const override { return false; }
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
  void WriteTriangles(vtkDoubleArray*) const override {}

private:
  /** Returns the options of maps, with the corners that were chosen with singularities, if these were. */
  crossfield::SeamlessMapOptions MapOptions(const DesignRequest& request) const;
  const crossfield::FactoredDomain& Factor(const DesignRequest& request,
    const crossfield::Configuration& singularities, const crossfield::Progress& progress = {});

  CachedDomain Domain;
  crossfield::DomainPlane DomainsPlane;
  std::optional<crossfield::AutomaticConfiguration> Chosen;
  Rows ChosenRows;
};

#endif
