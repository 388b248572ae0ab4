// Refines a mesh so that the estimated error is halved, with as few cells as possible.
#include <cmath>

#include "ndframe/adaptivity/marking.hpp"
#include "ndframe/adaptivity/refinement.hpp"

int main()
{
  using namespace ndframe;
  Mesh square; // two triangles
  square.dim = 2;
  square.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  square.cells = {0, 1, 2, 0, 2, 3};
  Registry<Refinement> refinements("refinement");
  registerRefinements(refinements);
  Registry<Marking> markings("marking");
  registerMarkings(markings);
  const auto first = refinements.build({"Type=Bisection"})->begin({{square}, {}, {}}, Comm::single());

  // Displacements of degree 1 without corners where stresses are large: both cells contribute alike to the error 5.
  const int degree = 1;
  const Vector contributions(2, 5.0 / std::sqrt(2.0)), exponents(4, ErrorDecay{degree, 2}.smoothExponent());
  const ContributionModel model(first->meshes(), {contributions}, {exponents}, degree);
  const auto marking = markings.build({"Type=Predicted"});
  const auto refined = first->refined(marking->sizes(model, 2.5));

  // The error falls like the size of the cells: it takes half the size, four times as many cells.
  bool ok = marking->cellsFor(model, 2.5) == 8 && refined->meshes().front().numCells() == 8;
  ok = ok && std::abs(model.errorOn(refined->meshes(), refined->ancestors()) - 2.5) < 1e-13;
  return ok ? 0 : 1;
}
