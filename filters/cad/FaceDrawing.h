#ifndef FaceDrawing_h
#define FaceDrawing_h

#include "Drawing.h"
#include "ModelFile.h"

/** Returns the drawing of the largest planar face of a model; see crossfieldReadCad. */
crossfield::Drawing DrawLargestFace(const ModelFile& model);

#endif
