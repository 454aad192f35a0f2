/**
 * @class   vtkConfigurationProposal
 * @brief   propose a consistent starting configuration of singularities for a planar domain
 *
 * Places singularities of quarter index +1 or −1 so that the Poincaré-Hopf theorem holds: as many
 * as vtkPoincareHopfCheck finds missing. Each is moved in turn to where the largest disk fits
 * between the boundary and the disks of the others, on a grid of 1/64 of the domain's size; the
 * result is spread, not optimal.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 * Port 1, optional, singularities that stay as they are (points): point arrays `QuarterIndex`
 * (integers) and optionally `Radius`.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkPoincareHopfCheck.
 *
 * Output (vtkPolyData): vertices, first those of port 1, then those that cancel flat corners, then
 * the others. Point arrays `QuarterIndex` (int) and `Radius` (double): a third of the distance at
 * which the hole would meet the boundary or another one, at most 1/40 of the domain's diagonal; of
 * port 1 as given, 0 if not.
 *
 * An empty domain gives an empty output. Failure, with an empty output: a domain that vtkDrillHoles
 * refuses; a singularity of port 1 outside of it; arrays that are missing or not integer; a corner
 * that is no vertex of the boundary; a domain too thin for the grid.
 *
 * Paper: the algorithm that closes "Generalized Poincaré-Hopf theorem".
 *
 * @sa vtkPoincareHopfCheck, vtkDrillHoles, crossfield::ProposeConfiguration
 */

#ifndef vtkConfigurationProposal_h
#define vtkConfigurationProposal_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPolyDataAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkConfigurationProposal : public vtkPolyDataAlgorithm
{
public:
  static vtkConfigurationProposal* New();
  vtkTypeMacro(vtkConfigurationProposal, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Port 1, the singularities, and port 2, the corners: connections or data objects. */
  vtkCrossFieldPortMacro(Singularities, 1);
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /** A boundary vertex that turns by more is a corner; degrees. Default: 30. Range: 1 to 45. */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Add a +1 for corners in [3π/4, π), one for two that follow each other, and as many −1
   * elsewhere: these corners can then be regular points of the boundary. Default: off.
   */
  vtkSetMacro(CancelFlatCorners, bool);
  vtkGetMacro(CancelFlatCorners, bool);
  vtkBooleanMacro(CancelFlatCorners, bool);
  ///@}

protected:
  vtkConfigurationProposal();
  ~vtkConfigurationProposal() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConfigurationProposal(const vtkConfigurationProposal&) = delete;
  void operator=(const vtkConfigurationProposal&) = delete;

  double CornerAngle = 30.0;
  bool CancelFlatCorners = false;
};

#endif
