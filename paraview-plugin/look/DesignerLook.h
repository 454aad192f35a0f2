/**
 * How a Layout Designer is shown at first: faces in pale colours, quads as thin lines, separatrices as thick ones in the colours of
 * the handles, grey where they are stale, singularities as spheres, the summary as a text below, and no legends: as in states/design.py.
 */

#ifndef DesignerLook_h
#define DesignerLook_h

class pqDataRepresentation;
class pqPipelineSource;

namespace DesignerLook
{
/** Of the output that is a text, not a thing in the plane. */
bool IsText(int port);

/** Of an output that has data; a text may have none. */
void Show(pqPipelineSource* source, pqDataRepresentation* representation, int port);
}

#endif
