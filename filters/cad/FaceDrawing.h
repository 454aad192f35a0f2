#ifndef FaceDrawing_h
#define FaceDrawing_h

#include "Drawing.h"
#include "ModelFile.h"

/** Returns whether a model has a planar face. */
bool HasPlanarFace(const ModelFile& model);

/** Returns the drawing of the largest planar face of a model; see crossfieldReadCad. */
crossfield::Drawing DrawLargestFace(const ModelFile& model);

#endif
