/**
 * @class   vtkPlanarDomainSource
 * @brief   create the boundary loops of a built-in planar domain
 *
 * Output port 0 (vtkPolyData): one closed polyline per boundary loop in the plane z = 0,
 * counter-clockwise, the outer loop first. Straight sides are single segments. Curves are divided
 * into segments of about EdgeLength whose end points are on the curve.
 *
 * | DomainName | lengths used | position |
 * | --- | --- | --- |
 * | disk | Radius | centred at the origin |
 * | ring | Radius, InnerRadius | centred at the origin |
 * | ellipse | Width, Height (the axes) | centred at the origin |
 * | quarter-disk | Radius | centre at the origin, first quadrant |
 * | square | Width | lower left corner at the origin |
 * | rectangle | Width, Height | lower left corner at the origin |
 * | l-shape | Width; the upper right quarter is missing | lower left corner at the origin |
 * | hexagonal | Radius of its corners | centred at the origin, regular |
 * | star | Radius, InnerRadius | centred at the origin, five sharp corners |
 * | angular-balanced | Width | left side on the y axis, symmetric about the x axis |
 * | angular-negative | Width | centred at the origin |
 * | angular-positive | Width | centred at the origin |
 * | angular-hole | Width | centred at the origin |
 *
 * The angular domains are those of the paper's section "Generalized Poincaré-Hopf theorem",
 * constructed from its text: angular-balanced has six sides with two angles of 145° and four of
 * 107.5° (the interior singularities add up to 0); angular-negative is a hexagon with angles of
 * 100° and 130° (two singularities of index −1/4); angular-positive is a hexagon with angles of 80°
 * and 140° (two of +1/4); angular-hole is the latter with a round hole of radius Width / 10 (total
 * −2/4, four flat angles).
 *
 * The source fails, with an empty output, if the name is unknown or a length is not positive.
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
  /** Sets the name of the shape; see the table above. Default: disk. */
  vtkSetMacro(DomainName, std::string);
  vtkGetMacro(DomainName, std::string);
  ///@}

  ///@{
  /** Sets the radius of disk, ring (outer circle), quarter-disk, hexagonal and star. Default: 1. */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Sets the radius of the inner circle of the ring and of the inner corners of the star. Default:
   * 0.4, as in the first ring of the paper.
   */
  vtkSetMacro(InnerRadius, double);
  vtkGetMacro(InnerRadius, double);
  ///@}

  ///@{
  /** Sets the width of ellipse, square, rectangle, l-shape and the angular domains. Default: 2. */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /** Sets the height of ellipse and rectangle. Default: 1. */
  vtkSetMacro(Height, double);
  vtkGetMacro(Height, double);
  ///@}

  ///@{
  /**
   * Sets the length of the segments of curves. Default: 0, 1/40 of the diagonal of the bounding
   * box, the default mesh size of vtkDrillHoles.
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
