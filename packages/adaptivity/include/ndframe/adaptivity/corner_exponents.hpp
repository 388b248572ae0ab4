#pragma once

#include <vector>

#include "ndframe/algebra/comm.hpp"
#include "ndframe/mesh/mesh.hpp"

namespace ndframe
{

/// How the error falls around the vertices of plane meshes, learned from one mesh to the next.
///
/// Around a corner with u ~ r^lambda the cells of a vertex contribute sum eta_K^2 ~ A^lambda together, A the area of
/// all of them; where the solution is smooth, A^(p+1) with displacements of degree p. Two meshes, the second refined
/// from the first, show lambda at every vertex whose cells became smaller. Only vertices of the very first mesh are
/// looked at, as far as they stay where they are: where sides meet or change, there is one. Elsewhere an exponent would
/// be noise, or the moving end of a contact.
class CornerExponents
{
public:
  explicit CornerExponents(int degree) : smooth_(degree + 1.0) {} ///< degree: p

  /// The next mesh of every body and eta_K on it. Points that stay keep their numbers.
  void observe(const std::vector<const Mesh*>& meshes, const std::vector<Vector>& contributions);

  /// lambda per body and vertex of the meshes last seen; p + 1 where nothing has been learned.
  const std::vector<Vector>& exponents() const { return exponents_; }

private:
  struct Stars
  {
    Vector squared, area; ///< per vertex
  };

  double smooth_;
  std::vector<Vector> firstPoints_; ///< of the first mesh per body
  std::vector<Stars> stars_;        ///< per body, of the last mesh
  std::vector<Vector> exponents_;
};

} // namespace ndframe
