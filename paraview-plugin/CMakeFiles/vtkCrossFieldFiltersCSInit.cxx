#include "vtkABI.h"
#include "vtkClientServerInterpreter.h"

extern void vtkCrossFieldArrayNames_Init(vtkClientServerInterpreter*);
extern void vtkBoundaryCornerClassifier_Init(vtkClientServerInterpreter*);
extern void vtkConfigurationProposal_Init(vtkClientServerInterpreter*);
extern void vtkCrossGlyphs_Init(vtkClientServerInterpreter*);
extern void vtkDrillHoles_Init(vtkClientServerInterpreter*);
extern void vtkPerforatedCrossField_Init(vtkClientServerInterpreter*);
extern void vtkPlanarDomainSource_Init(vtkClientServerInterpreter*);
extern void vtkPoincareHopfCheck_Init(vtkClientServerInterpreter*);
extern void vtkSingularitySource_Init(vtkClientServerInterpreter*);
extern void vtkCrossFieldFiltersModule_Init(vtkClientServerInterpreter*);

extern "C" void VTK_ABI_EXPORT vtkCrossFieldFiltersCS_Initialize(vtkClientServerInterpreter* csi)
{
  (void)csi;
  vtkCrossFieldArrayNames_Init(csi);
  vtkBoundaryCornerClassifier_Init(csi);
  vtkConfigurationProposal_Init(csi);
  vtkCrossGlyphs_Init(csi);
  vtkDrillHoles_Init(csi);
  vtkPerforatedCrossField_Init(csi);
  vtkPlanarDomainSource_Init(csi);
  vtkPoincareHopfCheck_Init(csi);
  vtkSingularitySource_Init(csi);
  vtkCrossFieldFiltersModule_Init(csi);
}
