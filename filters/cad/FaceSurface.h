#ifndef FaceSurface_h
#define FaceSurface_h

#include "Drawing.h"
#include "ModelFile.h"

/** Returns all faces of a model as triangles; see crossfieldReadCad. */
crossfield::Drawing TriangulateFaces(const ModelFile& model, double angle);

#endif
