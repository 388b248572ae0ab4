#include "ndframe/simd/class_matrices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ndframe/simd/stress_matrices.hpp"

namespace ndframe
{

ClassMatrices::ClassMatrices(const StressCells& cells)
    : cells_(&cells), columns_(cells.any().reference().data()),
      tractions_(std::size_t(cells.any().reference().tractions)), place_(std::size_t(cells.classes().size()), -1)
{
  std::vector<int> large;
  for (int number = 0; number < cells.classes().size(); ++number)
    if (cells.classes().count(number) >= fewest) {
      place_[std::size_t(number)] = size_++;
      large.push_back(number);
    }
  tables_.resize(std::size_t(size_) * tableSize());
  rounded_.resize(std::size_t(size_) * tractions_ * tractions_);
  units_.assign(std::size_t(size_), 0.0);
  const CellForms& forms = solidForms(cells.any().data().degree);
  for (int first = 0; first < size_; first += CellForms::lanes)
    find(forms, large.data() + first, std::min(CellForms::lanes, size_ - first));
}

int ClassMatrices::numOwn() const
{
  int own = 0;
  for (int number = 0; number < int(place_.size()); ++number)
    own += int(place_[std::size_t(number)] >= 0 && cells_->classes().hasOrigin(number) &&
               cells_->isOwn(cells_->classes().first(number)));
  return own;
}

/// Those of some classes side by side.
void ClassMatrices::find(const CellForms& forms, const int* classes, int count)
{
  std::vector<int> firsts;
  for (int c = 0; c < count; ++c)
    firsts.push_back(cells_->classes().first(classes[c]));
  std::array<CellMap, CellForms::lanes> maps;
  Vector compliances, work;
  findCompliances(*cells_, firsts.data(), count, maps.data(), compliances);
  const CellForms::Condensed found = forms.condensed(compliances.data(), work);
  const CellMatrices matrices{maps.data(), found.triangle, columns_};
  for (int c = 0; c < count; ++c) {
    const auto place = std::size_t(place_[std::size_t(classes[c])]);
    turn(matrices, c, tables_.data() + place * tableSize());
    if (isRound(maps[std::size_t(c)]))
      round(place);
  }
}

bool isRound(const CellMap& map)
{
  constexpr double mostStretched = 12.0;
  const auto norm = [](const auto& matrix) {
    return std::sqrt(std::inner_product(matrix.begin(), matrix.end(), matrix.begin(), 0.0));
  };
  return norm(map.F) * norm(map.inverse) < mostStretched;
}

void ClassMatrices::round(std::size_t place)
{
  const double* table = tables_.data() + place * tableSize();
  float* rounded = rounded_.data() + place * tractions_ * tractions_;
  const auto stride = std::size_t(columns_);
  for (std::size_t i = 0; i < tractions_; ++i) // on the diagonal are the largest entries
    units_[place] = std::max(units_[place], table[i * (stride + 1)]);
  for (std::size_t i = 0; i < tractions_; ++i, table += stride)
    for (std::size_t j = 0; j < tractions_; ++j)
      *rounded++ = float(table[j] / units_[place]);
}

/// A = F^-T A^ F^-1 of one lane, vector by vector.
void ClassMatrices::turn(const CellMatrices& matrices, int lane, double* table) const
{
  const auto& F = matrices.maps[lane].inverse;
  const double inverse[3][3] = {{F[0], F[1], F[2]}, {F[3], F[4], F[5]}, {F[6], F[7], F[8]}};
  for (int row = 0; row < columns_; ++row, table += columns_)
    for (int col = 0; col < columns_; col += 3) {
      double half[3] = {}; // row of F^-T A^
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const int i = row - row % 3 + k, j = col + l;
          half[l] += inverse[k][row % 3] * matrices.entry(std::max(i, j), std::min(i, j))[lane];
        }
      for (int j = 0; j < 3; ++j)
        for (int l = 0; l < 3; ++l)
          table[col + j] += half[l] * inverse[l][j];
    }
}

} // namespace ndframe
