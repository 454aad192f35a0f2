/**
 * Default display of a text that a filter writes for the view: black or white, in contrast to the
 * background, and red while its field data `Alarm` is 1.
 */

#ifndef TextLook_h
#define TextLook_h

class pqDataRepresentation;
class pqPipelineSource;

namespace TextLook
{
/**
 * Applies the display; `location` is ParaView's name, for example "Lower Center". If another text
 * is there, a free place is taken. Has no effect in a spreadsheet.
 */
void Show(
  pqPipelineSource* source, pqDataRepresentation* representation, int port, const char* location);
}

#endif
