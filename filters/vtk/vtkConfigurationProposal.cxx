#include "vtkConfigurationProposal.h"

#include "ConfigurationProposal.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "FilterPorts.h"
#include "FilterRun.h"

#include "vtkDataSet.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkConfigurationProposal);

//------------------------------------------------------------------------------
vtkConfigurationProposal::vtkConfigurationProposal()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
int vtkConfigurationProposal::FillInputPortInformation(int port, vtkInformation* info)
{
  return port == 0 ? FilterPorts::TakeDomain(info) : FilterPorts::TakeOptionalPoints(info);
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
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain);
      crossfield::ProposalOptions options;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      options.corners = CornerConversion::ReadCorners(corners, input.plane);
      options.cancelFlatCorners = this->CancelFlatCorners;
      options.given = DomainConversion::ReadConfiguration(singularities, input.plane);
      DomainConversion::WriteConfiguration(
        crossfield::ProposeConfiguration(input.domain, options, progress), input.plane,
        vtkPolyData::GetData(outputVector));
    });
}

//------------------------------------------------------------------------------
void vtkConfigurationProposal::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "CancelFlatCorners: " << (this->CancelFlatCorners ? "on" : "off") << "\n";
}
