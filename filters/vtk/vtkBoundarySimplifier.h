/**
 * @class   vtkBoundarySimplifier
 * @brief   takes detail out of the boundary of a domain
 *
 * *Thinning* takes out what is far shorter than the triangles of a mesh and would make very many of them: corners within
 * `ThinningLength` L of each other become one, halfway between them, which turns by the sum of their
 * turns; between corners, sides become longer, up to L, while they turn by at most 5°. *Smoothing* takes the
 * waves out of ragged curves that are shorter than `SmoothingLength`; corners farther than that from
 * all others stay. See docs/method.md, sections 10.5 and 10.6.
 *
 * Input port 0: a domain, as for vtkDrillHoles. Input port 1, optional, repeatable: points at which the boundary stays where
 * it is, if they lie on it: singularities and corners that are given for it.
 *
 * Output (of the input's type): where something was taken out, one closed polyline per loop, in the plane of the domain, with
 * the point arrays of the nearest points of the input; else the input. Meshes of vtkDrillHoles, and by default
 * surfaces with point arrays, pass through. Field data, where something was taken out, and nowhere else:
 *
 * | array | meaning |
 * | --- | --- |
 * | `BoundaryMoved` | the largest distance of a point of the boundary to the new one; thinned and smoothed, the sum of both, a bound |
 * | `BoundaryPoints` | two values: its points before and after |
 *
 * Failure: a domain that vtkDrillHoles refuses; a smooth boundary that would cross itself. The output is then empty.
 *
 * @sa vtkDrillHoles, vtkPlanarDomainReader
 */

#ifndef vtkBoundarySimplifier_h
#define vtkBoundarySimplifier_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkBoundarySimplifier : public vtkPassInputTypeAlgorithm
{
public:
  static vtkBoundarySimplifier* New();
  vtkTypeMacro(vtkBoundarySimplifier, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Length of the edges of the mesh that the domain is meant for. Default: 0, 1/40 of the domain's diagonal. */
  vtkSetClampMacro(MeshSize, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MeshSize, double);
  ///@}

  ///@{
  /**
   * Detail below this length is thinned; 0: none. Default: -1, 0.02 of the mesh size, and of 1/40 of the diagonal
   * where that is less.
   */
  vtkSetMacro(ThinningLength, double);
  vtkGetMacro(ThinningLength, double);
  ///@}

  ///@{
  /** Waves below this length are smoothed. Default: 0, none. */
  vtkSetClampMacro(SmoothingLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(SmoothingLength, double);
  ///@}

  ///@{
  /** A boundary vertex that turns by more is a corner; degrees. Default: 30. Range: 1 to 45. */
  vtkSetClampMacro(CornerAngle, double, 1.0, 45.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  /** Adds points at which the boundary stays, port 1. */
  void AddKeptConnection(vtkAlgorithmOutput* output) { this->AddInputConnection(1, output); }

protected:
  vtkBoundarySimplifier();
  ~vtkBoundarySimplifier() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkBoundarySimplifier(const vtkBoundarySimplifier&) = delete;
  void operator=(const vtkBoundarySimplifier&) = delete;

  double MeshSize = 0.0;
  double ThinningLength = -1.0;
  double SmoothingLength = 0.0;
  double CornerAngle = 30.0;
};

#endif
