/**
 * @class   vtkConfigurationProposal
 * @brief   propose a consistent starting configuration of singularities for a planar domain
 *
 * Places singularities so that the Poincaré-Hopf theorem holds. Tried are what a coarse Ginzburg-Landau
 * field shows, corrected to the sum that vtkPoincareHopfCheck asks for, the same without pairs of opposite
 * signs, and places spread over the domain; each takes a few steps of vtkSingularityOptimizer, and the
 * least energy at the core radius wins. With singularities given, or flat corners to cancel, nothing is
 * moved. The result is a start, not optimal. With Automatic the singularities are then moved to where the
 * renormalised energy is least, as by vtkSingularityOptimizer: nothing else has to be known of them.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 * Port 1, optional, singularities that stay as they are (points): point arrays `QuarterIndex`
 * (integers) and optionally `Radius`.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkPoincareHopfCheck.
 *
 * Output port 0 (vtkPolyData): vertices, first those of port 1, then those that cancel flat corners,
 * then the others. Point arrays `QuarterIndex` (int) and `Radius` (double): a third of the distance
 * to the boundary or the next singularity, at most 1/40 of the domain's diagonal; of
 * port 1 as given, and none elsewhere if one of port 1 has none. With Automatic there is `Radius` only
 * where port 1 gives it, and the field data of vtkSingularityOptimizer and `Events` (strings: one sentence
 * for each thing that was decided).
 * Output port 1 (vtkPolyData): the corners of which a quarter index is chosen, with `QuarterIndex`.
 * Output port 2 (vtkTable): the proposal and the Alternatives, the best first, with `Alternative` (int),
 * `Origin` (text), `Singularities` (int), `LogarithmCoefficient`, `RenormalizedEnergy`, `CoreRadius`,
 * `EnergyAtCoreRadius`, which alone compares them, `HolonomyDefect` (largest, radians) and `SizeSpread`
 * (standard deviation of log size, H, over the area).
 * Without Automatic only.
 * Output port 3 (vtkPolyData): the points of all of them, with `Alternative` and `QuarterIndex`; corners
 * with another index than the smallest rotation are points, too.
 *
 * An empty domain gives an empty output. Failure, with an empty output: a domain that vtkDrillHoles
 * refuses; a singularity of port 1 outside of it; arrays that are missing or not integer; a corner
 * that is no vertex of the boundary; a domain too thin for the grid. An optimiser that does not
 * converge is a warning and `Converged` 0.
 *
 * Paper: the algorithm that closes "Generalized Poincaré-Hopf theorem".
 *
 * @sa vtkPoincareHopfCheck, vtkSingularityOptimizer, vtkDrillHoles, crossfield::ProposeConfiguration,
 * crossfield::ChooseConfiguration
 */

#ifndef vtkConfigurationProposal_h
#define vtkConfigurationProposal_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkPolyDataAlgorithm.h"

#include <string> // for SizeArray

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

  ///@{
  /**
   * Sharp corners whose smallest rotation has quarter index 2 get 1, as vtkQuadMesher needs it, and the
   * singularities make up for it. Default: off.
   */
  vtkSetMacro(CapCorners, bool);
  vtkGetMacro(CapCorners, bool);
  vtkBooleanMacro(CapCorners, bool);
  ///@}

  ///@{
  /** Optimise what was proposed; those of port 1 inside the domain move as well. Default: off. */
  vtkSetMacro(Automatic, bool);
  vtkGetMacro(Automatic, bool);
  vtkBooleanMacro(Automatic, bool);
  ///@}

  ///@{
  /**
   * How many alternatives there are besides: other starts, other quarter indices of undecided corners, one by one and
   * together, with what they leave inside, one of ±2 instead of two of ±1, a pair more. Default: 0. Range: 0 to 100.
   */
  vtkSetClampMacro(Alternatives, int, 0, 100);
  vtkGetMacro(Alternatives, int);
  ///@}

  ///@{
  /**
   * Target edge length of the mesh of the optimiser; 0: 1/40 of the diagonal of the bounding box.
   * Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * With Automatic, least distance of the singularities inside to the boundary and to each other, as of
   * vtkSingularityOptimizer; 0: by QuadSize or QuadCount. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(Clearance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Clearance, double);
  ///@}

  ///@{
  /**
   * Length of the sides of the quads to come, or else their number, as of vtkQuadMesher: where Clearance is 0 it is 0.7
   * of that length; where these are 0, too, 1/400 of the diagonal of the bounding box. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(QuadSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(QuadSize, double);
  vtkSetClampMacro(QuadCount, int, 0, VTK_INT_MAX);
  vtkGetMacro(QuadCount, int);
  ///@}

  ///@{
  /**
   * With Automatic, which sizes the quads to come are to have, as of vtkQuadMesher: 0, conformal; 1, uniform; 2, those of
   * the point array SizeArray of the domain, of which QuadSize is then a factor. With 1 and 2 the singularities move
   * on to where sizes are so, as with UniformSizes of vtkSingularityOptimizer. Default: 0, none.
   */
  vtkSetClampMacro(Sizing, int, 0, 2);
  vtkGetMacro(Sizing, int);
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  ///@}
  /** As above; what ParaView calls. */
  void SetSizeArray(const char* name) { this->SetSizeArray(std::string(name ? name : "")); }

  ///@{
  /**
   * With Automatic, up to so many pairs of quarter indices 1 and -1 more than needed, for more even sizes, as of
   * vtkSingularityOptimizer. Default: 0. Range: 0 to 100.
   */
  vtkSetClampMacro(Pairs, int, 0, 100);
  vtkGetMacro(Pairs, int);
  ///@}

  ///@{
  /** With Automatic, every singularity stays what it is, as of vtkSingularityOptimizer. Default: off. */
  vtkSetMacro(KeepAll, bool);
  vtkGetMacro(KeepAll, bool);
  vtkBooleanMacro(KeepAll, bool);
  ///@}

  ///@{
  /**
   * Core radius of singularities at which energies are compared; 0: 1/100 of the diagonal of the bounding
   * box. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(CoreRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CoreRadius, double);
  ///@}

protected:
  vtkConfigurationProposal();
  ~vtkConfigurationProposal() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkConfigurationProposal(const vtkConfigurationProposal&) = delete;
  void operator=(const vtkConfigurationProposal&) = delete;

  double CornerAngle = 30.0;
  bool CancelFlatCorners = false;
  bool CapCorners = false;
  bool Automatic = false;
  double MeshSize = 0.0;
  double Clearance = 0.0;
  double QuadSize = 0.0;
  int QuadCount = 0;
  int Sizing = 0;
  std::string SizeArray;
  int Pairs = 0;
  bool KeepAll = false;
  int Alternatives = 0;
  double CoreRadius = 0.0;
};

#endif
