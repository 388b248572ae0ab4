#pragma once

#include <vector>

#include "box_polynomials.hpp"
#include "cell_polynomial.hpp"
#include "ndframe/sampling/adaptive_samples.hpp"
#include "simplex_piece.hpp"

namespace ndframe
{

/// Samples on cells and faces where every function is a polynomial or shown to be one on a box, most often of many
/// simplices: one rule, and the values of the box's polynomials. Costs little more than constants do.
class SmoothSamples
{
public:
  SmoothSamples(const std::vector<SampledFunction>& functions, int space);

  /// Forgets what is known for another scale.
  void begin(double scale);
  /// False where a function is not smooth enough; the samples are then undefined.
  bool sample(const SimplexGeometry& simplex, double scale, Samples& samples);
  /// Large boxes on which functions were evaluated.
  int polynomials() const;

private:
  struct Place ///< a simplex's centroid, and its radius, rounded up
  {
    Region::Point centroid{};
    double radius = 0.0;
  };

  bool findPolynomials(const Place& place, double allowed);
  void recentre(const Place& place, double leftOut);
  double distance(int degree) const;
  const SamplingRule* findRule(const SimplexGeometry& simplex, double scale) const;
  void addValues(const SimplexGeometry& simplex, const SamplingRule& sampling, Samples& samples);
  void evaluate(const SampledFunction& function, const SimplexGeometry& simplex, Samples& samples);

  const std::vector<SampledFunction>& functions_;
  bool arePolynomials_;
  std::vector<BoxPolynomials> boxes_;
  std::vector<double> terms_;                     ///< per function: those of a polynomial that costs as much
  double scale_ = 0.0;                            ///< that the boxes are for
  std::vector<const BoxPolynomial*> here_;        ///< null for what is a polynomial everywhere
  std::vector<CellPolynomial> cells_;             ///< the same about a simplex
  std::vector<const PlacedPolynomial*> chosen_;   ///< one of both
  std::vector<SmoothDistances> ofPolynomials_;    ///< per function; infinite for degrees below its own
  std::vector<const SmoothDistances*> distances_; ///< per function, on the simplex
  std::vector<double> points_, values_;
};

} // namespace ndframe
