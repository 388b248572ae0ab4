// Hands on what two of three bodies in a row lack of balance: all of it passes from one neighbour to the next.
#include <cmath>

#include "ndframe/flow/wrench_flow.hpp"

int main()
{
  using namespace ndframe;
  const std::vector<Direction> centres{{0.5, 0, 0}, {1.5, 0, 0}, {2.5, 0, 0}};
  const std::vector<WrenchFlow::Link> links{{{0, 1}, Spring::ofFace({1, 0, 0}, 1.0, 1.0)}, // unit faces between them
                                            {{1, 2}, Spring::ofFace({2, 0, 0}, 1.0, 1.0)}};
  const WrenchFlow flow(centres, links);

  // The first lacks a force along y about its centre, the last has it, and the moment of the pair.
  const double force = 3.0, arm = 2.0;
  std::vector<ForceMoment> lacks(3, ForceMoment{});
  lacks[0][1] = force;
  lacks[2][1] = -force;
  lacks[2][5] = arm * force;                                  // about z
  const std::vector<ForceMoment> given = flow.through(lacks); // to the first of each two, about their face

  bool ok = flow.numParts() == 1;
  for (const ForceMoment& wrench : given)
    ok = ok && std::abs(wrench[1] - force) < 1e-14;
  ok = ok && std::abs(given[0][5] + 0.5 * force) < 1e-14 && std::abs(given[1][5] + 1.5 * force) < 1e-14;
  return ok ? 0 : 1;
}
