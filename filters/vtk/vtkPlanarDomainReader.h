/**
 * @class   vtkPlanarDomainReader
 * @brief   read the boundary loops of a planar domain from a table or an aerofoil file
 *
 * Output port 0 (vtkPolyData): one closed polyline per loop of the file, with its points in their
 * order and without arrays. A last point equal to the first one is kept; the filters count it once.
 *
 * The format depends on the ending of the file name:
 * - .csv: a header, then one row per point with the columns `x`, `y` and optionally `z`, or those
 *   of ParaView's export, `Points:0` etc. Column names are case-insensitive and in any order. Rows
 *   with the same entry in a column `loop` form one loop; without this column all rows do.
 * - .dat: Selig's format of aerofoils, also used for plain loops: optionally a line with a name,
 *   then x and y of one point per line. Two empty lines or a line `999 999` start another loop.
 * A file with another ending is a table if its first line has a comma. Mesh files are read by VTK's
 * own readers.
 *
 * The reader fails, with an empty output, if the file does not exist, has no columns x and y, has
 * an entry that is not a number, or has too few points for a loop, or if an aerofoil is in
 * Lednicer's format.
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
  /** Sets the name of the file. Default: empty, which is an error. */
  vtkSetMacro(FileName, std::string);
  vtkGetMacro(FileName, std::string);
  ///@}
  /** Sets the name of the file; overload for ParaView. */
  void SetFileName(const char* fileName)
  {
    this->SetFileName(std::string(fileName ? fileName : ""));
  }

  ///@{
  /**
   * Reads InputString instead of the file, whose name is then used in messages only. Default: off.
   */
  vtkSetMacro(ReadFromInputString, bool);
  vtkGetMacro(ReadFromInputString, bool);
  vtkBooleanMacro(ReadFromInputString, bool);
  ///@}

  ///@{
  /** Sets the text to read instead of a file. Default: empty. */
  vtkSetMacro(InputString, std::string);
  vtkGetMacro(InputString, std::string);
  ///@}

  /**
   * Returns 1 if the first two lines of a file look like a supported format, else 0. Called by
   * ParaView.
   */
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
