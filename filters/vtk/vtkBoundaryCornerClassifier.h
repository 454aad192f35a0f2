/**
 * @class   vtkBoundaryCornerClassifier
 * @brief   choose the quarter indices of the corners of a planar domain
 *
 * A corner of interior angle α with quarter index k costs e(α, k) = (π − α − k π/2)² / (2α), the
 * coefficient of log(1/ρ) in ½ ∫ |∇θ|² around it, and every interior singularity of index ±1 that is
 * then still needed costs c = π/16. The filter finds the indices of least
 *   Σ_i e(α_i, k_i) + c |4χ − Σ_i k_i|,   χ = 1 − number of inner loops,
 * exactly, and the indices by the rules of the three scenarios of the paper, a = α / 2π:
 * - scarce (Σk < 4χ):   3/8 − 7a/8 ≤ k/4 ≤ 5/8 − 7a/8;
 * - excess (Σk > 4χ):   3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 9a/8;
 * - balanced (Σk = 4χ): the cheapest with this sum; feasible when all corners are within
 *                       3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 7a/8.
 * A scenario is feasible when its sum is as it supposes; every feasible one is of least cost. The
 * conventional index is the nearest of 2, 1, 0, −1, −2 to α = 0, π/2, π, 3π/2, 2π, which is the one
 * of the smallest rotation of the cross.
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 *
 * Output 0 (vtkPolyData): a vertex at each boundary vertex that turns by more than CornerAngle, of
 * outer and inner loops. Point arrays, 1 component:
 * - `Angle` (double): inside the domain, radians in (0, 2π);
 * - `QuarterIndex` (int): in the cheapest assignment, after splitting;
 * - `QuarterIndexScarce`, `QuarterIndexBalanced`, `QuarterIndexExcess`, `QuarterIndexConventional`
 *   (int): by the rules above;
 * - `CornerEnergy` (double): e(Angle, QuarterIndex);
 * - `Cancellable` (int): 1 for angles in [3π/4, π), which interior singularities can make regular
 *   points of the boundary;
 * - `Tied` (int): 1 where another assignment of the same cost has another index;
 * - `Overridden` (int): 1 where the index was given.
 * Field data: `Scenario` (string: scarce, balanced or excess), `Energy` (double, the cost),
 * `InteriorQuarters` (int, 4χ − Σ QuarterIndex).
 *
 * Output 1 (vtkTable), rows scarce, balanced, excess: `Scenario` (string), `Sum` (int), `Energy`
 * (double), `Feasible`, `Chosen` (int, 0 or 1).
 *
 * Output 2 (vtkPolyData): the singularities that SplitHalves adds, points with `QuarterIndex` (1)
 * and `Radius` (0: none given), part of InteriorQuarters.
 *
 * An empty domain gives empty outputs. Failure, with empty outputs: a domain that vtkDrillHoles
 * refuses; an override on a domain without corners or for a point that does not exist, or whose
 * index is not an integer.
 *
 * Paper: "New computations for placing boundary singularities" and its appendix. Differences from
 * it: the exact minimum is found directly; the energy of an interior singularity is counted like
 * that of a corner, π (k/4)², as in the theorems, not twice that as printed (PrintedCoefficient).
 *
 * @sa vtkPoincareHopfCheck, vtkPerforatedCrossField, crossfield::ClassifyCorners
 */

#ifndef vtkBoundaryCornerClassifier_h
#define vtkBoundaryCornerClassifier_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <array>  // for the overrides
#include <vector> // for the overrides

class VTKCROSSFIELDFILTERS_EXPORT vtkBoundaryCornerClassifier : public vtkPolyDataAlgorithm
{
public:
  static vtkBoundaryCornerClassifier* New();
  vtkTypeMacro(vtkBoundaryCornerClassifier, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A boundary vertex that turns by more is a corner, others stand for a curve; degrees. Default:
   * 30. Range: 1 to 45; a vertex that turns by more than 45° makes the cross jump.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /** Count interior singularities with c = π/8, as the paper prints it, not π/16. Default: off. */
  vtkSetMacro(PrintedCoefficient, bool);
  vtkGetMacro(PrintedCoefficient, bool);
  vtkBooleanMacro(PrintedCoefficient, bool);
  ///@}

  ///@{
  /**
   * Replace k = 2, which quad meshes cannot use, by k = 1 and an interior singularity k = 1 close
   * to the corner. Default: off.
   */
  vtkSetMacro(SplitHalves, bool);
  vtkGetMacro(SplitHalves, bool);
  vtkBooleanMacro(SplitHalves, bool);
  ///@}

  ///@{
  /**
   * The quarter index of the corner nearest to (x, y), by row; a row beyond the last adds one. In
   * coordinates of the domain's plane, see vtkDrillHoles.
   */
  void SetOverride(int row, double x, double y, double quarterIndex);
  void AddOverride(double x, double y, double quarterIndex);
  void RemoveAllOverrides();
  ///@}

  ///@{
  /** The quarter index of the corner nearest to a point of the input, by row and point id. */
  void SetPointOverride(int row, vtkIdType pointId, double quarterIndex);
  void AddPointOverride(vtkIdType pointId, double quarterIndex);
  void RemoveAllPointOverrides();
  ///@}

protected:
  vtkBoundaryCornerClassifier();
  ~vtkBoundaryCornerClassifier() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoundaryCornerClassifier(const vtkBoundaryCornerClassifier&) = delete;
  void operator=(const vtkBoundaryCornerClassifier&) = delete;

  double CornerAngle = 30.0;
  bool PrintedCoefficient = false;
  bool SplitHalves = false;
  std::vector<std::array<double, 3>> Overrides;
  std::vector<std::array<double, 2>> PointOverrides;
};

#endif
