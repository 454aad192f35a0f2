/**
 * @class   vtkPlanarDomainSource
 * @brief   boundary loops of a built-in planar domain
 *
 * Output (vtkPolyData): one closed polyline per boundary loop in the plane z = 0,
 * counter-clockwise, the outer loop first. Straight sides are single segments; curves are segments
 * of about EdgeLength with their points on the curve.
 *
 * | DomainName | lengths read | place |
 * | --- | --- | --- |
 * | disk | Radius | centred at the origin |
 * | ring | Radius, InnerRadius | centred at the origin |
 * | ellipse | Width, Height (the axes) | centred at the origin |
 * | quarter-disk | Radius | centre at the origin, first quadrant |
 * | square | Width | lower left corner at the origin |
 * | rectangle | Width, Height | lower left corner at the origin |
 * | l-shape | Width; the upper right quarter is missing | lower left corner at the origin |
 * | hexagonal | Radius of its corners | centred at the origin, regular |
 * | star | Radius, InnerRadius | centred at the origin, five tips |
 * | angular-balanced | Width | left side on the y axis, symmetric about the x axis |
 * | angular-negative | Width | centred at the origin |
 * | angular-positive | Width | centred at the origin |
 * | angular-hole | Width | centred at the origin |
 *
 * The angular domains are those of the paper's section "Generalized Poincaré-Hopf theorem", drawn
 * from its text: six sides with two angles of 145° and four of 107.5° (interior singularities of
 * total 0); a hexagon with angles of 100° and 130° (two −1/4); one with angles of 80° and 140° (two
 * +1/4); the latter with a round hole of radius Width / 10 (total −2/4, four flat angles).
 *
 * Failure: an unknown name or a length that is not positive; the output is then empty.
 *
 * @sa vtkDrillHoles, crossfield::MakeBuiltinDomain
 */

#ifndef vtkPlanarDomainSource_h
#define vtkPlanarDomainSource_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for DomainName

class VTKCROSSFIELDFILTERS_EXPORT vtkPlanarDomainSource : public vtkPolyDataAlgorithm
{
public:
  static vtkPlanarDomainSource* New();
  vtkTypeMacro(vtkPlanarDomainSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The shape; see the table above. Default: disk. */
  vtkSetMacro(DomainName, std::string);
  vtkGetMacro(DomainName, std::string);
  ///@}

  ///@{
  /** Radius of disk, ring (its outer circle), quarter-disk, hexagonal and star. Default: 1. */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Radius of the inner circle of the ring, and of the inner corners of the star. Default: 0.4, the
   * ratio of the paper's first ring.
   */
  vtkSetMacro(InnerRadius, double);
  vtkGetMacro(InnerRadius, double);
  ///@}

  ///@{
  /** Width of ellipse, square, rectangle, l-shape and the angular domains. Default: 2. */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Height of ellipse and rectangle. Default: 1. */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Length of the segments that stand for curves. Default: 0, which means 1/40 of the diagonal of
   * the bounding box, the default mesh size of vtkDrillHoles.
   */
  vtkSetMacro(EdgeLength, double);
  vtkGetMacro(EdgeLength, double);
  ///@}

protected:
  vtkPlanarDomainSource();
  ~vtkPlanarDomainSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPlanarDomainSource(const vtkPlanarDomainSource&) = delete;
  void operator=(const vtkPlanarDomainSource&) = delete;

  std::string DomainName = "disk";
  double Radius = 1.0;
  double InnerRadius = 0.4;
  double Width = 2.0;
  double Height = 1.0;
  double EdgeLength = 0.0;
};

#endif
