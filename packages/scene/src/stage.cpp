#include "ndframe/scene/stage.hpp"

namespace ndframe
{

const Names<Stage>& stageNames()
{
  static const Names<Stage> names{{"gmsh", Stage::Gmsh},
                                  {"mpi", Stage::Mpi},
                                  {"krylov", Stage::Krylov},
                                  {"read", Stage::Read},
                                  {"check", Stage::Check},
                                  {"assemble", Stage::Assemble},
                                  {"factor", Stage::Factor},
                                  {"interface", Stage::Interface},
                                  {"couple", Stage::Couple},
                                  {"recover", Stage::Recover},
                                  {"certificate", Stage::Certificate},
                                  {"certify traction", Stage::CertifyTraction},
                                  {"certify fields", Stage::CertifyFields},
                                  {"certify recovery", Stage::CertifyRecovery},
                                  {"certify equilibrium", Stage::CertifyEquilibrium},
                                  {"certify estimators", Stage::CertifyEstimators},
                                  {"certify reference", Stage::CertifyReference},
                                  {"refine", Stage::Refine},
                                  {"stress", Stage::Stress},
                                  {"write", Stage::Write},
                                  {"level table", Stage::LevelTable},
                                  {"write levels", Stage::WriteLevels},
                                  {"contact table", Stage::ContactTable},
                                  {"expect", Stage::Expect}};
  return names;
}

Ledger::Timer timeStage(Ledger& ledger, Stage stage)
{
  return ledger.time(stageNames().name(stage));
}

} // namespace ndframe
