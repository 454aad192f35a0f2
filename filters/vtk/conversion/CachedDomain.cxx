#include "CachedDomain.h"

#include "vtkDataSet.h"

//------------------------------------------------------------------------------
const DomainConversion::Domain& CachedDomain::Read(vtkDataSet* data)
{
  if (!this->Domain || this->Data != data || this->Time != data->GetMTime())
  {
    this->Domain.reset();
    this->Factored = {};
    this->Domain = DomainConversion::ReadDomain(data, nullptr);
    this->Data = data;
    this->Time = data->GetMTime();
    ++this->Version;
  }
  return *this->Domain;
}

//------------------------------------------------------------------------------
const crossfield::FactoredDomain& CachedDomain::Factor(
  const crossfield::Configuration& configuration, double meshSize,
  const crossfield::Progress& progress)
{
  auto& [last, other] = this->Factored;
  if (last.first != meshSize)
  {
    std::swap(last, other);
  }
  if (!last.second || last.first != meshSize || !last.second->HasBoundaryVertices(configuration))
  {
    last = { meshSize, nullptr };
    last.second = std::make_unique<const crossfield::FactoredDomain>(
      this->Domain.value().domain, configuration, meshSize, progress);
  }
  return *last.second;
}
