#ifndef KeptDomain_h
#define KeptDomain_h

#include "DomainConversion.h"
#include "FactoredDomain.h"

#include "vtkType.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

/**
 * What a filter keeps of the domain on its port between updates: read once for each change of the data, meshed and factored once
 * for each mesh size.
 */
class CachedDomain
{
public:
  /** The domain of a data set; throws crossfield::Error as DomainConversion::ReadDomain, and then keeps nothing. */
  const DomainConversion::Domain& Read(vtkDataSet* data);

  /** The domain that was read last. */
  const crossfield::PlanarDomain& Get() const { return this->Domain.value().domain; }

  /** How often a domain was read: what depends on it is stale when this has changed. */
  int GetVersion() const { return this->Version; }

  /**
   * The last domain that was read, with its mesh and factor. Those of the last two mesh sizes are kept: of a hand that drags and of
   * what it leaves. Singularities on the boundary have to be its vertices, so these ask for another mesh.
   */
  const crossfield::FactoredDomain& Factor(const crossfield::Configuration& configuration,
    double meshSize, const crossfield::Progress& progress = {});

private:
  vtkDataSet* Data = nullptr; ///< Compared, never used.
  vtkMTimeType Time = 0;
  int Version = 0;
  std::optional<DomainConversion::Domain> Domain;
  /** With the mesh size that was asked for, the last one first. */
  std::array<std::pair<double, std::unique_ptr<const crossfield::FactoredDomain>>, 2> Factored;
};

#endif
