// Checks the stress of a square under tension against its loads, point by point, and sees a load that is wrong.
#include <cmath>

#include "ndframe/equilibrium/cell_form.hpp"
#include "ndframe/equilibrium/equilibrium_check.hpp"

int main()
{
  using namespace ndframe;
  BodyModel body; // the unit square as two triangles; Young's modulus 1, no lateral contraction
  body.mesh.dim = 2;
  body.mesh.points = {0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0, 1.0};
  body.mesh.cells = {0, 1, 2, 0, 2, 3};
  body.nodes = makeNodeMap(body.mesh, 1);
  body.laws = Elasticity{2, {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.5}, {}};
  const Vector displacement{0.0, 0.0, 4.0, 0.0, 4.0, 0.0, 0.0, 0.0}; // u = 4 x: the stress sigma_xx = 4

  const auto defects = [&](double tension) { // for tractions of this size on the left and the right side
    const int degree = 1, order = 1;
    const MomentBasis basis = facetBasis(2, degree);
    const Shares shares(basis, order);
    StaticData data;
    data.dim = 2, data.order = order, data.degree = degree;
    for (const Facet facet : {Facet{0, 0}, Facet{1, 1}}) { // x = 1 and x = 0
      data.boundary.push_back({facet, 0, {}});
      double normal[2];
      const double length = facetNormal(body.mesh, facet, normal);
      for (int vertex = 0; vertex < 2; ++vertex)
        for (int k = 0; k < basis.size(); ++k)
          for (const double n : normal)
            data.facetShares.push_back(shares.ofOne(vertex)[k] * length * tension * n);
    }
    return checkEquilibrium(body, data, {&displacement, nullptr}, zeroCorrection(body.mesh, degree));
  };
  const bool ok = defects(4.0).largest() < 1e-14 && std::abs(defects(3.0).loads - 0.25) < 1e-14;
  return ok ? 0 : 1;
}
