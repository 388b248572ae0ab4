#include "block_flow_builder.hpp"

namespace ndframe
{
namespace
{

void addTo(ForceMoment& sum, const ForceMoment& wrench, double factor)
{
  for (std::size_t i = 0; i < sum.size(); ++i)
    sum[i] += factor * wrench[i];
}

} // namespace

BlockFlow::BlockFlow(const Mesh& held, const BodyPiece* piece, const Comm& comm) : comm_(comm)
{
  Builder(held, piece, comm, *this).run();
}

/// What passes between sets goes through the faces between them, off or onto their cells.
void BlockFlow::cross(const std::vector<ForceMoment>& betweenSets, std::vector<ForceMoment>& lacks,
                      std::vector<ForceMoment>& crossed) const
{
  for (const Crossing& crossing : crossings_) {
    const auto link = std::size_t(crossing.link);
    ForceMoment wrench{};
    addTo(wrench, between_->links()[link].spring.shareOf(crossing.spring, betweenSets[link]), crossing.sign);
    for (std::size_t side = 0; side < 2; ++side) {
      ForceMoment lost{};
      addTo(lost, wrench, side == 0 ? -1.0 : 1.0);
      if (const int near = crossing.near[side]; near >= 0)
        addMoved(lost, crossing.spring.centre, within_->centre(near), lacks[std::size_t(near)]);
    }
    crossed.push_back(wrench);
  }
}

std::vector<ForceMoment> BlockFlow::through(const std::vector<ForceMoment>& lacks) const
{
  constexpr std::size_t size = std::tuple_size_v<ForceMoment>;
  Vector values(std::size_t(within_->size()) * size, 0.0), sums(std::size_t(between_->size()) * size, 0.0);
  for (std::size_t i = 0; i < own_.size(); ++i) {
    const int cell = own_[i], set = setOf_[std::size_t(cell)];
    const ForceMoment& lack = lacks[std::size_t(cell)];
    std::copy(lack.begin(), lack.end(), values.begin() + std::ptrdiff_t(size) * nearOf_[i]);
    ForceMoment moved{};
    addMoved(lack, centre(cell), between_->centre(set), moved);
    for (std::size_t k = 0; k < size; ++k)
      sums[std::size_t(set) * size + k] += moved[k];
  }
  shared_.fetch([](int cell) { return SharedValues::Place{std::size_t(cell) * size, size}; }, values);
  comm_.sum(sums);
  const auto wrenches = [](const Vector& all) {
    std::vector<ForceMoment> result(all.size() / size);
    for (std::size_t i = 0; i < result.size(); ++i)
      std::copy_n(all.begin() + std::ptrdiff_t(i) * std::ptrdiff_t(size), size, result[i].begin());
    return result;
  };
  std::vector<ForceMoment> near = wrenches(values), crossed, result(halves_, ForceMoment{});
  cross(between_->through(wrenches(sums)), near, crossed);
  const std::vector<ForceMoment> inside = within_->through(std::move(near));
  for (const Place& place : places_)
    addTo(result[std::size_t(place.half)], (place.isCrossing ? crossed : inside)[std::size_t(place.number)],
          place.sign);
  return result;
}

} // namespace ndframe
