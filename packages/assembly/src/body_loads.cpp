#include "ndframe/assembly/body_loads.hpp"

#include <algorithm>
#include <exception>
#include <iterator>
#include <mutex>
#include <optional>

#include "load_places.hpp"
#include "load_projection.hpp"
#include "nodal_forces.hpp"

namespace ndframe
{
namespace
{

/// Facets or cells of a part, at most: of a load that varies, whose parts find the polynomials of their boxes anew, and
/// of a constant one.
constexpr int mostSampled = 16384, mostConstant = 1024;

/// A load and where it acts.
struct Term
{
  const Load* load;
  LoadPlaces places;
  DataSampler* sampler = nullptr; ///< the load's own; null: it is constant
  double scale = 0.0;             ///< of its samples
  bool keeps = false;             ///< projections
  std::vector<ProjectedCells> projections{};
  std::exception_ptr failure{}; ///< the first
};

/// Some of the facets or cells of a load.
struct Part
{
  Term* term;
  LoadPlaces::Range range;
  bool isComputed = false;
  std::vector<double> forces{}; ///< simplex by simplex, node by node
  std::optional<ProjectedCells> projections{};
  std::exception_ptr failure{};
};

std::vector<Part> cut(Term& term)
{
  const int size = term.places.size(), most = term.sampler != nullptr ? mostSampled : mostConstant;
  const int count = (size + most - 1) / most, each = count > 0 ? (size + count - 1) / count : 0;
  std::vector<Part> parts;
  for (int first = 0; first < size; first += each)
    parts.push_back({&term, {first, std::min(first + each, size)}});
  return parts;
}

template <int simplexDim, int order>
void findForces(const BodyModel& body, Part& part, DataSampler* sampler)
{
  NodalForces<simplexDim, order> forces;
  const std::size_t size = std::size_t(forces.count) * std::size_t(body.mesh.dim);
  part.forces.resize(std::size_t(part.range.last - part.range.first) * size);
  double* next = part.forces.data();
  part.term->places.visit(part.range, sampler, part.term->scale, [&](const LoadedSimplex& simplex) {
    if (part.projections)
      part.projections->add(simplex);
    forces.find(simplex, body.mesh.dim, next);
    next += size;
  });
}

/// A load that is one part is sampled by its own sampler, which keeps what it finds.
void sample(const BodyModel& body, Part& part)
{
  const int dim = body.mesh.dim;
  const int count = part.range.last - part.range.first;
  const Term& term = *part.term;
  std::optional<DataSampler> ofPart;
  if (term.sampler != nullptr && count < term.places.size())
    ofPart.emplace(term.load->functions(dim), dim, DataSampler::Cuts::Curved);
  if (term.keeps)
    part.projections.emplace(dim, count);
  withDimAndOrder(dim, body.nodes.order, [&](auto d, auto p) {
    DataSampler* const sampler = ofPart ? &*ofPart : term.sampler;
    if (term.places.areCells())
      findForces<d(), p()>(body, part, sampler);
    else
      findForces<d() - 1, p()>(body, part, sampler);
  });
}

void scatter(const BodyModel& body, const Part& part, Vector& sum)
{
  const LoadPlaces& places = part.term->places;
  const std::size_t dim = std::size_t(body.mesh.dim);
  const int count = places.areCells() ? body.nodes.nodesPerCell : body.nodes.nodesPerFacet;
  const double* force = part.forces.data();
  int ofFacet[6];
  for (int number = part.range.first; number < part.range.last; ++number) {
    const Facet facet = places.at(number);
    if (!places.areCells())
      facetNodes(body.nodes, facet, ofFacet);
    const int* const nodes = places.areCells() ? body.nodes.cell(facet.cell) : ofFacet;
    for (int a = 0; a < count; ++a)
      for (std::size_t k = 0; k < dim; ++k)
        sum[std::size_t(nodes[a]) * dim + k] += *force++;
  }
}

} // namespace

class BodyLoads::Implementation
{
public:
  Implementation(const BodyModel& body, Load::Keep keep);

  int numParts() const { return int(parts_.size()); }
  bool areSampled() const;
  void compute(int part) { compute(parts_[std::size_t(part)]); }
  NodalField take();

private:
  void compute(Part& part);
  void begin(Term& term, Load::Keep keep) const;
  void finish(Part& part);

  const BodyModel& body_;
  std::vector<Term> terms_;
  std::vector<Part> parts_; ///< load by load
  std::mutex mutex_;        ///< of terms_ and what follows
  std::size_t next_ = 0;    ///< the first part that is not in sum_
  Vector sum_;
  std::vector<std::vector<double>> spare_; ///< memory for the forces of parts
};

BodyLoads::Implementation::Implementation(const BodyModel& body, Load::Keep keep)
    : body_(body), sum_(std::size_t(body.numDofs()), 0.0)
{
  for (const auto& load : body.loads)
    terms_.push_back({load.get(), LoadPlaces(*load, body.mesh)});
  for (Term& term : terms_) {
    term.load->keep(nullptr);
    try {
      begin(term, keep);
      auto parts = cut(term);
      std::move(parts.begin(), parts.end(), std::back_inserter(parts_));
    } catch (...) {
      term.failure = std::current_exception();
    }
  }
}

bool BodyLoads::Implementation::areSampled() const
{
  return std::any_of(terms_.begin(), terms_.end(), [](const Term& term) { return term.sampler != nullptr; });
}

void BodyLoads::Implementation::begin(Term& term, Load::Keep keep) const
{
  if (term.places.isConstant())
    return;
  term.sampler = &term.load->sampler(body_.mesh.dim);
  term.scale = term.places.scaleOf(*term.sampler);
  term.keeps = keep == Load::Keep::Projections && term.places.areCells();
}

/// The part goes into the sum as soon as all before it are there.
void BodyLoads::Implementation::compute(Part& part)
{
  if (const std::lock_guard lock(mutex_); !spare_.empty()) {
    part.forces = std::move(spare_.back());
    spare_.pop_back();
  }
  try {
    sample(body_, part);
  } catch (...) {
    part.failure = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  part.isComputed = true;
  for (; next_ < parts_.size() && parts_[next_].isComputed; ++next_)
    finish(parts_[next_]);
}

void BodyLoads::Implementation::finish(Part& part)
{
  Term& term = *part.term;
  if (part.failure && !term.failure)
    term.failure = part.failure;
  if (term.failure)
    return;
  scatter(body_, part, sum_);
  spare_.push_back(std::move(part.forces));
  if (part.projections)
    term.projections.push_back(std::move(*part.projections));
}

NodalField BodyLoads::Implementation::take()
{
  NDFRAME_ASSERT(next_ == parts_.size(), "loads are taken when all their parts are computed");
  Diagnostics mistakes;
  for (Term& term : terms_)
    try {
      if (term.failure)
        std::rethrow_exception(term.failure);
      if (term.keeps && LoadProjection::areCertain(term.projections))
        term.load->keep(std::make_shared<const LoadProjection>(body_.mesh, std::move(term.projections)));
    } catch (const InputError& error) {
      for (const auto& mistake : error.list())
        mistakes.add(mistake);
    }
  mistakes.throwIfAny();
  return atNodes(std::move(sum_), body_.mesh.dim);
}

BodyLoads::BodyLoads(const BodyModel& body, Load::Keep keep)
    : implementation_(std::make_unique<Implementation>(body, keep))
{}

BodyLoads::BodyLoads(BodyLoads&&) noexcept = default;
BodyLoads::~BodyLoads() = default;

int BodyLoads::numParts() const
{
  return implementation_->numParts();
}

bool BodyLoads::areSampled() const
{
  return implementation_->areSampled();
}

void BodyLoads::compute(int part) noexcept
{
  implementation_->compute(part);
}

NodalField BodyLoads::take()
{
  return implementation_->take();
}

NodalField integrateLoads(const BodyModel& body, Load::Keep keep)
{
  BodyLoads loads(body, keep);
  for (int part = 0; part < loads.numParts(); ++part)
    loads.compute(part);
  return loads.take();
}

} // namespace ndframe
