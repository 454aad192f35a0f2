#ifndef DesignModel_h
#define DesignModel_h

#include "DomainPlane.h"
#include "LayoutDesign.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;
class vtkDoubleArray;
class vtkPolyData;

/** Commands that change the singularities of a design. */
enum class DesignCommand
{
  None,
  Propose,
  Optimise,
  Snap,
  AddPair,
  Remove,
  Undo
};

/** Request of one update of vtkLayoutDesigner. */
struct DesignRequest
{
  /// x, y and quarter index of initial singularities, if there are no rows, and a radius or z.
  std::optional<std::vector<std::array<double, 4>>> start;
  crossfield::LayoutOptions options;
  double meshSize = 0.0;
  double quadSize = 0.0;
  int quadCount = 0;
  double snapTolerance = 0.0;
  bool isDragging = false;
  DesignCommand command = DesignCommand::None;
  int rowToRemove = -1;

  /** Returns the edge length of quads. */
  double QuadSizeOn(double area) const
  {
    return this->quadSize > 0.0 ? this->quadSize
                                : std::sqrt(area / static_cast<double>(this->quadCount));
  }
};

/** What layouts are designed on: a domain in a plane or a surface in space. Every function throws crossfield::Error. */
class DesignModel
{
public:
  /** x, y and quarter index, and a radius in a plane or z on a surface. */
  using Row = std::array<double, 4>;
  using Rows = std::vector<Row>;

  DesignModel() = default;
  DesignModel(const DesignModel&) = delete;
  DesignModel& operator=(const DesignModel&) = delete;
  virtual ~DesignModel() = default;

  virtual double Area() const = 0;
  virtual const crossfield::DomainPlane& Plane() const = 0;

  /** Returns whether the fourth number of a row is z. */
  virtual bool HasHeight() const = 0;

  /** Reads singularities. */
  virtual Rows Read(vtkDataSet* singularities) const = 0;

  /** Reads corners with prescribed quarter indices; a null pointer gives none. */
  virtual std::vector<crossfield::CornerChoice> ReadCorners(vtkDataSet* corners) const = 0;

  /** Returns the singularities that are chosen, which are kept. */
  virtual const Rows& Choose(
    const DesignRequest& request, const crossfield::Progress& progress) = 0;

  /** Applies Optimise, Snap or AddPair, and adds a sentence for each result. */
  virtual Rows Change(const DesignRequest& request, const Rows& rows,
    std::vector<std::string>& events, const crossfield::Progress& progress) = 0;

  virtual crossfield::LayoutDesign Design(
    const DesignRequest& request, const Rows& rows, const crossfield::Progress& progress) = 0;

  /** Returns the sum that the quarter indices of rows must have. */
  virtual int RequiredSum(const DesignRequest& request, const Rows& rows) = 0;

  /** Returns where the nodes of the singularities of a design are. */
  virtual Rows NodesOf(const crossfield::LayoutDesign& design) const = 0;

  /** Writes singularities. */
  virtual void WriteSingularities(const Rows& rows, vtkPolyData* output) const = 0;

  /** Writes the triangles on which handles are placed, nine numbers each; none in a plane. */
  virtual void WriteTriangles(vtkDoubleArray* output) const = 0;
};

#endif
