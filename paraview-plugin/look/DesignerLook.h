/**
 * Default display of a Layout Designer: patches in pale colours, quads as thin lines, separatrices
 * as thick lines in the colours of the handles, grey if the layout is stale, singularities as
 * spheres, and no legends, as in states/design.py.
 */

#ifndef DesignerLook_h
#define DesignerLook_h

class pqDataRepresentation;
class pqPipelineSource;

namespace DesignerLook
{
/** Applies the display to an output that has data and is not a text (TextLook.h). */
void Show(pqPipelineSource* source, pqDataRepresentation* representation, int port);
}

#endif
