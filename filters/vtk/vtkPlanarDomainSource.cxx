#include "vtkPlanarDomainSource.h"

#include "BuiltinDomains.h"
#include "DomainConversion.h"
#include "FilterRun.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkPlanarDomainSource);

//------------------------------------------------------------------------------
vtkPlanarDomainSource::vtkPlanarDomainSource()
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
int vtkPlanarDomainSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  return FilterRun::Run(this, this->ErrorCode,
    [&](const crossfield::Progress&)
    {
      crossfield::BuiltinDomain domain;
      domain.name = this->DomainName;
      domain.radius = this->Radius;
      domain.innerRadius = this->InnerRadius;
      domain.width = this->Width;
      domain.height = this->Height;
      domain.edgeLength = this->EdgeLength;
      DomainConversion::WriteLoops(
        crossfield::MakeBuiltinDomain(domain), vtkPolyData::GetData(outputVector));
    });
}

//------------------------------------------------------------------------------
void vtkPlanarDomainSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DomainName: " << this->DomainName << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "InnerRadius: " << this->InnerRadius << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "EdgeLength: " << this->EdgeLength << "\n";
}
