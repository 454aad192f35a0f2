#ifndef OwnLibrary_h
#define OwnLibrary_h

/** Libraries of this project that are loaded when they are needed. */
namespace OwnLibrary
{
/** Returns a function of a library that is installed next to this one, null if there is no such library. */
void* Find(const char* library, const char* function);
}

#endif
