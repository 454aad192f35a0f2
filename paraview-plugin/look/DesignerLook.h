/**
 * How a Layout Designer is shown at first: faces in pale colours, quads as thin lines, separatrices as thick ones in the colours of
 * the handles, grey where they are stale, singularities as spheres, and no legends: as in states/design.py.
 */

#ifndef DesignerLook_h
#define DesignerLook_h

class pqDataRepresentation;
class pqPipelineSource;

namespace DesignerLook
{
/** Of an output that has data and is no text (TextLook.h). */
void Show(pqPipelineSource* source, pqDataRepresentation* representation, int port);
}

#endif
