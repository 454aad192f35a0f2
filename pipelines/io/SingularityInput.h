#ifndef SingularityInput_h
#define SingularityInput_h

#include "vtkAlgorithm.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class OutputTransaction;
class vtkConfigurationProposal;
class vtkDataSet;
class vtkFieldData;
class vtkPointSet;
class vtkQuadMesher;

/**
 * The singularities of a command: those of its option -s or, where that is left out, those that
 * vtkConfigurationProposal chooses for the domain, with the corners that go with them.
 */
class SingularityInput
{
public:
  /** `file` and `corners` may be empty; `size` is that of the mesh. Reads or chooses nothing yet. */
  SingularityInput(
    const std::string& file, vtkAlgorithm* domain, double size, const std::string& corners);

  /** What a source gives. */
  explicit SingularityInput(vtkAlgorithm* source);

  /** Whether sharp corners of quarter index 2 get 1 where singularities are chosen. */
  void SetCapCorners(bool cap);

  /** What singularities are chosen for: quads as they are asked for. */
  void SetQuads(double clearance, vtkQuadMesher* mesher);

  /** Reads or chooses; throws PipelineRun::Error. */
  void Update();

  bool AreChosen() const { return this->Proposal != nullptr; }
  vtkAlgorithmOutput* GetOutputPort() const { return this->Source->GetOutputPort(); }
  /** With the places where TakeRepaired has put them. */
  vtkDataSet* GetOutput() const;

  /** Takes the places that a filter says it has moved them to, if it has; see vtkCrossFieldMap. */
  void TakeRepaired(vtkFieldData* field);

  /** Gives a filter the corners that were named or chosen, if any. */
  template <class Filter>
  void ConnectCorners(Filter* filter) const
  {
    if (this->Corners != nullptr)
    {
      filter->SetCornersConnection(this->Corners->GetOutputPort(this->CornerPort));
    }
  }

  /** What was decided, a sentence each; nothing if the singularities were given. */
  std::vector<std::string> GetEvents() const;

  /** The events, how far singularities were moved, then the places of chosen ones. */
  void PrintChoice() const;

  /** Writes the singularities to a .csv file, if one is named. */
  void Save(const std::string& file, OutputTransaction& outputs) const;

private:
  vtkSmartPointer<vtkConfigurationProposal> Proposal; ///< Null if they are given.
  vtkSmartPointer<vtkAlgorithm> Source;
  vtkSmartPointer<vtkAlgorithm> Corners; ///< Null if there are none.
  int CornerPort = 0;
  vtkSmartPointer<vtkAlgorithm> Domain;
  vtkSmartPointer<vtkPointSet> Repaired; ///< Null where they have not moved.
  double RepairDistance = 0.0;
};

/** One line "quarter index K at X Y" for each of the points, with Z in planes that have one. */
void PrintSingularities(vtkDataSet* singularities, bool hasHeight);

#endif
