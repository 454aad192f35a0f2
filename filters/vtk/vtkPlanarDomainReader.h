/**
 * @class   vtkPlanarDomainReader
 * @brief   boundary loops of a planar domain from a table or an aerofoil
 *
 * Output (vtkPolyData): one closed polyline per loop of the file, its points in their order, no arrays.
 * A last point that is the first one again is kept; the filters count it once.
 *
 * | ending | file |
 * | --- | --- |
 * | .csv | a header, then a row for each point: columns `x`, `y` and maybe `z`, or those of ParaView's export, `Points:0` and so on, in large or small letters and any order; rows with the same entry in a column `loop` are one loop, without it all of them are |
 * | .dat | Selig's format of aerofoils, which plain loops have as well: maybe a line with a name, then x and y of a point in each line; two empty lines or a line `999 999` begin another loop |
 *
 * Other files are tables if their first line has a comma. Files of meshes have VTK's own readers.
 *
 * Failure: a file that is missing, names no columns x and y, holds something that is no number or too
 * few points for a loop; an aerofoil in Lednicer's format. The output is then empty.
 *
 * @sa vtkPlanarDomainSource, vtkDrillHoles
 */

#ifndef vtkPlanarDomainReader_h
#define vtkPlanarDomainReader_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for FileName

class VTKCROSSFIELDFILTERS_EXPORT vtkPlanarDomainReader : public vtkPolyDataAlgorithm
{
public:
  static vtkPlanarDomainReader* New();
  vtkTypeMacro(vtkPlanarDomainReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file. Default: empty, which is refused. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** As above; what ParaView calls. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  ///@{
  /** Whether InputString is read instead of the file, whose name is then said in messages. Default: off. */
  vtkSetMacro(ReadFromInputString, bool);
  vtkGetMacro(ReadFromInputString, bool);
  vtkBooleanMacro(ReadFromInputString, bool);
  ///@}

  ///@{
  /** The text of a file. Default: empty. */
  vtkSetMacro(InputString, std::string);
  vtkGetMacro(InputString, std::string);
  ///@}

  /** 1 if the first two lines of a file look like those of one that is read here, else 0; for ParaView. */
  static int CanReadFile(const char* fileName);

protected:
  vtkPlanarDomainReader();
  ~vtkPlanarDomainReader() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPlanarDomainReader(const vtkPlanarDomainReader&) = delete;
  void operator=(const vtkPlanarDomainReader&) = delete;

  std::string FileName;
  bool ReadFromInputString = false;
  std::string InputString;
};

#endif
