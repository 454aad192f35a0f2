#ifndef CgnsFile_h
#define CgnsFile_h

#include <string>

/** A CGNS file in a temporary folder, open for writing. */
class CgnsFile
{
public:
  CgnsFile();
  ~CgnsFile();
  CgnsFile(const CgnsFile&) = delete;
  CgnsFile& operator=(const CgnsFile&) = delete;

  /** Returns the number of the file in the functions of libcgns. */
  int Number() const { return this->File; }

  /** Throws crossfield::Error with the message of libcgns unless `status` is that of success. */
  static void Require(int status);

  /** Closes the file and returns its bytes. */
  std::string Take();

private:
  std::string Folder;
  std::string Name;
  int File = -1;
};

#endif
