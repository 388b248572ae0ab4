#include "persistent_remesh.hpp"

#include <array>
#include <optional>

namespace ndframe
{
namespace
{

struct Attempt
{
  GmshAlgorithm algorithm;
  double factor; ///< of the wanted lengths
};

/// Where an algorithm fails, another one or other points on the boundary mostly do not. Every attempt costs a mesh.
constexpr std::array<Attempt, 5> attempts{{{GmshAlgorithm::FrontalDelaunay, 1.0},
                                           {GmshAlgorithm::Delaunay, 1.0},
                                           {GmshAlgorithm::FrontalDelaunay, 0.93},
                                           {GmshAlgorithm::MeshAdapt, 0.93},
                                           {GmshAlgorithm::Delaunay, 0.8}}};

std::vector<WantedMesh> scaled(std::vector<WantedMesh> wanted, double factor)
{
  for (WantedMesh& body : wanted)
    for (double& length : body.lengths)
      length *= factor;
  return wanted;
}

} // namespace

std::vector<Mesh> remeshPersistently(const std::vector<WantedMesh>& wanted, const MeshMaker& make)
{
  std::optional<RemeshFailure> first;
  for (const auto& [algorithm, factor] : attempts) {
    try {
      return factor == 1.0 ? make(wanted, algorithm) : make(scaled(wanted, factor), algorithm);
    } catch (const RemeshFailure& failure) {
      if (!first)
        first = failure;
    }
  }
  throw RemeshFailure(*first);
}

} // namespace ndframe
