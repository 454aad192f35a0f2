/**
 * @class   vtkCrossGlyphs
 * @brief   draw a cross field as crosses of two lines
 *
 * Port 0 (any vtkDataSet with the cell arrays `Cross`, `Cross2` and `CrossNorm` of the cross field
 * filters): the field. Where they are missing, `Cross` and `CrossNorm` follow from the cell array
 * `CrossFieldCR`, and `Cross2` is at a right angle to `Cross` in the triangle.
 *
 * Output (vtkPolyData): for every cross two VTK_LINE cells through its place, along ±`Cross` and
 * ±`Cross2`, with the cell array `CrossNorm` (double, 1) of the cell it was taken from. By default
 * there is one cross per triangle, at its centre; with Spacing s > 0 at most one per square of a
 * grid of side s, that of the triangle whose centre is nearest to the middle of the square, drawn at
 * the middle if the triangle contains it. The grid is in the plane of the points (see
 * vtkDrillHoles), which then have to lie in one.
 *
 * The length of a line is Scale times the spacing, or Scale times the square root of the cell's
 * area without a spacing; with ScaleByNorm also times `CrossNorm`.
 *
 * An empty input gives an empty output. Failure: an array is missing and does not follow from others; with
 * a spacing, or without `Cross`, points that are not in one plane.
 *
 * @sa vtkPerforatedCrossField
 */

#ifndef vtkCrossGlyphs_h
#define vtkCrossGlyphs_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

class VTKCROSSFIELDFILTERS_EXPORT vtkCrossGlyphs : public vtkPolyDataAlgorithm
{
public:
  static vtkCrossGlyphs* New();
  vtkTypeMacro(vtkCrossGlyphs, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Distance of the crosses, in the units of the domain. Default: 0, one cross per triangle. */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /** Length of a line relative to the room a cross has. Default: 0.8. */
  vtkSetClampMacro(Scale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /** Whether longer crosses show a larger |u|. Default: off. */
  vtkSetMacro(ScaleByNorm, bool);
  vtkGetMacro(ScaleByNorm, bool);
  vtkBooleanMacro(ScaleByNorm, bool);
  ///@}

protected:
  vtkCrossGlyphs();
  ~vtkCrossGlyphs() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkCrossGlyphs(const vtkCrossGlyphs&) = delete;
  void operator=(const vtkCrossGlyphs&) = delete;

  double Spacing = 0.0;
  double Scale = 0.8;
  bool ScaleByNorm = false;
};

#endif
