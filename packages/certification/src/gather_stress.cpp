#include "ndframe/certification/certificate.hpp"
#include "ndframe/recovery/scene_pieces.hpp"

namespace ndframe
{

void Certificate::gatherStress(const Comm& comm)
{
  if (pieces)
    gatherPieces(*pieces, corrections, comm);
  pieces.reset();
}

void Certificate::forgetStress()
{
  corrections = {};
  pieces.reset();
}

} // namespace ndframe
