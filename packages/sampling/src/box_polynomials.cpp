#include "box_polynomials.hpp"

#include <cmath>

#include "ndframe/base/mixed_hash.hpp"

namespace ndframe
{
namespace
{

/// A degree for which smaller boxes would not be cheaper: the fewer cells a box holds, the less they save.
constexpr int cheap(int space, int up)
{
  if (up == 1)
    return BoxPolynomial::highest;
  return space == 3 ? 8 : up == 2 ? 18 : up == 3 ? 14 : 12;
}

} // namespace

std::size_t BoxPolynomials::Hash::operator()(const Place& place) const
{
  const auto& [level, x, y, z] = place.box;
  std::uint64_t all = 0;
  for (const std::int64_t part : {std::int64_t(level), x, y, z, std::int64_t(place.up)})
    all = mixedHash(all, std::uint64_t(part));
  return all ^ all >> 32;
}

void BoxPolynomials::begin(bool isSame)
{
  last_ = nullptr;
  lastUp_ = largest;
  if (!isSame)
    boxes_.clear();
}

/// The box of 2^(level + up), of cells of a radius between 2^(level - 1) and 2^level whose centroid lies in it.
BoxPolynomials::Box& BoxPolynomials::boxAround(const Region::Point& centroid, int level, int up, double allowed)
{
  const TreeBox place(centroid, level + up, space_);
  const auto [found, isNew] = boxes_.try_emplace({place.place, up});
  if (isNew)
    make(found->second, place, level, up, allowed);
  return found->second;
}

/// Each smaller box may leave out more of what a cell may miss; the rest is for rounding.
void BoxPolynomials::make(Box& box, const TreeBox& place, int level, int up, double allowed)
{
  const Box* around = up < largest ? &boxAround(place.middle, level, up + 1, allowed) : nullptr;
  if (around != nullptr && around->ofCells != nullptr) {
    box.ofCells = around->ofCells;
    return;
  }
  const BoxPlace widened{space_, place.middle, 0.5 * place.width + std::ldexp(1.0, level)};
  std::optional<ChebyshevBox> series;
  if (around != nullptr && around->series != nullptr) {
    const double share = 0.5 + 0.4 * (largest - up) / (largest - 1.0);
    series = around->series->restricted(widened, share * allowed);
  } else {
    series = ChebyshevBox::fit(tree_, widened, 0.5 * allowed);
    fitted_ += series ? 1 : 0;
  }
  if (!series)
    return;
  if (series->degree() <= cheap(space_, up)) {
    auto inPowers = series->inPowers();
    if (inPowers.error() <= allowed) {
      box.inPowers = std::make_unique<const BoxPolynomial>(std::move(inPowers));
      box.ofCells = box.inPowers.get();
      return;
    }
  }
  box.series = std::make_unique<const ChebyshevBox>(std::move(*series));
}

const BoxPolynomial* BoxPolynomials::around(const Region::Point& centroid, double radius, double allowed)
{
  if (last_ != nullptr && last_->holds(centroid, radius))
    return last_;
  const int level = TreeBox::levelOf(radius);
  for (int up = lastUp_; up >= 1; --up) {
    last_ = boxAround(centroid, level, up, allowed).ofCells;
    lastUp_ = up;
    if (last_ != nullptr)
      return last_;
  }
  lastUp_ = largest;
  return ofCell(centroid, radius, allowed);
}

/// On the simplex's own box, which is half as wide at least.
const BoxPolynomial* BoxPolynomials::ofCell(const Region::Point& centroid, double radius, double allowed)
{
  const auto series = ChebyshevBox::fit(tree_, {space_, centroid, radius}, 0.5 * allowed);
  if (!series)
    return nullptr;
  ++fitted_;
  cell_.emplace(series->inPowers());
  return cell_->error() <= allowed ? &*cell_ : nullptr;
}

} // namespace ndframe
