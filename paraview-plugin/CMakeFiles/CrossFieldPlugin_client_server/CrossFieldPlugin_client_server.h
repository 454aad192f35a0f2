#ifndef CrossFieldPlugin_client_server_h
#define CrossFieldPlugin_client_server_h

#include "vtkClientServerInterpreter.h"

extern "C" void vtkCrossFieldFiltersCS_Initialize(vtkClientServerInterpreter*);

inline void CrossFieldPlugin_client_server_initialize(vtkClientServerInterpreter* csi)
{
  (void)csi;
  vtkCrossFieldFiltersCS_Initialize(csi);
}

#endif
