#include "KeptDomain.h"

#include "vtkDataSet.h"

//------------------------------------------------------------------------------
const DomainConversion::Domain& KeptDomain::Read(vtkDataSet* data)
{
  if (!this->Domain || this->Data != data || this->Time != data->GetMTime())
  {
    this->Domain.reset();
    this->Factored.reset();
    this->Domain = DomainConversion::ReadDomain(data);
    this->Data = data;
    this->Time = data->GetMTime();
    ++this->Version;
  }
  return *this->Domain;
}

//------------------------------------------------------------------------------
const crossfield::FactoredDomain& KeptDomain::Factor(const crossfield::Configuration& configuration,
  double meshSize, const crossfield::Progress& progress)
{
  if (!this->Factored || this->MeshSize != meshSize || !this->Factored->Serves(configuration))
  {
    this->Factored.reset();
    this->Factored = std::make_unique<const crossfield::FactoredDomain>(
      this->Domain.value().domain, configuration, meshSize, progress);
    this->MeshSize = meshSize;
  }
  return *this->Factored;
}
