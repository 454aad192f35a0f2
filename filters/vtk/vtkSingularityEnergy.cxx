#include "vtkSingularityEnergy.h"

#include "CachedDomain.h"
#include "ConfigurationConversion.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"

#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkSingularityEnergy);

//------------------------------------------------------------------------------
vtkSingularityEnergy::vtkSingularityEnergy()
  : Cache(std::make_unique<CachedDomain>())
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSingularityEnergy::~vtkSingularityEnergy() = default;

//------------------------------------------------------------------------------
int vtkSingularityEnergy::FillInputPortInformation(int port, vtkInformation* info)
{
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
    return FilterPorts::AcceptSingularities(info);
  }
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkSingularityEnergy::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info, port == 0 ? "vtkTable" : "vtkPolyData");
}

//------------------------------------------------------------------------------
int vtkSingularityEnergy::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      const DomainConversion::Domain& input = this->Cache->Read(domain);
      const int count = std::max(1, inputVector[1]->GetNumberOfInformationObjects());
      std::vector<crossfield::Configuration> configurations;
      crossfield::Configuration all;
      configurations.reserve(static_cast<std::size_t>(count));
      for (int i = 0; i < count; ++i)
      {
        configurations.push_back(ConfigurationConversion::ReadConfiguration(
          FilterPorts::RequireSingularities(inputVector[1], "Configurations", i), input.plane));
        all.insert(all.end(), configurations.back().begin(), configurations.back().end());
      }
      crossfield::ConfigurationEnergyOptions options;
      options.meshSize = this->MeshSize;
      options.coreRadius = this->CoreRadius;
      options.corners = CornerConversion::ReadCorners(corners, input.plane);
      const std::vector<crossfield::ConfigurationEnergy> energies = this->KeepMesh
        ? crossfield::CompareRenormalizedEnergies(
            this->Cache->Factor(all, this->MeshSize, progress.Part(0.0, 0.7)), configurations,
            options, progress.Part(0.7, 1.0))
        : crossfield::CompareConfigurations(input.domain, configurations, options, progress);
      EnergyConversion::WriteEnergies(energies, vtkTable::GetData(outputVector, 0));
      EnergyConversion::WriteGradients(
        energies, input.plane, vtkPolyData::GetData(outputVector, 1));
    });
}

//------------------------------------------------------------------------------
void vtkSingularityEnergy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "CoreRadius: " << this->CoreRadius << "\n";
  os << indent << "KeepMesh: " << this->KeepMesh << "\n";
}
