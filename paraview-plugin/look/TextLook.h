/**
 * Default display of a text that a filter writes for the view: black or white, in contrast to the
 * background, and red on white while its field data `Alarm` is 1, which is readable on any background.
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

/** Returns whether a source has a text in a visible view that reports a problem: `Alarm` is 1. */
bool ReportsProblem(const pqPipelineSource* source);
}

#endif
