#include <fmt/format.h>

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/base/expression.hpp"
#include "ndframe/fem/lagrange.hpp"
#include "ndframe/fem/quadrature.hpp"

namespace ndframe
{
namespace
{

/// Degree to which loads that vary are integrated, above the order of the elements.
constexpr int loadDegree = 6;

/// Adds int_simplex q . v for one simplex of dimension `dim` inside a space of dimension `space`.
/// nodes: node numbers; vertices: their coordinates; density(x, q) fills q.
template <int dim, int order, class Density>
void addSimplex(const int* nodes, const double* const* vertices, int space, double measure, const QuadratureRule& rule,
                const Density& density, Vector& load)
{
  double N[Lagrange<dim, order>::nodes], x[3], q[3];
  for (int g = 0; g < rule.size(); ++g) {
    Lagrange<dim, order>::values(rule.point(g), N);
    for (int k = 0; k < space; ++k) {
      x[k] = 0.0;
      for (int v = 0; v <= dim; ++v)
        x[k] += rule.point(g)[v] * vertices[v][k];
    }
    density(x, q);
    const double weight = measure * rule.weights[std::size_t(g)];
    for (int a = 0; a < Lagrange<dim, order>::nodes; ++a)
      for (int k = 0; k < space; ++k)
        load[std::size_t(nodes[a] * space + k)] += weight * N[a] * q[k];
  }
}

/// Adds int_side t . v dS; traction(x, n, t) fills t from the point and the outward normal.
template <class Traction>
void addOnSide(Vector& load, const Mesh& mesh, const NodeMap& nodes, const Side& side, bool varies,
               const Traction& traction)
{
  const auto rule = simplexRule(mesh.dim - 1, nodes.order + (varies ? loadDegree : 0));
  for (const Facet facet : side.facets) {
    int vertices[3], local[6];
    double n[3];
    facetVertices(mesh, facet, vertices);
    facetNodes(nodes, facet, local);
    const double measure = facetNormal(mesh, facet, n);
    const double* points[3] = {};
    for (int v = 0; v < mesh.dim; ++v)
      points[v] = mesh.point(vertices[v]);
    withDimAndOrder(mesh.dim, nodes.order, [&](auto d, auto p) {
      addSimplex<d() - 1, p()>(
          local, points, mesh.dim, measure, rule, [&](const double* x, double* t) { traction(x, n, t); }, load);
    });
  }
}

/// t = -p n on a side, equation (3).
class Pressure final : public Load
{
public:
  using Load::Load;
  void addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const override
  {
    const Expression pressure = params().expression("Value");
    addOnSide(load, mesh, nodes, side(mesh), !pressure.isConstant(), [&](const double* x, const double* n, double* t) {
      const double p = evaluate(pressure, "Value", x, mesh.dim);
      for (int k = 0; k < mesh.dim; ++k)
        t[k] = -p * n[k];
    });
  }
};

/// A vector given by one expression per component.
class VectorLoad : public Load
{
public:
  using Load::Load;
  void check(const Mesh& mesh, Diagnostics& diagnostics) const override
  {
    Load::check(mesh, diagnostics);
    if (mesh.dim == 2 && params().isGiven("Z"))
      diagnostics.add(params().mistake("Z", "this body is two-dimensional and takes no load along z."));
  }

protected:
  struct Components
  {
    std::vector<Expression> values;
    bool vary = false;
  };
  Components components(int dim) const
  {
    Components c;
    for (int k = 0; k < dim; ++k) {
      c.values.push_back(params().expression(keys.at(std::size_t(k))));
      c.vary = c.vary || !c.values.back().isConstant();
    }
    return c;
  }
  void evaluateAll(const Components& c, const double* x, double* q, int dim) const
  {
    for (int k = 0; k < dim; ++k)
      q[k] = evaluate(c.values[std::size_t(k)], keys.at(std::size_t(k)), x, dim);
  }

private:
  static constexpr std::array<const char*, 3> keys{"X", "Y", "Z"};
};

/// t = given vector on a side, equation (3).
class Traction final : public VectorLoad
{
public:
  using VectorLoad::VectorLoad;
  void addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const override
  {
    const Components c = components(mesh.dim);
    addOnSide(load, mesh, nodes, side(mesh), c.vary,
              [&](const double* x, const double*, double* t) { evaluateAll(c, x, t, mesh.dim); });
  }
};

/// b = given vector in the whole body, equation (2).
class BodyForce final : public VectorLoad
{
public:
  using VectorLoad::VectorLoad;
  void addTo(Vector& load, const Mesh& mesh, const NodeMap& nodes) const override
  {
    const Components c = components(mesh.dim);
    const auto rule = simplexRule(mesh.dim, nodes.order + (c.vary ? loadDegree : 0));
    for (int cell = 0; cell < mesh.numCells(); ++cell) {
      const double* points[4] = {};
      for (int v = 0; v <= mesh.dim; ++v)
        points[v] = mesh.point(mesh.cell(cell)[v]);
      withDimAndOrder(mesh.dim, nodes.order, [&](auto d, auto p) {
        addSimplex<d(), p()>(
            nodes.cell(cell), points, mesh.dim, cellMeasure(mesh, cell), rule,
            [&](const double* x, double* q) { evaluateAll(c, x, q, mesh.dim); }, load);
      });
    }
  }
};

template <class Component>
auto build()
{
  return [](const Params& p) { return std::make_unique<Component>(p); };
}

std::vector<ParamSpec> components(const char* unit)
{
  std::vector<ParamSpec> specs;
  for (const char* key : {"X", "Y", "Z"})
    specs.push_back(ParamSpec::expression(key, "0", fmt::format("Component along {}, {}.", key, unit)));
  return specs;
}

} // namespace

void registerLoads(Registry<Load>& registry)
{
  registry.add("Pressure", "A pressure on a side, positive when it pushes on the body.",
               {sideSpec(), ParamSpec::required("Value", Kind::Expression, "The pressure, a stress.")},
               build<Pressure>());
  auto traction = components("a stress");
  traction.insert(traction.begin(), sideSpec());
  registry.add("Traction", "A surface force on a side, by its components.", traction, build<Traction>());
  registry.add("Body Force", "A force per volume in the whole body, by its components.",
               components("a stress per length"), build<BodyForce>());
}

} // namespace ndframe
