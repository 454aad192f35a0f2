#ifndef SingularityInput_h
#define SingularityInput_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>

class OutputTransaction;
class vtkConfigurationProposal;
class vtkDataSet;
class vtkFieldData;
class vtkPointSet;

/**
 * The singularities of a command: those of its option -s or, without it, those that
 * vtkConfigurationProposal chooses for the domain, with the corners that belong to them. (The
 * command quads leaves the choice to vtkQuadMesher.)
 */
class SingularityInput
{
public:
  /** Reads and chooses nothing yet. `file` and `corners` may be empty; `size` is the mesh size. */
  SingularityInput(
    const std::string& file, vtkAlgorithm* domain, double size, const std::string& corners);

  /** Uses the first output of a source. */
  explicit SingularityInput(vtkAlgorithm* source);

  /** Sets whether sharp corners of quarter index 2 get 1 where singularities are chosen. */
  void SetCapCorners(bool cap);

  /** Reads or chooses; throws PipelineRun::Error. */
  void Update();

  bool AreChosen() const { return this->Proposal != nullptr; }
  vtkAlgorithmOutput* GetOutputPort() const { return this->Source->GetOutputPort(); }
  /** Returns the singularities, at the positions set by ApplyRepair. */
  vtkDataSet* GetOutput() const;

  /**
   * Moves the singularities to the field data `RepairedPositions` of a filter, if present; see
   * vtkCrossFieldMap.
   */
  void ApplyRepair(vtkFieldData* field);

  /** Connects the prescribed or chosen corners, if any, to a filter. */
  template <class Filter>
  void ConnectCorners(Filter* filter) const
  {
    if (this->Corners != nullptr)
    {
      filter->SetCornersConnection(this->Corners->GetOutputPort(this->CornerPort));
    }
  }

  /** Prints the distance of a repair, and the events and positions of chosen singularities, if it is verbose. */
  void PrintChoice(bool verbose) const;

  /** Writes the singularities to a .csv file; does nothing if `file` is empty. */
  void Save(const std::string& file, OutputTransaction& outputs) const;

private:
  bool HasHeight() const;

  vtkSmartPointer<vtkConfigurationProposal> Proposal; ///< Null if the singularities are given.
  vtkSmartPointer<vtkAlgorithm> Source;
  vtkSmartPointer<vtkAlgorithm> Corners; ///< Null if there are none.
  int CornerPort = 0;
  vtkSmartPointer<vtkAlgorithm> Domain;
  vtkSmartPointer<vtkPointSet> Repaired;      ///< Null before ApplyRepair.
  vtkSmartPointer<vtkFieldData> RepairReport; ///< Null before ApplyRepair.
};

/**
 * Opens a file of singularities or corners. The points of the domain's boundary at these positions
 * are kept.
 */
vtkSmartPointer<vtkAlgorithm> OpenPointsOf(vtkAlgorithm* domain, const std::string& file);

/** Prints the distance of a holonomy repair if the field data of a filter have one. */
void PrintRepair(vtkFieldData* field);

/** Prints the field data `StretchReason` of a map, if there are any. */
void PrintStretch(vtkFieldData* field);

/** Prints the field data `Events` of chosen singularities, then their positions. */
void PrintChosen(vtkDataSet* singularities, bool hasHeight);

/** Prints one line "quarter index K at X Y" per point, with Z in planes other than z = const. */
void PrintSingularities(vtkDataSet* singularities, bool hasHeight);

#endif
