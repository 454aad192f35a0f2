#ifndef OutputTransaction_h
#define OutputTransaction_h

#include <string>
#include <vector>

/**
 * Writes all files of a command, or none of them. Each is first written to NAME.part<pid> in the
 * same folder, and Commit renames them when all are complete. Without a Commit, and if SIGINT,
 * SIGTERM or SIGHUP end the program, these parts are removed. If a rename fails, the earlier ones
 * are undone. After a power cut or SIGKILL, parts and second names of old files may remain.
 *
 * Links are followed. A target that is not a regular file, like /dev/null or a named pipe, cannot
 * be replaced by a rename: Commit writes to it and to standard output before the renames.
 */
class OutputTransaction
{
public:
  OutputTransaction();
  ~OutputTransaction();
  OutputTransaction(const OutputTransaction&) = delete;
  OutputTransaction& operator=(const OutputTransaction&) = delete;

  /** Writes a text to its temporary file; "-" is standard output. Throws PipelineRun::Error. */
  void Write(const std::string& text, const std::string& file);

  /** Returns whether data go to standard output, so that no summary may be printed. */
  bool PrintsData() const { return !this->Streams.empty(); }

  /** Makes a folder and its parents if they are missing. */
  void MakeFolder(const std::string& folder);

  /** Puts all files in place; if it throws PipelineRun::Error, it has changed nothing. */
  void Commit();

private:
  struct File
  {
    std::string name;   ///< Name that the user gave.
    std::string place;  ///< File to write, after links are followed.
    std::string part;   ///< File that is written until Commit.
    std::string before; ///< Second name of the old file, to undo the rename.
    bool placed = false;
  };
  struct Stream
  {
    std::string name;
    std::string text;
  };

  void Print() const;
  void Place(File& file);
  void Undo();
  void RegisterForSignals();

  std::vector<File> Files;
  std::vector<Stream> Streams;
  std::vector<std::string> Folders; ///< Folders that were made, outer ones first.
};

#endif
