#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "ndframe/equilibrium/stress_correction.hpp"
#include "ndframe/simd/stress_matrices.hpp"
#include "stress_unknowns.hpp"

namespace ndframe
{

class PressureRoom;

/// One field that a descent changes.
struct DescentField
{
  std::vector<StressCorrection*> corrections; ///< per body of the cells; not read where there is none
  /// Admissible tractions of the faces in contact that may change with the rest; null: they stay as they are.
  ContactTraction* traction = nullptr;
  const Vector* opening = nullptr; ///< SceneField::opening; with a traction
  double beside = 0.0;             ///< SceneField::beside
  double enough = 0.0;             ///< SceneField::enough
};

/// When a descent ends.
struct DescentEnd
{
  int most;         ///< steps
  double leastGain; ///< StepGains::mean below which no further step is taken; 0: all steps are
};

/// Who wants to know how far a descent is; any thread may tell.
struct DescentWatch
{
  std::function<void()> cellIsRead;
  std::function<void(double gain)> stepIsTaken; ///< StepGains::mean
};

/// Lowers the energy of equilibrated corrections by steps of conjugate gradients over all tractions that keep the
/// balance: what is in balance by itself on every face, and wrenches around every edge.
///
/// The energy is sum_E x_E^T A_E x_E, x_E = (T, G) the data of cell E, and with a traction t^ that may change
/// + 2 int t^ (u~1_N - u~2_N - g). Its Bernstein coefficients stay <= 0: a step ends where one of them would become
/// positive; facets that stop steps keep their traction from then on. Whatever the steps are, cells stay in balance to
/// round-off, and the energy falls: a step of length a along p, from the residual r, lowers it by 2 a r.p - a^2 p.Ap.
class StressDescent
{
public:
  /// Finds the matrices of own cells. faces, contact, watch and what the fields point to must outlive it. Collective,
  /// as are all functions. Corrections are changed at own cells, and at others in part.
  StressDescent(const StressFaces& faces, const std::vector<ContactPatch>& contact, std::vector<DescentField> fields,
                const DescentWatch& watch, const Comm& comm, int threads);
  StressDescent(const StressDescent&) = delete;
  StressDescent& operator=(const StressDescent&) = delete;

  /// Takes steps, every field for itself; none where nothing but round-off is left. Returns how many all fields took.
  int lower(const DescentEnd& end);
  /// The energy of a field at present, as the steps know it.
  double energy(std::size_t field) const { return energies_[field]; }
  /// Matrices A_E that all ranks found, one a class or cell without one, and the most that one of them holds.
  std::array<std::int64_t, 2> numMatrices() const;
  const SharedValues& shared() const { return sharing_.values(); } ///< to ask what was sent

private:
  /// Steps are in single precision, in units that make their numbers of the order of one.
  using Rounded = std::vector<float>;
  /// What a batch of cells has of x_E^T A_E x_E before the first step, and its largest datum.
  struct Start
  {
    double energy, largest;
  };
  struct Steps;
  int lower(std::size_t field, const DescentEnd& end);
  int descend(Steps& steps, PressureRoom* room, std::size_t field, const DescentEnd& end);
  bool isDone(std::size_t field) const;
  double startEnergy(std::size_t field) const;
  Steps begin(std::size_t field, std::vector<char> still);
  std::optional<double> take(Steps& steps, PressureRoom* room) const;
  void findMatrices();
  void findMatrices(int batch, CellBlocks& work, Vector& space, Vector* parts, double* forces);
  void findStart(int batch, const std::function<void(const double*, double*)>& multiply, double* forces);
  void keepStart(int batch, const double* forces);
  std::size_t startSize() const { return fields_.size() * StressMatrices::mostNumbers; }
  void gradientOf(const StressUnknowns::FaceForces& ofFace, Vector& ofCarriers, Rounded& gradient) const;
  void gather(int cell, const Rounded& tractions, float* x) const;
  void cellForces(const Rounded& tractions, double unit, Rounded& result) const;
  void listFacets();
  void faceForces(int face, const Rounded& cellForces, double factor, double* sum) const;
  void addOpening(int face, const Vector& opening, double unit, double* forces) const;
  double dotOfAll(const Rounded& a, const Rounded& b) const;
  void fetch(Rounded& unknowns) const;
  void ofContact(int face, const Steps& steps, double* T) const;
  std::vector<char> held(const std::vector<char>& patches) const;
  void add(int face, const double* change, const DescentField& field, Vector& ofPatches) const;
  void addPatches(Vector& ofPatches, const DescentField& field) const;
  void addNormal(std::size_t patch, const double* T, const ContactTraction& traction, Vector& change) const;
  int facetData() const { return faces_->cells().facetData(); }

  const StressFaces* faces_;
  const std::vector<ContactPatch>* contact_;
  std::vector<DescentField> fields_;
  const DescentWatch& watch_;
  Comm comm_;
  int threads_;
  /// The facets of a face, cell by cell; the second is -1 on the boundary, and `turned` where modes have another order.
  struct Facets
  {
    static constexpr int turned = -2;
    int first, second;
  };
  std::vector<StressFaces::Seat> seats_;
  std::vector<Facets> facets_; ///< per face
  std::vector<Rounded> start_; ///< per field A_E x_E / startUnits_, by tractions, cell by cell; zero at ghosts
  Vector startUnits_;          ///< per field, powers of two; 0 while all is zero
  std::vector<std::vector<Start>> batches_; ///< per field and batch
  Vector energies_;                         ///< per field
  std::vector<StressEdge> edges_;
  StressSharing sharing_;
  ClassMatrices ofClasses_;
  StressBlocks blocks_;
  StressUnknowns unknowns_;
  StressMatrices matrices_;
};

} // namespace ndframe
