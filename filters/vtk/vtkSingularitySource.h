/**
 * @class   vtkSingularitySource
 * @brief   create a configuration of singularities from rows, a .csv file or other points
 *
 * A singularity is a point with a quarter index k: the representation e^{4iθ} of the cross field
 * turns k times around it, and its index is k/4. k = +1 becomes a node of valence 3 of the quad
 * mesh, k = −1 one of valence 5.
 *
 * Input port 0, Start, optional: points with the point array `QuarterIndex` and optionally
 * `Radius`.
 * Input port 1, Domain, optional (vtkPolyData or vtkUnstructuredGrid): a domain that defines the
 * plane of the rows, and to which the default rows are fitted.
 *
 * Rows are in the coordinates of a plane in space, as in the other filters
 * (crossfield::DomainPlane): x and y where z is constant. The plane is that of Domain; without it,
 * the plane in the field data `Plane` of Start if its points are in it; otherwise z = const through
 * the first point of Start, or z = 0. The points of a file, of Start and of handles are points in
 * space.
 *
 * Output port 0 (vtkPolyData): one vertex per row, with the field data `Plane` (double, 3 tuples:
 * origin and axes) unless the plane is z = const, and the point arrays
 * - `QuarterIndex` (int, 1 component): k;
 * - `Radius` (double, 1 component): radius of the hole that will be drilled; absent if the file or
 *   Start has no such column, or if it is 0 in every row, which means not given.
 *
 * The rows are those of the file if FileName is set; otherwise those set here. As long as these are
 * the default rows, they are replaced by the points of Start; without Start by rows that fit
 * Domain: spread inside it, with the sum of quarter indices that the Poincaré-Hopf theorem requires
 * and the radii that vtkDrillHoles would choose (crossfield::SpreadConfiguration). The default rows
 * themselves, used without either, are for the unit disk.
 *
 * A file is comma-separated with the header `x,y,quarter_index` and optionally `radius` and `z`, in
 * any order. Domains in a plane z = const ignore z; for other domains the points of a file must be
 * in the plane of the domain.
 *
 * With UseHandles on, handle i replaces the position of row i. Handles are the points that ParaView
 * lets the user drag in the 3D view. A row without a handle is omitted. A handle without a row is a
 * singularity of quarter index 1 with the radius of the last row (0.1 without rows).
 *
 * The source fails, with an empty output, if a file does not exist, lacks a column or has an entry
 * that is not a finite number, if a quarter index is not an integer, if Start has no
 * `QuarterIndex`, or if default rows are fitted to a domain that vtkDrillHoles would refuse.
 *
 * @sa vtkDrillHoles
 */

#ifndef vtkSingularitySource_h
#define vtkSingularitySource_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkCrossFieldPortMacro.h"     // for the setters of Start
#include "vtkNew.h"                     // for the output rows
#include "vtkPolyDataAlgorithm.h"

#include <array>  // for the rows
#include <string> // for FileName
#include <vector> // for the rows

class vtkDoubleArray;

class VTKCROSSFIELDFILTERS_EXPORT vtkSingularitySource : public vtkPolyDataAlgorithm
{
public:
  static vtkSingularitySource* New();
  vtkTypeMacro(vtkSingularitySource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Connects the optional port 0, the initial points, or sets it to a data object. */
  vtkCrossFieldPortMacro(Start, 0);
  ///@}

  ///@{
  /**
   * Connects the optional port 1, the domain of the plane and of the default rows, or sets it to a
   * data object.
   */
  vtkCrossFieldPortMacro(Domain, 1);
  ///@}

  ///@{
  /**
   * Sets the rows x, y, quarter index, radius. SetSingularity appends rows as needed. The quarter
   * index is a double here so that ParaView can edit a row as one property. Default: four rows k =
   * +1 of radius 0.1 at distance 0.6 from the origin on the diagonals, the first figure of the
   * paper; Start or Domain replace them as long as they are not changed.
   */
  void SetSingularity(int row, double x, double y, double quarterIndex, double radius);
  void SetNumberOfSingularities(int count);
  int GetNumberOfSingularities() const;
  ///@}

  /** Appends a row. */
  void AddSingularity(double x, double y, double quarterIndex, double radius);

  /** Removes all rows, so that the points of Start are used. */
  void RemoveAllSingularities();

  ///@{
  /** Sets the .csv file to read instead of the rows. Default: empty, the rows are used. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** Sets the name of the file; overload for ParaView. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  ///@{
  /** Uses the handles as positions of the rows. Default: off. */
  vtkSetMacro(UseHandles, bool);
  vtkGetMacro(UseHandles, bool);
  vtkBooleanMacro(UseHandles, bool);
  ///@}

  ///@{
  /** Sets the handles, points in space. Default: the positions of the default rows. */
  void SetHandle(int handle, double x, double y, double z);
  void SetNumberOfHandles(int count);
  int GetNumberOfHandles() const;
  ///@}

  /**
   * Returns the rows of the last update, four components each, whatever their source. A radius of 0
   * means not given.
   */
  vtkDoubleArray* GetOutputRows();

  /**
   * Returns the plane of the rows of the last update as three tuples: origin, first axis and second
   * axis.
   */
  vtkDoubleArray* GetPlane();

protected:
  vtkSingularitySource();
  ~vtkSingularitySource() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSingularitySource(const vtkSingularitySource&) = delete;
  void operator=(const vtkSingularitySource&) = delete;

  std::vector<std::array<double, 4>> Rows;
  std::string FileName;
  bool UseHandles = false;
  std::vector<std::array<double, 3>> Handles;
  vtkNew<vtkDoubleArray> OutputRows;
  vtkNew<vtkDoubleArray> Plane;
};

#endif
