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

/** What a person asks of a design. */
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

/** What is asked of one update of vtkLayoutDesigner. */
struct DesignRequest
{
  std::optional<crossfield::Configuration> start; ///< Counts where no rows are given.
  crossfield::LayoutOptions options;
  double meshSize = 0.0;
  double quadSize = 0.0;
  double snapTolerance = 0.0;
  DesignCommand command = DesignCommand::None;
  int rowToRemove = -1;
};

/** What a vtkLayoutDesigner keeps between updates; every function throws crossfield::Error. */
class DesignSession
{
public:
  using Row = std::array<double, 4>; ///< x, y, quarter index, radius.

  static crossfield::Configuration FromRows(const std::vector<Row>& rows);
  static std::vector<Row> ToRows(const crossfield::Configuration& configuration);

  /** Reads the domain, and forgets what was of another one. */
  const DomainConversion::Domain& Read(vtkDataSet* data);
  /** The domain that was read last. */
  CachedDomain& GetDomain() { return this->Domain; }

  /** The singularities before the command, and the corners that belong to them in the question's options. */
  crossfield::Configuration Start(
    DesignRequest& question, const std::vector<Row>& given, const crossfield::Progress& progress);

  /** Obeys the command: changes the singularities, and the rows to these. */
  void Apply(const DesignRequest& question, crossfield::Configuration& now, std::vector<Row>& given,
    const crossfield::Progress& progress);

  std::optional<crossfield::LayoutDesign> design; ///< The last one that could be.
  std::vector<std::string> events; ///< Of the command of this update, a sentence each.

private:
  const crossfield::Configuration& Choose(
    const DesignRequest& question, const crossfield::Progress& progress);
  void Apply(const DesignRequest& question, crossfield::Configuration& now,
    const crossfield::Progress& progress);

  CachedDomain Domain;
  int Version = 0; ///< Of the domain that the rest is of.
  std::optional<crossfield::AutomaticConfiguration> Chosen;
  std::vector<std::vector<Row>> Before; ///< Of the commands, the last one last.
};

#endif
