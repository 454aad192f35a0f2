/**
 * @class   vtkCrossGlyphs
 * @brief   draw a cross field as crosses of two lines
 *
 * Input port 0 (any vtkDataSet): a field with the cell arrays `Cross`, `Cross2` and `CrossNorm` of
 * the cross field filters. Missing `Cross` and `CrossNorm` are computed from the cell array
 * `CrossFieldCR`; a missing `Cross2` is perpendicular to `Cross` in the plane of the triangle.
 *
 * Output port 0 (vtkPolyData): for every cross two VTK_LINE cells through its centre, along
 * ±`Cross` and ±`Cross2`, with the cell array `CrossNorm` (double, 1) of the triangle. By default
 * there is one cross at the centre of each triangle. With Spacing s > 0 there is at most one cross
 * per square of a grid of side s: that of the triangle whose centre is nearest to the centre of the
 * square. It is drawn at the centre of the square if the triangle contains it. The grid is in the
 * plane of the points (see vtkDrillHoles), which must then be coplanar.
 *
 * The length of a line is Scale times the spacing or, without a spacing, Scale times the square
 * root of the area of the triangle; with ScaleByNorm also times `CrossNorm`.
 *
 * An empty input gives an empty output. The filter fails if an array is missing and cannot be
 * computed from others, and, with a spacing or without `Cross`, if the points are not coplanar.
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
  /**
   * Sets the distance between crosses, in the units of the domain. Default: 0, one cross per
   * triangle. Range: 0 or more.
   */
  vtkSetClampMacro(Spacing, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /**
   * Sets the length of a line relative to the spacing, or to the square root of the area of its
   * triangle. Default: 0.8. Range: 0 or more.
   */
  vtkSetClampMacro(Scale, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /** Scales the length of the lines by |u|. Default: off. */
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
