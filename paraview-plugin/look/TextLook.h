/**
 * How a text is shown at first that a filter writes for the view: in black or white, whichever is seen on the background, and in red
 * as long as its field data `Alarm` is 1.
 */

#ifndef TextLook_h
#define TextLook_h

class pqDataRepresentation;
class pqPipelineSource;

namespace TextLook
{
/** `location`: as ParaView calls it, "Lower Center" for example. A spreadsheet or the like stays as it is. */
void Show(pqPipelineSource* source, pqDataRepresentation* representation, int port,
  const char* location);
}

#endif
