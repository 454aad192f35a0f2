#ifndef FilterChecks_h
#define FilterChecks_h

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkFieldData;
class vtkObject;

/**
 * What every filter of the module promises, as checks that the tests of the classes share. Besides,
 * linking this file makes any error or warning that VTK prints during a test a failure of that
 * test: expected ones are recorded, not printed.
 */
namespace FilterChecks
{
/** Records the errors and warnings of an algorithm, instead of printing them, while it lives. */
class MessageRecorder
{
public:
  explicit MessageRecorder(vtkAlgorithm* algorithm);
  ~MessageRecorder();
  MessageRecorder(const MessageRecorder&) = delete;
  MessageRecorder& operator=(const MessageRecorder&) = delete;

  std::vector<std::string> errors;   ///< Of the algorithm itself, the sentences only.
  std::vector<std::string> warnings; ///< Likewise.

private:
  struct Observation
  {
    vtkSmartPointer<vtkObject> object;
    unsigned long tag;
  };
  std::vector<Observation> Observations;
};

/** Points, cells and every array of a data set or table, bit for bit, with types and names. */
std::string Fingerprint(vtkDataObject* data);

/** The data set that the algorithm gives on port 0. */
vtkDataSet* Output(vtkAlgorithm* filter);

/** The array of that name; throws, which ends the test, if there is none. */
vtkDataArray* RequireArray(vtkFieldData* data, const char* name);

/** Whether a data set has no points, no cells and no values in point and cell arrays; or a table no rows. */
bool IsEmpty(vtkDataObject* data);

/** Updates the filter and expects no message, no error code and some output. */
void UpdateWithoutError(vtkAlgorithm* filter);

/** A run leaves the data on all input ports as they were. */
void CheckInputUntouched(vtkAlgorithm* filter);

/**
 * Sets A, B and A again, which must give different outputs, and expects the third output to be the
 * first one bit for bit: nothing of a run stays in the filter.
 */
void CheckRunTwice(
  vtkAlgorithm* filter, const std::function<void()>& setA, const std::function<void()>& setB);

/** Replaces the input of port 0 by an empty one of its class; the output is empty, no error. */
void CheckEmptyInput(vtkAlgorithm* filter);

/**
 * Progress never falls, reaches 1, and is reported on the way if `reportsOnTheWay`. A run that is
 * aborted at any progress event before the last gives an empty output and no error, and does not
 * spoil the next run.
 */
void CheckProgressAndAbort(vtkAlgorithm* filter, bool reportsOnTheWay = true);

/**
 * Updates the filter and expects that it reports one error: a single sentence with all the parts,
 * an error code and an empty output. Returns the error code.
 */
unsigned long CaptureError(vtkAlgorithm* filter, const std::vector<std::string>& parts);

/** The text in the only column of a table for a view, with its lines made one, and whether it is an alarm; no line is long. */
std::pair<std::string, bool> TextForView(vtkAlgorithm* filter, int port, const char* name);

/** PrintSelf names every one of the parameters. */
void CheckPrintSelf(vtkObject* object, const std::vector<std::string>& parameters);
}

#endif
