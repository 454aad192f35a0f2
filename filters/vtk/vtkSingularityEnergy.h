/**
 * @class   vtkSingularityEnergy
 * @brief   compute energies of configurations of singularities, with bounds, the best first
 *
 * Computes for every configuration the energy E_ρ = ½ ∫ |∇φ|² of the cross field of norm one, φ =
 * 4θ, on the domain with a hole of radius ρ_j at every singularity, around which φ turns k_j times;
 * and the renormalised energy W that remains as ρ → 0,
 *   E_ρ = log(1/ρ) (Σ_j π k_j² + Σ_c 16 e(α_c, k_c)) + W + o(1),
 * with sums over singularities and corners, and e(α, k) = (π − α − k π/2)² / (2α).
 *
 * Input port 0 (vtkPolyData or vtkUnstructuredGrid): the domain, as for vtkDrillHoles.
 * Input port 1, repeatable: one configuration (points) per connection, with the point arrays
 * `QuarterIndex` (integers) and optionally `Radius`, inside or on the boundary as for vtkHField.
 * Without radii holes have the mesh size as radius.
 * Input port 2, optional: corners (points) with `QuarterIndex` (integers), as for vtkHField.
 *
 * Output port 0 (vtkTable): one row per configuration, sorted by the energy at the core radius,
 * inconsistent configurations last. Columns:
 * - `Configuration` (int): number of the connection on port 1, from 0;
 * - `Consistent` (int): 1 if the configuration satisfies the Poincaré-Hopf theorem; otherwise all
 *   numbers are NaN;
 * - `Energy`: E_ρ of the field aligned with the boundary, computed as the mean of its bounds, whose
 *   errors have opposite signs and, up to higher orders, the same size;
 * - `EnergyLowerBound`, `EnergyUpperBound`: bounds of it on this polygon, for a boundary phase that
 *   is linear along its edges. The gap closes at second order: below the default mesh size the
 *   triangles at holes shrink with the others, and those at re-entrant corners faster. On straight
 *   sides the lower bound is the energy of vtkPerforatedCrossField (UnitNorm) on this mesh. At
 *   corners with a rotation of the cross E_ρ is infinite, and these numbers grow with the logarithm
 *   of the mesh size;
 * - `EnergyDegreeOnly`, `EnergyDegreeOnlyLowerBound`, `EnergyDegreeOnlyUpperBound`: E_ρ of a field
 *   that may rotate along the boundary, the mean of its bounds, and these bounds;
 * - `LogarithmCoefficient`, `RenormalizedEnergy`: the factor of log(1/ρ) above, and W of the
 *   aligned field;
 * - `CoreRadius`, `EnergyAtCoreRadius`: ρ, and W + coefficient × log(1/ρ), the energy for comparing
 *   configurations. W alone compares configurations of equal coefficients only;
 * - `HolonomyDefect`: the defect of largest magnitude of the inner loops, radians in (−π, π]; 0
 *   without inner loops. Its harmonic field is part of the aligned energies and of W.
 *
 * Output port 1 (vtkPolyData): the interior singularities of all rows in that order, with the point
 * arrays `Configuration` (int), `QuarterIndex` (int) and `Gradient` (double, 3), the derivative of
 * W with respect to the position. The singularity should move in the direction of −Gradient.
 *
 * An empty domain gives empty outputs. The filter fails, with empty outputs, if vtkDrillHoles would
 * refuse the domain, if a singularity is outside, if a hole cuts the boundary or another hole, or
 * if arrays are missing. An inconsistent configuration is not a failure.
 *
 * Paper: "How to evaluate the choice of a singularity location". Differences from the paper: the
 * aligned energy in addition to the printed one; the coefficient of corners; bounds.
 *
 * @sa vtkHField, vtkSingularityOptimizer, crossfield::CompareConfigurations
 */

#ifndef vtkSingularityEnergy_h
#define vtkSingularityEnergy_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkTableAlgorithm.h"

#include <memory> // for the cached domain

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkSingularityEnergy : public vtkTableAlgorithm
{
public:
  static vtkSingularityEnergy* New();
  vtkTypeMacro(vtkSingularityEnergy, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Adds a connection to port 1 with one more configuration. */
  void AddConfigurationConnection(vtkAlgorithmOutput* output)
  {
    this->AddInputConnection(1, output);
  }
  /** Adds a data object to port 1 with one more configuration. */
  void AddConfigurationData(vtkDataObject* data) { this->AddInputDataObject(1, data); }
  /** Removes all connections of port 1. */
  void RemoveAllConfigurations() { this->RemoveAllInputConnections(1); }
  ///@{
  /** Connects port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Sets the target edge length of the meshes. Default: 0, 1/40 of the diagonal of the bounding
   * box. Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Sets the core radius of singularities at which energies are compared. Default: 0, 1/100 of the
   * diagonal of the bounding box. Range: 0 or more.
   */
  vtkSetClampMacro(CoreRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /**
   * Meshes and factors the domain only once and reuses both until the domain, the mesh size or a
   * singularity on the boundary changes, so that an update after moving a singularity is fast. The
   * mesh is not refined at singularities. Energies of domains with holes need a drilled mesh and
   * are not computed: their columns are NaN. Default: off.
   */
  vtkSetMacro(KeepMesh, bool);
  vtkGetMacro(KeepMesh, bool);
  vtkBooleanMacro(KeepMesh, bool);
  ///@}

protected:
  vtkSingularityEnergy();
  ~vtkSingularityEnergy() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSingularityEnergy(const vtkSingularityEnergy&) = delete;
  void operator=(const vtkSingularityEnergy&) = delete;

  double MeshSize = 0.0;
  double CoreRadius = 0.0;
  bool KeepMesh = false;
  std::unique_ptr<CachedDomain> Cache;
};

#endif
