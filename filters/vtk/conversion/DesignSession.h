#ifndef DesignSession_h
#define DesignSession_h

#include "AutomaticConfiguration.h"
#include "CachedDomain.h"
#include "LayoutDesign.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkDataSet;

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
  std::optional<crossfield::Configuration> start; ///< Initial singularities if there are no rows.
  crossfield::LayoutOptions options;
  double meshSize = 0.0;
  double quadSize = 0.0;
  double snapTolerance = 0.0;
  DesignCommand command = DesignCommand::None;
  int rowToRemove = -1;
};

/** Result of one update. */
struct DesignUpdate
{
  crossfield::Configuration singularities;
  std::string refusal; ///< Why the singularities have no layout; empty if they have one.
};

/** State that a vtkLayoutDesigner keeps between updates. */
class DesignSession
{
public:
  using Row = std::array<double, 4>; ///< x, y, quarter index, radius.

  /** Converts singularities to rows. */
  static std::vector<Row> ToRows(const crossfield::Configuration& configuration);

  /**
   * Reads the domain and returns it. If the domain has changed, discards the results for the
   * earlier one. Throws crossfield::Error like DomainConversion::ReadDomain.
   */
  const DomainConversion::Domain& Read(vtkDataSet* data);

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
  static crossfield::Configuration FromRows(const std::vector<Row>& rows);
  const crossfield::Configuration& Choose(
    const DesignRequest& request, const crossfield::Progress& progress);
  crossfield::Configuration Prepare(
    DesignRequest& request, const std::vector<Row>& rows, const crossfield::Progress& progress);
  void Apply(const DesignRequest& request, crossfield::Configuration& singularities,
    std::vector<Row>& rows, const crossfield::Progress& progress);
  void ApplyCommand(const DesignRequest& request, crossfield::Configuration& singularities,
    const crossfield::Progress& progress);

  CachedDomain Domain;
  int Version = 0; ///< Version of the domain that the other members belong to.
  std::optional<crossfield::AutomaticConfiguration> Chosen;
  std::optional<crossfield::LayoutDesign> Design;
  std::vector<std::string> Events;
  std::vector<std::vector<Row>> UndoStack; ///< Rows before each command.
};

#endif
