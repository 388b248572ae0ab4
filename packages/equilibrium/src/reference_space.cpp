#include "reference_space.hpp"

#include "ndframe/equilibrium/sub_cell.hpp"

namespace ndframe
{

ReferenceSpace::ReferenceSpace(int dim, int degree)
    : dim_(dim), stress_(MomentBasis::polynomials(dim, degree)), divergence_(MomentBasis::polynomials(dim, degree - 1)),
      facet_(facetBasis(dim, degree)), load_(loadBasis(dim, degree)), cellRule_(simplexRule(dim, 2 * degree)),
      facetRule_(simplexRule(dim - 1, 2 * degree))
{}

double ReferenceSpace::subCellMeasure() const
{
  return referenceMeasure(dim_) / (dim_ + 1);
}

void ReferenceSpace::addTraction(DenseMatrix& rows, int firstRow, int sub, int opposite) const
{
  const SubCell cell{dim_, sub};
  std::vector<double> L(std::size_t(facetModes()), 0.0), m(std::size_t(modes()), 0.0);
  for (int q = 0; q < facetRule_.size(); ++q) {
    double mu[4] = {};
    // The barycentre comes first on inner facets, so that both sides agree on the facet's coordinates.
    int next = 0;
    if (sub != opposite)
      mu[sub] = facetRule_.point(q)[next++];
    for (int a = 0; a <= dim_; ++a)
      if (a != sub && a != opposite)
        mu[a] = facetRule_.point(q)[next++];
    facet_.values(facetRule_.point(q), L.data());
    stress_.values(mu, m.data());
    for (int i = 0; i < dim_; ++i)
      for (int j = 0; j < dim_; ++j) {
        const double area = -dim_ * subCellMeasure() * cell.gradient(opposite, j) * facetRule_.weights[std::size_t(q)];
        for (int k = 0; k < facetModes(); ++k)
          for (int l = 0; l < modes(); ++l)
            rows(firstRow + k * dim_ + i, column(sub, voigt(dim_, i, j), l)) +=
                area * L[std::size_t(k)] * m[std::size_t(l)];
      }
  }
}

DenseMatrix ReferenceSpace::divergence() const
{
  DenseMatrix rows((dim_ + 1) * divergenceModes() * dim_, coefficients());
  std::vector<double> m(std::size_t(divergenceModes()), 0.0), dm(std::size_t(modes()) * std::size_t(dim_), 0.0);
  for (int q = 0; q < cellRule_.size(); ++q) {
    divergence_.values(cellRule_.point(q), m.data());
    stress_.gradients(cellRule_.point(q), dm.data());
    for (int sub = 0; sub <= dim_; ++sub)
      for (int l = 0; l < modes(); ++l)
        for (int j = 0; j < dim_; ++j) {
          double derivative = 0.0;
          for (int a = 1; a <= dim_; ++a)
            derivative +=
                dm[std::size_t(l) * std::size_t(dim_) + std::size_t(a - 1)] * SubCell{dim_, sub}.gradient(a, j);
          derivative *= cellRule_.weights[std::size_t(q)];
          for (int k = 0; k < divergenceModes(); ++k)
            for (int i = 0; i < dim_; ++i)
              rows((sub * divergenceModes() + k) * dim_ + i, column(sub, voigt(dim_, i, j), l)) +=
                  m[std::size_t(k)] * derivative;
        }
  }
  return rows;
}

DenseMatrix ReferenceSpace::loadProducts(int sub) const
{
  DenseMatrix products(loadModes(), divergenceModes());
  std::vector<double> m(std::size_t(loadModes()), 0.0), d(std::size_t(divergenceModes()), 0.0);
  for (int q = 0; q < cellRule_.size(); ++q) {
    double lambda[4];
    SubCell{dim_, sub}.simplexCoordinates(cellRule_.point(q), lambda);
    load_.values(lambda, m.data());
    divergence_.values(cellRule_.point(q), d.data());
    for (int k = 0; k < loadModes(); ++k)
      for (int l = 0; l < divergenceModes(); ++l)
        products(k, l) += cellRule_.weights[std::size_t(q)] * m[std::size_t(k)] * d[std::size_t(l)];
  }
  return products;
}

DenseMatrix ReferenceSpace::dataMoments() const
{
  const int tractions = (dim_ + 1) * facetModes() * dim_;
  DenseMatrix rows(tractions + loadModes() * dim_, coefficients());
  for (int facet = 0; facet <= dim_; ++facet)
    addTraction(rows, facet * facetModes() * dim_, facet, facet);
  const DenseMatrix div = divergence();
  for (int sub = 0; sub <= dim_; ++sub) {
    const DenseMatrix products = loadProducts(sub);
    for (int j = 0; j < coefficients(); ++j)
      for (int k = 0; k < loadModes(); ++k)
        for (int l = 0; l < divergenceModes(); ++l)
          for (int i = 0; i < dim_; ++i)
            rows(tractions + k * dim_ + i, j) +=
                subCellMeasure() * products(k, l) * div((sub * divergenceModes() + l) * dim_ + i, j);
  }
  return rows;
}

DenseMatrix ReferenceSpace::constraints() const
{
  const int inner = (dim_ + 1) * dim_ / 2 * facetModes() * dim_;
  const DenseMatrix div = divergence(), data = dataMoments();
  DenseMatrix rows(inner + div.rows(), coefficients());
  int row = 0;
  for (int i = 0; i <= dim_; ++i)
    for (int j = i + 1; j <= dim_; ++j, row += facetModes() * dim_) {
      addTraction(rows, row, i, j);
      addTraction(rows, row, j, i);
    }
  // The divergence minus its projection on the load space.
  const int firstLoad = data.rows() - loadModes() * dim_;
  const double measure = (dim_ + 1) * subCellMeasure();
  for (int sub = 0; sub <= dim_; ++sub) {
    const DenseMatrix products = loadProducts(sub);
    for (int j = 0; j < coefficients(); ++j)
      for (int l = 0; l < divergenceModes(); ++l)
        for (int i = 0; i < dim_; ++i) {
          double projection = 0.0;
          for (int k = 0; k < loadModes(); ++k)
            projection += products(k, l) * data(firstLoad + k * dim_ + i, j) / measure;
          const int index = (sub * divergenceModes() + l) * dim_ + i;
          rows(inner + index, j) = div(index, j) - projection;
        }
  }
  return rows;
}

} // namespace ndframe
