#include "FilterChecks.h"

#include "ResultFiles.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIndent.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace
{
/** Fails the running test for every message that VTK would print. */
class StrictOutputWindow : public vtkOutputWindow
{
public:
  static StrictOutputWindow* New();
  vtkTypeMacro(StrictOutputWindow, vtkOutputWindow);

  void DisplayText(const char* text) override { ADD_FAILURE() << "VTK printed: " << text; }
  void DisplayErrorText(const char* text) override { this->DisplayText(text); }
  void DisplayWarningText(const char* text) override { this->DisplayText(text); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayText(text); }
};
vtkStandardNewMacro(StrictOutputWindow);

class StrictOutput : public testing::Environment
{
public:
  void SetUp() override
  {
    vtkNew<StrictOutputWindow> window;
    vtkOutputWindow::SetInstance(window);
  }
};
const testing::Environment* const strictOutput =
  testing::AddGlobalTestEnvironment(new StrictOutput);

/**
 * Returns the sentence of a message in VTK's format "ERROR: In FILE, line N\nvtkClass (0x…):
 * sentence\n\n".
 */
std::string Sentence(std::string text)
{
  const auto begin = text.find("): ");
  text = begin == std::string::npos ? text : text.substr(begin + 3);
  text.erase(text.find_last_not_of(" \n") + 1);
  return text;
}

void StoreMessage(vtkObject*, unsigned long, void* list, void* text)
{
  static_cast<std::vector<std::string>*>(list)->push_back(Sentence(static_cast<const char*>(text)));
}

void IgnoreMessage(vtkObject*, unsigned long, void*, void*) {}

template <class Value>
void Append(std::string& bytes, const Value& value)
{
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
}

void AppendArray(std::string& bytes, vtkAbstractArray* array)
{
  bytes += array->GetName() != nullptr ? array->GetName() : "";
  bytes += array->GetClassName();
  Append(bytes, array->GetNumberOfComponents());
  Append(bytes, array->GetNumberOfTuples());
  if (vtkDataArray::SafeDownCast(array) != nullptr)
  {
    bytes.append(static_cast<const char*>(array->GetVoidPointer(0)),
      static_cast<std::size_t>(array->GetNumberOfValues() * array->GetDataTypeSize()));
    return;
  }
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
  {
    bytes += array->GetVariantValue(i).ToString() + "\n";
  }
}

void AppendArrays(std::string& bytes, vtkFieldData* data)
{
  Append(bytes, data->GetNumberOfArrays());
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    AppendArray(bytes, data->GetAbstractArray(i));
  }
}

bool HasNoValues(vtkFieldData* data)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetAbstractArray(i)->GetNumberOfTuples() > 0)
    {
      return false;
    }
  }
  return true;
}

/** Records the progress of a run, and aborts it at the given event. */
class ProgressWatch
{
public:
  static constexpr int Never = -1;

  ProgressWatch(vtkAlgorithm* filter, int abortAt)
    : Filter(filter)
    , AbortAt(abortAt)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { static_cast<ProgressWatch*>(self)->OnProgress(); });
    this->Tag = filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
  ~ProgressWatch() { this->Filter->RemoveObserver(this->Tag); }
  ProgressWatch(const ProgressWatch&) = delete;
  ProgressWatch& operator=(const ProgressWatch&) = delete;

  std::vector<double> fractions;

private:
  void OnProgress()
  {
    if (static_cast<int>(this->fractions.size()) == this->AbortAt)
    {
      this->Filter->SetAbortExecute(1);
    }
    this->fractions.push_back(this->Filter->GetProgress());
  }

  vtkAlgorithm* Filter;
  int AbortAt;
  unsigned long Tag = 0;
};
}

namespace FilterChecks
{
//------------------------------------------------------------------------------
MessageRecorder::MessageRecorder(vtkAlgorithm* algorithm)
{
  const auto observe = [this](vtkObject* object, unsigned long event,
                         void (*callback)(vtkObject*, unsigned long, void*, void*), void* list)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(callback);
    command->SetClientData(list);
    this->Observations.push_back({ object, object->AddObserver(event, command) });
  };
  observe(algorithm, vtkCommand::ErrorEvent, StoreMessage, &this->errors);
  observe(algorithm, vtkCommand::WarningEvent, StoreMessage, &this->warnings);
  // The executive reports the failure of the algorithm a second time.
  observe(algorithm->GetExecutive(), vtkCommand::ErrorEvent, IgnoreMessage, nullptr);
}

//------------------------------------------------------------------------------
MessageRecorder::~MessageRecorder()
{
  for (const Observation& observation : this->Observations)
  {
    observation.object->RemoveObserver(observation.tag);
  }
}

//------------------------------------------------------------------------------
std::string Fingerprint(vtkDataObject* data)
{
  std::string bytes = data->GetClassName();
  auto* set = vtkDataSet::SafeDownCast(data);
  auto* pointSet = vtkPointSet::SafeDownCast(data);
  if (pointSet != nullptr && pointSet->GetPoints() != nullptr)
  {
    AppendArray(bytes, pointSet->GetPoints()->GetData());
  }
  if (set != nullptr)
  {
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < set->GetNumberOfCells(); ++cell)
    {
      Append(bytes, set->GetCellType(cell));
      set->GetCellPoints(cell, ids);
      for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
      {
        Append(bytes, ids->GetId(i));
      }
    }
    AppendArrays(bytes, set->GetPointData());
    AppendArrays(bytes, set->GetCellData());
  }
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    AppendArrays(bytes, table->GetRowData());
  }
  AppendArrays(bytes, data->GetFieldData());
  return bytes;
}

//------------------------------------------------------------------------------
vtkDataSet* Output(vtkAlgorithm* filter)
{
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}

//------------------------------------------------------------------------------
vtkDataArray* RequireArray(vtkFieldData* data, const char* name)
{
  vtkDataArray* array = data->GetArray(name);
  if (array == nullptr)
  {
    throw std::runtime_error(std::string("there is no array ") + name);
  }
  return array;
}

//------------------------------------------------------------------------------
bool IsEmpty(vtkDataObject* data)
{
  if (auto* table = vtkTable::SafeDownCast(data))
  {
    return table->GetNumberOfRows() == 0;
  }
  auto* set = vtkDataSet::SafeDownCast(data);
  return set != nullptr && set->GetNumberOfPoints() == 0 && set->GetNumberOfCells() == 0 &&
    HasNoValues(set->GetPointData()) && HasNoValues(set->GetCellData());
}

//------------------------------------------------------------------------------
void UpdateWithoutError(vtkAlgorithm* filter)
{
  MessageRecorder messages(filter);
  filter->Update();
  EXPECT_TRUE(messages.errors.empty()) << messages.errors.front();
  EXPECT_TRUE(messages.warnings.empty()) << messages.warnings.front();
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_FALSE(IsEmpty(filter->GetOutputDataObject(0)));
  ResultFiles::Save(filter);
}

//------------------------------------------------------------------------------
void CheckInputUntouched(vtkAlgorithm* filter)
{
  // Optional ports may have no input.
  const auto fingerprint = [filter](int port)
  {
    return filter->GetNumberOfInputConnections(port) == 0
      ? std::string()
      : Fingerprint(filter->GetInputDataObject(port, 0));
  };
  std::vector<std::string> before;
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    before.push_back(fingerprint(port));
  }
  ASSERT_FALSE(before.empty()) << "a source has no input";
  filter->Modified();
  UpdateWithoutError(filter);
  for (int port = 0; port < filter->GetNumberOfInputPorts(); ++port)
  {
    EXPECT_TRUE(fingerprint(port) == before[static_cast<std::size_t>(port)])
      << filter->GetClassName() << " changed the input of port " << port;
  }
}

//------------------------------------------------------------------------------
void CheckRunTwice(
  vtkAlgorithm* filter, const std::function<void()>& setA, const std::function<void()>& setB)
{
  std::vector<std::string> outputs;
  for (const auto& set : { setA, setB, setA })
  {
    set();
    filter->Modified();
    UpdateWithoutError(filter);
    outputs.push_back(Fingerprint(filter->GetOutputDataObject(0)));
  }
  EXPECT_FALSE(outputs[0] == outputs[1]) << "both inputs give the same output";
  EXPECT_TRUE(outputs[0] == outputs[2]) << filter->GetClassName() << " depends on an earlier run";
}

//------------------------------------------------------------------------------
void CheckEmptyInput(vtkAlgorithm* filter)
{
  UpdateWithoutError(filter);
  const auto empty = vtk::TakeSmartPointer(filter->GetInputDataObject(0, 0)->NewInstance());
  filter->SetInputDataObject(0, empty);
  MessageRecorder messages(filter);
  EXPECT_EQ(filter->GetExecutive()->Update(), 1);
  EXPECT_TRUE(messages.errors.empty()) << messages.errors.front();
  EXPECT_TRUE(messages.warnings.empty()) << messages.warnings.front();
  EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(0)));
}

//------------------------------------------------------------------------------
void CheckProgressAndAbort(vtkAlgorithm* filter, bool reportsInBetween)
{
  std::vector<double> fractions;
  std::string full;
  {
    ProgressWatch watch(filter, ProgressWatch::Never);
    filter->Modified();
    UpdateWithoutError(filter);
    fractions = watch.fractions;
    full = Fingerprint(filter->GetOutputDataObject(0));
  }
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_EQ(fractions.back(), 1.0);
  const auto inBetween = std::count_if(fractions.begin(), fractions.end(),
    [](double fraction) { return fraction > 0.0 && fraction < 1.0; });
  EXPECT_TRUE(inBetween > 0 || !reportsInBetween);

  // Aborts at about fifty events at most, since every abort costs a partial run.
  const int reports = static_cast<int>(fractions.size()) - 1;
  const int step = 1 + reports / 50;
  for (int i = (reports - 1) % step; i < reports; i += step)
  {
    MessageRecorder messages(filter);
    ProgressWatch watch(filter, i);
    filter->SetAbortExecute(0); // since VTK 9.2 the flag is not reset by a run
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(messages.errors.empty()) << messages.errors.front();
    EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::NoError);
    EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(0)))
      << filter->GetClassName() << " has an output after an abort at progress event " << i << ", "
      << fractions[static_cast<std::size_t>(i)];
  }
  filter->SetAbortExecute(0);
  filter->Modified();
  UpdateWithoutError(filter);
  EXPECT_TRUE(Fingerprint(filter->GetOutputDataObject(0)) == full)
    << "an aborted run changes the next one";
}

//------------------------------------------------------------------------------
unsigned long CaptureError(vtkAlgorithm* filter, const std::vector<std::string>& parts)
{
  MessageRecorder messages(filter);
  filter->Modified();
  // vtkPoincareHopfCheck returns 1 after a failure, so that a view shows its text.
  EXPECT_EQ(filter->GetExecutive()->Update(), filter->IsA("vtkPoincareHopfCheck") ? 1 : 0);
  EXPECT_EQ(messages.errors.size(), 1u);
  const std::string sentence = messages.errors.empty() ? "" : messages.errors.front();
  for (const std::string& part : parts)
  {
    EXPECT_NE(sentence.find(part), std::string::npos)
      << "'" << sentence << "' does not contain '" << part << "'";
  }
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  EXPECT_TRUE(!sentence.empty() && sentence.back() == '.') << sentence;
  EXPECT_NE(filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(0)));
  return filter->GetErrorCode();
}

//------------------------------------------------------------------------------
std::pair<std::string, bool> TextForView(vtkAlgorithm* filter, int port, const char* name)
{
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
  auto* column = vtkStringArray::SafeDownCast(table->GetColumnByName(name));
  EXPECT_EQ(table->GetNumberOfColumns(), 1);
  std::string text =
    column == nullptr || column->GetNumberOfValues() != 1 ? "" : column->GetValue(0);
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + 1)
  {
    end = text.find('\n', begin);
    EXPECT_LE(std::min(end, text.size()) - begin, 60U) << text;
    if (end != std::string::npos)
    {
      text[end] = ' ';
    }
  }
  return { text, RequireArray(table->GetFieldData(), "Alarm")->GetTuple1(0) != 0.0 };
}

//------------------------------------------------------------------------------
void CheckPrintSelf(vtkObject* object, const std::vector<std::string>& parameters)
{
  std::ostringstream text;
  object->Print(text);
  for (const std::string& parameter : parameters)
  {
    EXPECT_NE(text.str().find(parameter + ": "), std::string::npos)
      << object->GetClassName() << " does not print " << parameter;
  }
}
}
