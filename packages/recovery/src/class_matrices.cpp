#include "class_matrices.hpp"

#include <algorithm>

#include "stress_matrices.hpp"

namespace ndframe
{

ClassMatrices::ClassMatrices(const StressCells& cells)
    : cells_(&cells), rows_(cells.any().reference().tractions), columns_(cells.any().reference().data()),
      place_(std::size_t(cells.classes().size()), -1)
{
  std::vector<int> large;
  for (int number = 0; number < cells.classes().size(); ++number)
    if (cells.classes().count(number) >= fewest) {
      place_[std::size_t(number)] = size_++;
      large.push_back(number);
    }
  tables_.resize(std::size_t(size_) * tableSize());
  const CellForms& forms = solidForms(cells.any().data().degree);
  for (int first = 0; first < size_; first += CellForms::lanes)
    find(forms, large.data() + first, std::min(CellForms::lanes, size_ - first));
}

/// Those of some classes side by side: A = F^-T A^ F^-1, vector by vector.
void ClassMatrices::find(const CellForms& forms, const int* classes, int count)
{
  std::vector<int> firsts;
  for (int c = 0; c < count; ++c)
    firsts.push_back(cells_->classes().first(classes[c]));
  std::array<CellMap, CellForms::lanes> maps;
  Vector compliances, work;
  findCompliances(*cells_, firsts.data(), count, maps.data(), compliances);
  const CellForms::Condensed found = forms.condensed(compliances.data(), work);
  const CellMatrices matrices{firsts.data(), count, maps.data(), found.triangle, columns_};
  for (int c = 0; c < count; ++c) {
    double* table = tables_.data() + std::size_t(place_[std::size_t(classes[c])]) * tableSize();
    const auto& inverse = maps[std::size_t(c)].inverse;
    for (int row = 0; row < rows_; row += 3)
      for (int col = 0; col < columns_; col += 3) {
        double half[3][3] = {}; // A^ F^-1 of two vectors
        for (int k = 0; k < 3; ++k)
          for (int l = 0; l < 3; ++l) {
            const double entry = matrices.entry(std::max(row + k, col + l), std::min(row + k, col + l))[c];
            for (int j = 0; j < 3; ++j)
              half[k][j] += entry * inverse[std::size_t(3 * l + j)];
          }
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k)
              table[(row + i) * columns_ + col + j] += inverse[std::size_t(3 * k + i)] * half[k][j];
      }
  }
}

} // namespace ndframe
