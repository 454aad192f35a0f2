/**
 * @class   vtkSingularityEnergy
 * @brief   energies of one or more configurations of singularities, with bounds, the best first
 *
 * For every configuration the energy E_ρ = ½ ∫ |∇φ|² of the cross field of norm one, φ = 4θ, on the
 * domain with a hole of radius ρ_j at every singularity, around which φ turns k_j times; and the
 * renormalised energy W that remains as ρ → 0,
 *   E_ρ = log(1/ρ) (Σ_j π k_j² + Σ_c 16 e(α_c, k_c)) + W + o(1),
 * the sums over singularities and corners, e(α, k) = (π − α − k π/2)² / (2α).
 *
 * Port 0, the domain (vtkPolyData or vtkUnstructuredGrid): as for vtkDrillHoles.
 * Port 1, one or more connections, a configuration each (points): point arrays `QuarterIndex`
 * (integers) and optionally `Radius`, inside or on the boundary as for vtkHField. Without radii holes
 * have the mesh size as radius.
 * Port 2, optional, corners (points) with `QuarterIndex` (integers), as for vtkHField.
 *
 * Output port 0 (vtkTable): one row per configuration, sorted by the energy at the core radius;
 * inconsistent ones last. Columns:
 * - `Configuration` (int): number of the connection on port 1, from 0;
 * - `Consistent` (int): whether it satisfies the Poincaré-Hopf theorem; else all numbers are NaN;
 * - `Energy`: E_ρ of the field aligned with the boundary: the middle of its bounds, whose errors have
 *   opposite signs and the same size but for higher orders;
 * - `EnergyLowerBound`, `EnergyUpperBound`: bounds of it on this polygon, for a boundary phase that is
 *   linear along its edges. The gap closes at second order: below the default mesh size the triangles
 *   at holes shrink with the others, and those at re-entrant corners faster. On straight sides the lower bound is
 *   the energy of vtkPerforatedCrossField (UnitNorm) on this mesh. At corners with a rotation of the
 *   cross E_ρ is infinite, and these numbers grow with the logarithm of the mesh size;
 * - `EnergyDegreeOnly`, `EnergyDegreeOnlyLowerBound`, `EnergyDegreeOnlyUpperBound`: E_ρ of a field
 *   that may rotate along the boundary: the middle of its bounds, and these;
 * - `LogarithmCoefficient`, `RenormalizedEnergy`: see above, W of the aligned field;
 * - `CoreRadius`, `EnergyAtCoreRadius`: ρ, and W + coefficient × log(1/ρ): compare by this. W alone
 *   compares configurations of equal coefficients only;
 * - `HolonomyDefect`: the largest by size of the inner loops, radians in (−π, π]; 0 without any. Its
 *   harmonic field is part of the aligned energies and of W.
 * Output port 1 (vtkPolyData): the interior singularities of all rows in that order, with the point
 * arrays `Configuration` (int), `QuarterIndex` (int) and `Gradient` (double, 3): the derivative of W
 * in the position; minus it is the direction in which the singularity should move.
 *
 * An empty domain gives empty outputs. Failure, with empty outputs: a domain that vtkDrillHoles
 * refuses; a singularity outside; a hole that cuts the boundary or another hole; missing arrays. An
 * inconsistent configuration is no failure.
 *
 * Paper: "How to evaluate the choice of a singularity location". Differences from it: the aligned
 * energy beside the printed one; the coefficient of corners; bounds.
 *
 * @sa vtkHField, vtkSingularityOptimizer, crossfield::CompareConfigurations
 */

#ifndef vtkSingularityEnergy_h
#define vtkSingularityEnergy_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of ports
#include "vtkTableAlgorithm.h"

#include <memory> // for what is kept

class CachedDomain;

class VTKCROSSFIELDFILTERS_EXPORT vtkSingularityEnergy : public vtkTableAlgorithm
{
public:
  static vtkSingularityEnergy* New();
  vtkTypeMacro(vtkSingularityEnergy, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Adds a connection to port 1, a configuration. */
  void AddConfigurationConnection(vtkAlgorithmOutput* output)
  {
    this->AddInputConnection(1, output);
  }
  /** Adds a data object to port 1. */
  void AddConfigurationData(vtkDataObject* data) { this->AddInputDataObject(1, data); }
  /** Removes all connections of port 1. */
  void RemoveAllConfigurations() { this->RemoveAllInputConnections(1); }
  ///@{
  /** Connects port 2, the corners, or sets it to a data object. */
  vtkCrossFieldPortMacro(Corners, 2);
  ///@}

  ///@{
  /**
   * Target edge length of the meshes; 0: 1/40 of the diagonal of the bounding box. Default: 0.
   * Range: 0 or more.
   */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Core radius of singularities at which energies are compared; 0: 1/100 of the diagonal of the bounding
   * box. Default: 0. Range: 0 or more.
   */
  vtkSetClampMacro(CoreRadius, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(CoreRadius, double);
  ///@}

  ///@{
  /**
   * Meshes and factors the domain once, whatever its singularities, and keeps both until the domain, the mesh size or a singularity on
   * the boundary changes: a moved singularity is then quick. The mesh is not refined at singularities, and there are no energies
   * of domains with holes, which would have to be drilled: their columns are NaN. Default: off.
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
  std::unique_ptr<CachedDomain> Kept;
};

#endif
