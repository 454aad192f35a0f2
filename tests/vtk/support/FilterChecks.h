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
 * Checks of the conventions of every filter, shared by the tests of the classes. Linking this file
 * also makes every error or warning that VTK prints during a test a failure. Expected messages are
 * recorded instead of printed.
 */
namespace FilterChecks
{
/**
 * Records the errors and warnings of an algorithm, instead of printing them, during its lifetime.
 */
class MessageRecorder
{
public:
  explicit MessageRecorder(vtkAlgorithm* algorithm);
  ~MessageRecorder();
  MessageRecorder(const MessageRecorder&) = delete;
  MessageRecorder& operator=(const MessageRecorder&) = delete;

  std::vector<std::string> errors;   ///< Messages of the algorithm itself, without VTK's prefix.
  std::vector<std::string> warnings; ///< Warnings, without VTK's prefix.

private:
  struct Observation
  {
    vtkSmartPointer<vtkObject> object;
    unsigned long tag;
  };
  std::vector<Observation> Observations;
};

/** Returns the points, cells and arrays of a data set or table, with types and names, as bytes. */
std::string Fingerprint(vtkDataObject* data);

/** Returns the data set on output port 0. */
vtkDataSet* Output(vtkAlgorithm* filter);

/** Returns the array of that name. Throws, which ends the test, if there is none. */
vtkDataArray* RequireArray(vtkFieldData* data, const char* name);

/**
 * Returns whether a data set has no points, no cells and no values in point and cell arrays, or a
 * table no rows.
 */
bool IsEmpty(vtkDataObject* data);

/** Updates the filter and expects no message, no error code and a non-empty output. */
void UpdateWithoutError(vtkAlgorithm* filter);

/** Expects that a run does not change the data on any input port. */
void CheckInputUntouched(vtkAlgorithm* filter);

/**
 * Runs the filter with A, B and A again. Expects different outputs of A and B and equal outputs, as
 * bytes, of both runs with A: the filter keeps no state of a run.
 */
void CheckRunTwice(
  vtkAlgorithm* filter, const std::function<void()>& setA, const std::function<void()>& setB);

/**
 * Replaces the input of port 0 by an empty one of its class. Expects an empty output and no error.
 */
void CheckEmptyInput(vtkAlgorithm* filter);

/**
 * Expects that progress never decreases, reaches 1, and is reported in between if
 * `reportsInBetween`. Expects that a run aborted at any progress event before the last has an empty
 * output and no error, and does not affect the next run.
 */
void CheckProgressAndAbort(vtkAlgorithm* filter, bool reportsInBetween = true);

/**
 * Updates the filter and expects one error: a single sentence that contains all the parts, an error
 * code and an empty output. Returns the error code.
 */
unsigned long CaptureError(vtkAlgorithm* filter, const std::vector<std::string>& parts);

/**
 * Returns the text in the only column of a table for a view, with its lines joined, and whether it
 * is an alarm. Expects lines of at most 60 characters.
 */
std::pair<std::string, bool> TextForView(vtkAlgorithm* filter, int port, const char* name);

/** Expects that PrintSelf prints every one of the parameters. */
void CheckPrintSelf(vtkObject* object, const std::vector<std::string>& parameters);
}

#endif
