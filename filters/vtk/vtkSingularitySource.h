/**
 * @class   vtkSingularitySource
 * @brief   a configuration of singularities as points, from rows, a .csv file or other points
 *
 * A singularity is a point with a quarter index k: the representation e^{4iθ} of the cross field
 * turns k times around it and its index is k/4. k = +1 becomes a node of valence 3 of the quad
 * mesh, k = −1 one of valence 5.
 *
 * Input port 0, Start, may be left out: points with the point array `QuarterIndex` and maybe `Radius`.
 * Input port 1, Domain, may be left out: a domain (vtkPolyData or vtkUnstructuredGrid) in whose plane the rows are.
 *
 * The rows are coordinates of a plane in space, those that the filters use (crossfield::DomainPlane): x and y where z is constant.
 * The plane is that of Domain, else the one that Start has as field data `Plane` and is in, else z = const through the first point of Start,
 * else z = 0. What a file, Start or a handle has are points of space.
 *
 * Output (vtkPolyData): one vertex per row, with field data `Plane` (double, 3 tuples: origin and axes) where it is not z = const, and the point arrays
 * - `QuarterIndex` (int, 1 component): k;
 * - `Radius` (double, 1 component): radius of the hole that will be drilled; absent when a file or Start
 *   has no such column, or when it is 0 in every row, which stands for radii that are not given.
 *
 * The rows are those of the file, if FileName is set; else those set here; as long as none were set, the points of Start. A file is comma-separated with the header
 * `x,y,quarter_index` and optionally `radius` and `z`, in any order. Domains in a plane z = const
 * make no use of z; for those in another plane the points of a file have to lie in it.
 *
 * With UseHandles on, handle i takes the place of row i: these are the points that ParaView lets one
 * drag in the 3D view. A row without a handle is left out; a handle without a row is a singularity
 * of quarter index 1 with the radius of the last row (0.1 without rows).
 *
 * Failure: a file that is missing, lacks a column or has an entry that is not a finite number; a
 * quarter index that is not an integer; a Start without `QuarterIndex`. The output is then empty.
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
  /** Where to start from: connects or sets the optional input port 0. */
  vtkCrossFieldPortMacro(Start, 0);
  ///@}

  ///@{
  /** In whose plane the rows are: connects or sets the optional input port 1. */
  vtkCrossFieldPortMacro(Domain, 1);
  ///@}

  ///@{
  /**
   * The rows x, y, quarter index, radius. Default: four k = +1 of radius 0.1 at distance 0.6 from
   * the origin on the diagonals, the first figure of the paper. SetSingularity appends rows as
   * needed; the quarter index is a double here so that ParaView can edit the row as one property.
   */
  void SetSingularity(int row, double x, double y, double quarterIndex, double radius);
  void SetNumberOfSingularities(int count);
  int GetNumberOfSingularities() const;
  ///@}

  /** Appends a row. */
  void AddSingularity(double x, double y, double quarterIndex, double radius);

  /** Leaves no row, so that those of Start count. */
  void RemoveAllSingularities();

  ///@{
  /** A .csv file to read instead of the rows. Default: empty, the rows count. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** As above; what ParaView calls. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  ///@{
  /** Whether the handles say where the rows are. Default: off. */
  vtkSetMacro(UseHandles, bool);
  vtkGetMacro(UseHandles, bool);
  vtkBooleanMacro(UseHandles, bool);
  ///@}

  ///@{
  /** The handles, points of space. Default: the places of the default rows. */
  void SetHandle(int handle, double x, double y, double z);
  void SetNumberOfHandles(int count);
  int GetNumberOfHandles() const;
  ///@}

  /** The rows of the last update, four components each, wherever they are from; radius 0: not given. */
  vtkDoubleArray* GetOutputRows();

  /** The plane of the rows of the last update, as three tuples: origin, first and second axis. */
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
  bool RowsAreDefault = true;
  std::string FileName;
  bool UseHandles = false;
  std::vector<std::array<double, 3>> Handles;
  vtkNew<vtkDoubleArray> OutputRows;
  vtkNew<vtkDoubleArray> Plane;
};

#endif
