#ifndef DesignSession_h
#define DesignSession_h

#include "DesignModel.h"

#include "vtkType.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

/** Result of one update. */
struct DesignUpdate
{
  DesignModel::Rows rows;
  std::string refusal;            ///< Why the singularities have no layout; empty if they have one.
  std::optional<int> requiredSum; ///< Sum that the quarter indices must have, if it was found.
  std::vector<std::string> reasons; ///< For each row, why it and its node are where they are.
  bool isSnapped = false;           ///< Whether the rows are those after Snap.
};

/** State that a vtkLayoutDesigner keeps between updates. */
class DesignSession
{
public:
  using Row = DesignModel::Row;

  /**
   * Reads a domain, or a surface whose sharp edges have triangles with normals that differ by more than an angle in
   * degrees. If it has changed, discards the results for the earlier one. Throws crossfield::Error
   * like DomainConversion::ReadDomain and crossfield::DesignSurface.
   */
  const DesignModel& Read(vtkDataSet* data, double featureAngle);

  /**
   * Applies the command of the request and designs the layout of the singularities. A command that
   * changes the singularities replaces the rows. Singularities without a layout are not an error:
   * the last design is then kept, and the refusal gives the reason.
   */
  DesignUpdate Update(
    DesignRequest request, std::vector<Row>& rows, const crossfield::Progress& progress);

  /** Returns the last valid design, or null if there was none. */
  const crossfield::LayoutDesign* GetDesign() const
  {
    return this->Design ? &*this->Design : nullptr;
  }

  /** Returns one sentence for each result of the last command. */
  const std::vector<std::string>& GetEvents() const { return this->Events; }

private:
  DesignModel::Rows Start(const DesignRequest& request, const std::vector<Row>& rows,
    const crossfield::Progress& progress);
  void Apply(const DesignRequest& request, DesignModel::Rows& singularities, std::vector<Row>& rows,
    const crossfield::Progress& progress);
  std::string OriginOf(const DesignRequest& request, bool isTyped) const;
  void ExplainRows(const DesignRequest& request, bool isTyped, const DesignModel::Rows& rows);
  std::vector<std::string> ExplainNodes(
    const DesignRequest& request, const DesignModel::Rows& rows) const;

  vtkDataSet* Data = nullptr; ///< Identity token for change detection; never dereferenced.
  vtkMTimeType Time = 0;
  double FeatureAngle = 0.0;
  std::unique_ptr<DesignModel> Model; ///< Of the data read last; the other members belong to it.
  std::optional<crossfield::LayoutDesign> Design;
  std::vector<std::string> Events;
  std::vector<std::vector<Row>> UndoStack; ///< Rows before each command.
  DesignModel::Rows Explained;             ///< Rows of the last update.
  std::vector<std::string> Origins;        ///< How each of them got its place.
  DesignModel::Rows Snapped;               ///< Rows after the last Snap.
  std::optional<int> RequiredSum;          ///< That was found last.
};

#endif
