/**
 * @class   vtkBoundaryCornerClassifier
 * @brief   choose the quarter indices of the corners of a planar domain
 *
 * A corner of interior angle α with quarter index k costs e(α, k) = (π − α − k π/2)² / (2α), the
 * coefficient of log(1/ρ) in ½ ∫ |∇θ|² around it. Every interior singularity of index ±1 that the
 * domain then still needs costs c = π/16. The filter finds the indices that minimise
 *   Σ_i e(α_i, k_i) + c |4χ − Σ_i k_i|,   χ = 1 − number of inner loops,
 * exactly. It also computes the indices by the rules of the three scenarios of the paper, with a =
 * α / 2π:
 * - scarce (Σk < 4χ): 3/8 − 7a/8 ≤ k/4 ≤ 5/8 − 7a/8;
 * - excess (Σk > 4χ): 3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 9a/8;
 * - balanced (Σk = 4χ): the cheapest indices with this sum. It is feasible when all corners satisfy
 *   3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 7a/8.
 * A scenario is feasible when its indices have the sum that defines it. Every feasible scenario has
 * the minimum cost. The conventional index of a corner is 2, 1, 0, −1 or −2, whichever belongs to
 * the nearest of the angles 0, π/2, π, 3π/2 and 2π. It needs the smallest rotation of the cross.
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles.
 *
 * Output port 0 (vtkPolyData): one vertex for each boundary vertex, on outer and inner loops, that
 * turns by more than CornerAngle. Point arrays, 1 component:
 * - `Angle` (double): the angle inside the domain, in radians in (0, 2π);
 * - `QuarterIndex` (int): the index in the cheapest assignment, after splitting (see SplitHalves);
 * - `QuarterIndexScarce`, `QuarterIndexBalanced`, `QuarterIndexExcess`, `QuarterIndexConventional`
 *   (int): the indices by the rules above;
 * - `CornerEnergy` (double): e(Angle, QuarterIndex);
 * - `Cancellable` (int): 1 for angles in [3π/4, π), at corners that interior singularities can turn
 *   into regular points of the boundary;
 * - `Tied` (int): 1 where another assignment of the same cost has another index;
 * - `Overridden` (int): 1 where the index was prescribed by an override.
 * Field data: `Scenario` (string: scarce, balanced or excess), `Energy` (double, the cost),
 * `InteriorQuarters` (int, 4χ − Σ QuarterIndex).
 *
 * Output port 1 (vtkTable): three rows, scarce, balanced and excess. Columns: `Scenario` (string),
 * `Sum` (int), `Energy` (double), `Feasible` and `Chosen` (int, 0 or 1).
 *
 * Output port 2 (vtkPolyData): the singularities that SplitHalves adds, as points with
 * `QuarterIndex` (1) and `Radius` (0, not given). They are part of InteriorQuarters.
 *
 * An empty domain gives empty outputs. The filter fails, with empty outputs, if vtkDrillHoles would
 * refuse the domain, if an override is given for a domain without corners or for a point that does
 * not exist, or if the index of an override is not an integer.
 *
 * Paper: "New computations for placing boundary singularities" and its appendix. Differences from
 * the paper: the exact minimum is found directly; the energy of an interior singularity is counted
 * like that of a corner, π (k/4)², as in the theorems, and not twice that as printed (see
 * PrintedCoefficient).
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
   * Sets the turning angle, in degrees, above which a boundary vertex is a corner. Other vertices
   * are samples of a curve. Default: 30. Range: 1 to 45; where a vertex turns by more than 45° the
   * cross jumps.
   */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Uses c = π/8 for interior singularities, as printed in the paper, instead of π/16. Default:
   * off.
   */
  vtkSetMacro(PrintedCoefficient, bool);
  vtkGetMacro(PrintedCoefficient, bool);
  vtkBooleanMacro(PrintedCoefficient, bool);
  ///@}

  ///@{
  /**
   * Replaces k = 2, which quad meshes cannot represent, by k = 1 at the corner and an interior
   * singularity of k = 1 close to it. Default: off.
   */
  vtkSetMacro(SplitHalves, bool);
  vtkGetMacro(SplitHalves, bool);
  vtkBooleanMacro(SplitHalves, bool);
  ///@}

  ///@{
  /**
   * Prescribes the quarter index of the corner nearest to (x, y), by row. A row beyond the last one
   * appends a row. Coordinates are those of the plane of the domain; see vtkDrillHoles. Default: no
   * overrides.
   */
  void SetOverride(int row, double x, double y, double quarterIndex);
  void AddOverride(double x, double y, double quarterIndex);
  void RemoveAllOverrides();
  ///@}

  ///@{
  /**
   * Prescribes the quarter index of the corner nearest to a point of the input, by row and point
   * id. Default: no overrides.
   */
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
