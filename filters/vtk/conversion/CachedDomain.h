#ifndef CachedDomain_h
#define CachedDomain_h

#include "DomainConversion.h"
#include "FactoredDomain.h"

#include "vtkType.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>

/**
 * Cache of the domain on a filter's port: reads it once for each change of the data, and meshes and
 * factors it once for each mesh size.
 */
class CachedDomain
{
public:
  /**
   * Returns the domain of a data set. Throws crossfield::Error like DomainConversion::ReadDomain;
   * the cache is then empty.
   */
  const DomainConversion::Domain& Read(vtkDataSet* data);

  /** Returns the domain read last. */
  const crossfield::PlanarDomain& Get() const { return this->Domain.value().domain; }

  /**
   * Returns the number of times a domain was read. Results that depend on the domain are outdated
   * when it changes.
   */
  int GetVersion() const { return this->Version; }

  /**
   * Returns the domain read last with its mesh and factor. The results for the last two mesh sizes
   * are cached, one for dragging a handle and one for releasing it. Singularities on the boundary
   * have to be vertices of the mesh, so they may require another mesh.
   */
  const crossfield::FactoredDomain& Factor(const crossfield::Configuration& configuration,
    double meshSize, const crossfield::Progress& progress = {});

private:
  vtkDataSet* Data = nullptr; ///< Identity token for change detection; never dereferenced.
  vtkMTimeType Time = 0;
  int Version = 0;
  std::optional<DomainConversion::Domain> Domain;
  /** Factored domains with their requested mesh sizes, the last one first. */
  std::array<std::pair<double, std::unique_ptr<const crossfield::FactoredDomain>>, 2> Factored;
};

#endif
