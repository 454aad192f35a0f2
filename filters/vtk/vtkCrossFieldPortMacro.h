/**
 * Defines SetNameConnection and SetNameData, which connect an input port other than the first one
 * or set it to a data object. Usage: vtkCrossFieldPortMacro(Name, port).
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
