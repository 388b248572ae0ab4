#pragma once

#include <string>
#include <vector>

#include "ndframe/io/exodus_pieces.hpp"

namespace ndframe
{

/// What a process writes of one file of a scene of which it has a share. Nodes and elements of a process follow each
/// other in the file.
struct ExodusSlice
{
  std::vector<std::vector<int>> ownNodes;         ///< per body: of the share, in the order of the file
  std::vector<std::vector<std::int64_t>> numbers; ///< per body and node of the share: its number in the file's body
  std::vector<std::int64_t> firstFacets;          ///< per side set: its facets before the process's own
};

/// Begins the file of a scene: everything but what writeSlice adds. What is not said here is as with writeExodus; of
/// `whole`, only sizes count.
void beginSlices(const std::string& path, const std::string& title, const std::vector<ExodusBody>& bodies,
                 const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                 const std::vector<std::string>& infoLines, const ExodusWhole& whole);

/// Adds a process's nodes, elements and facets with their values to the file that one of them has begun. One after the
/// other; `bodies`, `contactSides` and `steps` are the share's.
void writeSlice(const std::string& path, const std::vector<ExodusBody>& bodies,
                const std::vector<ExodusContactSide>& contactSides, const std::vector<ExodusStep>& steps,
                const ExodusWhole& whole, const ExodusSlice& slice);

} // namespace ndframe
