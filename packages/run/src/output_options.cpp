#include "ndframe/run/output_options.hpp"

namespace ndframe
{

const Names<StepsWritten>& stepsNames()
{
  static const Names<StepsWritten> names{{"Final", StepsWritten::Final}, {"All Sweeps", StepsWritten::AllSweeps}};
  return names;
}

const Names<ExodusFiles>& exodusFilesNames()
{
  static const Names<ExodusFiles> names{
      {"Automatic", ExodusFiles::Automatic}, {"Single", ExodusFiles::Single}, {"Pieces", ExodusFiles::Pieces}};
  return names;
}

bool writesPieces(ExodusFiles files, std::int64_t nodes, int processes)
{
  return processes > 1 &&
         (files == ExodusFiles::Pieces || (files == ExodusFiles::Automatic && nodes >= leastNodesInPieces));
}

} // namespace ndframe
