#include "vtkConfigurationProposal.h"

#include "AutomaticConfiguration.h"
#include "ConfigurationConversion.h"
#include "ConfigurationEnergy.h"
#include "ConfigurationProposal.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "EnergyConversion.h"
#include "Error.h"
#include "FilterPorts.h"
#include "FilterRun.h"
#include "NamedSurface.h"
#include "ProposalConversion.h"
#include "SurfaceChoice.h"
#include "SurfaceConversion.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

vtkStandardNewMacro(vtkConfigurationProposal);

//------------------------------------------------------------------------------
vtkConfigurationProposal::vtkConfigurationProposal()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
int vtkConfigurationProposal::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::AcceptDomain(info) : FilterPorts::AcceptOptionalPoints(info);
}

//------------------------------------------------------------------------------
int vtkConfigurationProposal::FillOutputPortInformation(int port, vtkInformation* info)
{
  return FilterPorts::Produce(info, port == 2 ? "vtkTable" : "vtkPolyData");
}

//------------------------------------------------------------------------------
int vtkConfigurationProposal::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  return FilterRun::Run(this, this->ErrorCode, domain,
    [&](const crossfield::Progress& progress)
    {
      if (SurfaceConversion::IsSurface(domain))
      {
        if (singularities != nullptr || corners != nullptr)
        {
          throw crossfield::Error("Singularities of a surface in space are chosen all together; "
                                  "leave out given singularities and corners.");
        }
        SurfaceConversion::WriteConfiguration(
          crossfield::ChooseSurfaceSingularities(NamedSurface::Read(domain).mesh,
            vtkMath::RadiansFromDegrees(this->FeatureAngle), progress),
          vtkPolyData::GetData(outputVector, 0));
        return;
      }
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain, this);
      crossfield::AutomaticOptions automatic;
      automatic.optimizer.clearance = this->Clearance;
      automatic.optimizer.keepAll = this->KeepAll;
      crossfield::ProposalOptions& options = automatic.proposal;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      options.corners = CornerConversion::ReadCorners(corners, input.plane);
      if (this->CapCorners)
      {
        crossfield::CapCorners(input.domain, automatic);
      }
      options.cancelFlatCorners = this->CancelFlatCorners;
      options.given = ConfigurationConversion::ReadConfiguration(singularities, input.plane);
      vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
      vtkPolyData* chosen = vtkPolyData::GetData(outputVector, 1);
      if (!this->Automatic)
      {
        options.coreRadius = this->CoreRadius;
        options.chooseCorners = this->Alternatives > 0;
        options.variations = this->Alternatives > 0;
        std::vector<crossfield::ProposedConfiguration> proposals =
          crossfield::ProposeConfigurations(input.domain, options, progress);
        const auto maximum = static_cast<std::size_t>(this->Alternatives) + 1;
        proposals.resize(std::min(proposals.size(), maximum));
        ConfigurationConversion::WriteConfiguration(
          proposals[0].singularities, input.plane, output);
        CornerConversion::WriteChoices(proposals[0].corners, input.plane, chosen);
        ProposalConversion::WriteTable(proposals,
          crossfield::ResolveCoreRadius(this->CoreRadius, input.domain),
          vtkTable::GetData(outputVector, 2));
        ProposalConversion::WritePoints(
          proposals, input.plane, vtkPolyData::GetData(outputVector, 3));
        return;
      }
      automatic.optimizer.meshSize = this->MeshSize;
      const crossfield::AutomaticConfiguration choice =
        crossfield::ChooseConfiguration(input.domain, automatic, progress);
      const crossfield::OptimizerResult& result = choice.optimum;
      if (!result.converged && !result.aborted)
      {
        vtkWarningMacro(<< result.reason);
      }
      ConfigurationConversion::WriteConfiguration(choice.singularities, input.plane, output);
      CornerConversion::WriteChoices(choice.corners, input.plane, chosen);
      EnergyConversion::WriteOptimizerReport(result, output);
      EnergyConversion::WriteEvents(choice.events, output);
      if (result.aborted)
      {
        FilterRun::KeepAbortedOutput(this, 0);
      }
    });
}

//------------------------------------------------------------------------------
void vtkConfigurationProposal::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "Alternatives: " << this->Alternatives << "\n";
  os << indent << "CoreRadius: " << this->CoreRadius << "\n";
  os << indent << "CancelFlatCorners: " << (this->CancelFlatCorners ? "on" : "off") << "\n";
  os << indent << "CapCorners: " << (this->CapCorners ? "on" : "off") << "\n";
  os << indent << "Automatic: " << (this->Automatic ? "on" : "off") << "\n";
  os << indent << "MeshSize: " << this->MeshSize << "\n";
  os << indent << "Clearance: " << this->Clearance << "\n";
  os << indent << "KeepAll: " << (this->KeepAll ? "on" : "off") << "\n";
}
