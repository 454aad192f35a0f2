/**
 * vtkCrossFieldPortMacro(Name, port) defines SetNameConnection and SetNameData, which connect an input
 * port beyond the first and set it to a data object.
 */

#ifndef vtkCrossFieldPortMacro_h
#define vtkCrossFieldPortMacro_h

#define vtkCrossFieldPortMacro(name, port) \
  void Set##name##Connection(vtkAlgorithmOutput* output) \
  { \
    this->SetInputConnection(port, output); \
  } \
  void Set##name##Data(vtkDataObject* data) \
  { \
    this->SetInputData(port, data); \
  }

#endif
