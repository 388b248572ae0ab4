#include "stress_sharing.hpp"

#include <algorithm>
#include <cmath>

namespace ndframe
{

/// A block belongs to the owner of the first cell around.
StressSharing::StressSharing(const StressFaces& faces, const std::vector<StressEdge>& edges, const Comm& comm)
    : comm_(comm), owns_(std::size_t(faces.size()) + edges.size(), 0), with_(std::size_t(comm.size()))
{
  if (comm.size() == 1) {
    std::fill(owns_.begin(), owns_.end(), char(1));
    return;
  }
  const StressCells& cells = faces.cells();
  const auto add = [&](int block, std::vector<int>& around) {
    const int owner = cells.owner(*std::min_element(around.begin(), around.end()));
    for (int& cell : around)
      cell = cells.owner(cell);
    list(block, std::move(around), owner);
  };
  for (int f = 0; f < faces.size(); ++f) {
    std::vector<int> around;
    for (const int cell : faces[f].cell)
      if (cell >= 0)
        around.push_back(cell);
    if (faces.isNear(f))
      add(f, around);
  }
  for (std::size_t e = 0; e < edges.size(); ++e) {
    std::vector<int> around;
    for (const StressEdge::Step& step : edges[e].ring)
      for (const int cell : faces[step.face].cell)
        if (cell >= 0)
          around.push_back(cell);
    add(faces.size() + int(e), around);
  }
  for (std::size_t rank = 0; rank < with_.size(); ++rank)
    with_[rank].rank = int(rank);
  with_.erase(std::remove_if(with_.begin(), with_.end(),
                             [](const SharedWith& other) { return other.lent.empty() && other.borrowed.empty(); }),
              with_.end());
  values_ = SharedValues(std::move(with_), comm);
}

/// around: ranks, with repetitions.
void StressSharing::list(int block, std::vector<int> around, int owner)
{
  owns_[std::size_t(block)] = char(owner == comm_.rank());
  if (owner != comm_.rank()) {
    with_[std::size_t(owner)].borrowed.push_back(block);
    return;
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  for (const int rank : around)
    if (rank != owner)
      with_[std::size_t(rank)].lent.push_back(block);
}

double StressSharing::unitOf(double largest) const
{
  Vector ofAll{largest};
  takeLargest(ofAll, comm_);
  return powerOfTwo(ofAll.front());
}

double powerOfTwo(double number)
{
  return number > 0.0 ? std::exp2(std::ceil(std::log2(number))) : 1.0;
}

} // namespace ndframe
