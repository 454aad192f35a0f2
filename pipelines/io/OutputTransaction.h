#ifndef OutputTransaction_h
#define OutputTransaction_h

#include <string>
#include <vector>

/**
 * All files that a command writes, or none of them: each is written beside its place, as
 * NAME.part<pid>, and Commit renames them when all are complete. Without a Commit, and when SIGINT,
 * SIGTERM or SIGHUP end the program, what was written beside is removed again. When a rename fails,
 * those before it are undone. After a power cut or SIGKILL files of either kind may be left over.
 *
 * A link is followed. What is not a regular file, like /dev/null or a named pipe, cannot be renamed
 * over: it and standard output are written by Commit, before the renames.
 */
class OutputTransaction
{
public:
  OutputTransaction();
  ~OutputTransaction();
  OutputTransaction(const OutputTransaction&) = delete;
  OutputTransaction& operator=(const OutputTransaction&) = delete;

  /** Writes a text beside its place; "-" is standard output. Throws PipelineRun::Error. */
  void Write(const std::string& text, const std::string& file);

  /** Whether data go to standard output, which then takes no text. */
  bool PrintsData() const { return !this->Streams.empty(); }

  /** Makes a folder and those above it, where they are missing. */
  void MakeFolder(const std::string& folder);

  /** Puts everything into place; throws PipelineRun::Error, and has then changed nothing. */
  void Commit();

private:
  struct File
  {
    std::string name;   ///< As the user wrote it.
    std::string place;  ///< Where it goes: links are followed.
    std::string part;   ///< Where it is until then.
    std::string before; ///< Another name of what was there, to undo the rename.
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
  std::vector<std::string> Folders; ///< Made here, the outer ones first.
};

#endif
