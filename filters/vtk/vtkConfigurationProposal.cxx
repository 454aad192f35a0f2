#include "vtkConfigurationProposal.h"

#include "ConfigurationProposal.h"
#include "CornerConversion.h"
#include "DomainConversion.h"
#include "FilterRun.h"

#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
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
  if (port == 0)
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
    info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  }
  else
  {
    info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkConfigurationProposal::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkDataSet* domain = vtkDataSet::GetData(inputVector[0]);
  vtkDataSet* singularities = vtkDataSet::GetData(inputVector[1]);
  vtkDataSet* corners = vtkDataSet::GetData(inputVector[2]);
  this->ErrorCode = FilterRun::Run(this,
    [&](const crossfield::Progress& progress)
    {
      if (domain->GetNumberOfCells() == 0)
      {
        return;
      }
      const DomainConversion::Domain input = DomainConversion::ReadDomain(domain);
      crossfield::ProposalOptions options;
      options.cornerAngle = vtkMath::RadiansFromDegrees(this->CornerAngle);
      options.corners = CornerConversion::ReadChoices(corners, input.plane);
      options.cancelFlatCorners = this->CancelFlatCorners;
      options.given = DomainConversion::ReadConfiguration(singularities, input.plane);
      CornerConversion::WriteConfiguration(
        crossfield::ProposeConfiguration(input.domain, options, progress), input.plane,
        vtkPolyData::GetData(outputVector));
    });
  return this->ErrorCode == vtkErrorCode::NoError ? 1 : 0;
}

//------------------------------------------------------------------------------
void vtkConfigurationProposal::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "CancelFlatCorners: " << (this->CancelFlatCorners ? "on" : "off") << "\n";
}
