#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "ndframe/base/expression_tree.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{

/// Functions on a simplex by their values where Gauss rules on pieces of the simplex integrate them.
///
/// On every piece each function is, to within the piece's `error`, a polynomial that the rule integrates exactly
/// together with polynomials of degree <= 5 - dim (of the simplex). So sum_i weights_i values_i P(lambda_i) is the mean
/// value of f P to within `uncertainty` times scale max |P|. Every integral of a load (load vector, moments,
/// oscillation) uses the same samples, so that they agree to round-off whatever the load.
struct Samples
{
  /// A piece of the simplex on which one rule integrates.
  struct Piece
  {
    std::array<double, 16> corners{};     ///< barycentric coordinates in the simplex of its dim + 1 corners
    double fraction = 1.0;                ///< of the simplex's measure
    int first = 0;                        ///< its first point; its points follow each other
    const QuadratureRule* rule = nullptr; ///< none on one side of a curve inside the corners
    /// Bound of |f - polynomial| + |f - values|, the largest of the functions; infinite when nothing is known.
    double error = 0.0;
    double normError = 0.0; ///< bound of |f - polynomial| for polynomials whose squares the rule integrates
    /// The same for the derivative along a piece of an edge, its length being 1.
    double slopeError = 0.0;
  };
  std::vector<Piece> pieces;  ///< in the order of their points; sampleConstant sets none
  QuadratureRule rule;        ///< the points of all pieces, barycentric in the simplex; weights add up to 1
  std::vector<double> values; ///< functions per point
  double scale = 0.0;         ///< largest value here or elsewhere: what is small is small against it
  double uncertainty = 0.0;   ///< bound of what mean values may be wrong by, relative to the scale
  double spread = 0.0;        ///< the same as `error`, root mean square, for polynomials whose squares rules integrate

  /// Root mean square of what the values leave out of the functions, which is orthogonal to polynomials of degree
  /// <= 5 - dim; 0: nothing, they are the functions' own.
  double rest = 0.0;

  /// Mean values and norms are right to 1e-10 of the scale, proven by enclosures.
  bool areCertain() const { return uncertainty <= 1e-10; }
};

/// A function of the position, and what throws where its value is not finite (dim: of space).
struct SampledFunction
{
  std::shared_ptr<const ExpressionTree> tree;                         ///< the function, of three coordinates
  std::function<void(const double* x, int dim, double value)> refuse; ///< InputError with the place in the deck and x
};

/// Samples functions of the position on many simplices. Nothing is decided by looking at values: expressions are
/// enclosed (expression_enclosure.hpp), so nothing between the points stays unseen.
///
/// Polynomials get one exact rule. Functions that are shown to be polynomials of degree <= 25 on a box that holds many
/// cells (or one) are replaced by them: they are not evaluated in every cell. Otherwise Gauss rules are tried
/// (sampling_rules.cpp); a simplex on which none is shown to be good enough is cut: where comparisons and kinks of
/// affine functions change their sign, else across the function that varies most, the worst piece first. What is
/// smaller than 1e-12 of the scale (1e-13 on edges) counts as settled. Where a smooth function that is not affine
/// changes its sign inside a triangle, its curve of zeros is located (switch_curve.hpp) and each side gets a rule, if
/// asked for. Limits: 6000 pieces made on a simplex, 200 000 in all; what is left is the samples' uncertainty. Jumps
/// and kinks along curved surfaces inside tetrahedra are not resolved to the end.
class DataSampler
{
public:
  /// Whether pieces of triangles may have a curved side, which those need not know who use the points alone.
  enum class Cuts
  {
    Straight,
    Curved
  };
  /// space: the number of coordinates of points.
  DataSampler(std::vector<SampledFunction> functions, int space, Cuts cuts = Cuts::Straight);
  ~DataSampler();
  DataSampler(const DataSampler&) = delete;
  DataSampler& operator=(const DataSampler&) = delete;

  /// Vertices of a simplex.
  using Vertices = std::array<const double*, 4>;

  /// Called with a simplex: its dimension and its vertices.
  using Visit = std::function<void(int dim, const Vertices& vertices)>;
  /// A lower bound of the functions' largest absolute value on the simplices visited, most often within a factor 2:
  /// what round-off is relative to. visit calls its argument with every simplex; their points stay where they are.
  /// Samples with this scale depend on the simplices of this call only, whatever was sampled before.
  double scaleOn(const std::function<void(const Visit&)>& visit);

  /// Samples on a simplex of dimension `dim`. scale: as from scaleOn. Memory of `samples`, from a call before, is
  /// reused.
  void sample(int dim, const Vertices& vertices, double scale, Samples& samples);
  /// The same, in memory of their own.
  Samples sample(int dim, const Vertices& vertices, double scale)
  {
    Samples samples;
    sample(dim, vertices, scale, samples);
    return samples;
  }
  /// How often a function was found to be a polynomial on a box so far.
  int polynomials() const;

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The function that is constant on the simplex, by a rule of degree 2: exact for loads on elements of order 2. Memory
/// of `samples`, from a call before, is reused.
void sampleConstant(int dim, const std::vector<double>& value, Samples& samples);

} // namespace ndframe
