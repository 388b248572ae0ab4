#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algebra/sample_bodies.hpp"
#include "common/test_main.hpp"

namespace ndframe
{

namespace
{

std::string preconditioner(const std::string& entries)
{
  return "<ParameterList name=\"Preconditioner\">" + entries + "</ParameterList>";
}

std::string text(const std::string& name, const std::string& type, const std::string& value)
{
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

std::string ifpack2(const std::string& method, const std::string& entries = {})
{
  return preconditioner(text("Type", "string", "Ifpack2") + text("Method", "string", method) +
                        "<ParameterList name=\"Ifpack2\">" + entries + "</ParameterList>");
}

std::string mueLu(const std::string& entries)
{
  return preconditioner("<ParameterList name=\"MueLu\">" + entries + "</ParameterList>");
}

std::string belos(const std::string& entries)
{
  return "<ParameterList name=\"Belos\">" + entries + "</ParameterList>";
}

class KrylovTest : public testing::Test
{
protected:
  KrylovTest() : body(test::trussBody({56, 40}, test::comm())), problem(body.problem(test::Support::Guide)) {}

  /// The largest true residual of the interior equations, relative to the load.
  double residualOf(const std::string& xml)
  {
    const auto condensed = test::makeSolver("Krylov", xml)->factor(problem, test::comm(), ledger);
    Vector load = test::randomVector(problem.roles.size(), 1);
    const Vector u = condensed->expand(DenseMatrix(load), DenseMatrix(int(problem.kept.size()), 1)).column(0);
    const Vector force = multiply(body.matrix, u, test::comm());
    Vector residual;
    for (std::size_t dof = 0; dof < load.size(); ++dof) {
      load[dof] = problem.roles[dof] == DofRole::Interior ? load[dof] : 0.0;
      residual.push_back(problem.roles[dof] == DofRole::Interior ? load[dof] - force[dof] : 0.0);
    }
    return norm(residual) / norm(load);
  }

  test::SampleBody body;
  SolverProblem problem;
  Ledger ledger;
};

} // namespace

TEST_F(KrylovTest, TrueResidualReachesTheTolerance)
{
  EXPECT_LE(residualOf(""), 1e-10);
  EXPECT_LE(residualOf(text("Tolerance", "double", "1e-13")), 1e-13);
  EXPECT_GT(residualOf(text("Tolerance", "double", "1e-3")), 1e-10) << "a loose tolerance must save work";
}

TEST_F(KrylovTest, EveryPreconditionerReachesTheTolerance)
{
  for (const char* method : {"RILUK", "RELAXATION", "CHEBYSHEV"})
    EXPECT_LE(residualOf(ifpack2(method)), 1e-10) << method;
  EXPECT_LE(residualOf(ifpack2("RILUK", text("fact: iluk level-of-fill", "int", "2"))), 1e-10);
  EXPECT_LE(residualOf(mueLu(text("smoother: type", "string", "RELAXATION"))), 1e-10);
}

TEST_F(KrylovTest, MultigridNeedsFewIterations)
{
  residualOf("");
  EXPECT_LT(ledger.counted("Krylov iterations"), 60);
  const auto multigrid = ledger.counted("Krylov iterations");
  residualOf(ifpack2("RELAXATION"));
  EXPECT_GT(ledger.counted("Krylov iterations") - multigrid, multigrid);
}

TEST_F(KrylovTest, CountsSolvesAndIterationsButNoFactorisation)
{
  residualOf("");
  EXPECT_EQ(ledger.counted("factorisations"), 0);
  EXPECT_EQ(ledger.counted("Krylov solves"), 1);
  EXPECT_EQ(ledger.counted("back-solves"), 1);
  EXPECT_GT(ledger.counted("Krylov iterations"), 3);
}

TEST_F(KrylovTest, SaysHowFarItIsWhenTheIterationsRunOut)
{
  try {
    residualOf(text("Maximum Iterations", "int", "2"));
    FAIL();
  } catch (const NotConverged& failure) {
    EXPECT_THAT(failure.what(), testing::ContainsRegex("relative residual .* > 1.00e-10 after 2 iterations"));
  }
}

TEST_F(KrylovTest, MeetsAMatrixThatIsNotPositiveDefinite)
{
  for (std::size_t r = 0; r < std::size_t(body.matrix.numRows()); ++r)
    if (body.matrix.rowNode(int(r)) % 10 == 5)
      body.matrix.block(int(r), int(r))[0] *= 0.1;
  EXPECT_THROW(residualOf(ifpack2("RELAXATION")), SingularBody);
}

TEST_F(KrylovTest, SaysThatAMethodDoesNotTakeItsParameters)
{
  const std::string smoother = "<ParameterList name=\"smoother: params\">" + text("chebyshev: degree", "int", "3") +
                               "</ParameterList>" + text("smoother: type", "string", "RELAXATION");
  try {
    residualOf(mueLu(smoother));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("MueLu does not take its parameters"));
    EXPECT_THAT(error.what(), testing::HasSubstr("chebyshev: degree"));
  }
}

TEST_F(KrylovTest, WorksWithoutMotionsAndPoints)
{
  problem.nearNullSpace = {};
  problem.nodePoints.clear();
  EXPECT_LE(residualOf(""), 1e-10);
}

TEST_F(KrylovTest, DoesNotPromiseACheapSchurComplement)
{
  const auto condensed = test::makeSolver("Krylov")->factor(problem, test::comm(), ledger);
  EXPECT_FALSE(condensed->hasCheapSchur());
  EXPECT_EQ(condensed->description(), "Krylov, Belos CG, MueLu, tolerance 1e-10");
}

TEST(KrylovParameters, OfTheLibrariesAreChecked)
{
  EXPECT_THAT(test::complaint("Krylov", belos(text("Verbostiy", "int", "0"))),
              testing::HasSubstr("\"Verbostiy\" is not a parameter of Belos; did you mean \"Verbosity\"?"));
  EXPECT_THAT(test::complaint("Krylov", mueLu(text("smother: type", "string", "CHEBYSHEV"))),
              testing::HasSubstr("\"smother: type\" is not a parameter of MueLu; did you mean \"smoother: type\"?"));
  EXPECT_THAT(test::complaint("Krylov", ifpack2("RILUK", text("fact: level", "int", "1"))),
              testing::HasSubstr("\"fact: level\" is not a parameter of Ifpack2"));
  EXPECT_THAT(test::complaint("Krylov", mueLu(text("coarse: max size", "string", "many"))),
              testing::HasSubstr("\"coarse: max size\" of MueLu must be of type int"));
  EXPECT_THAT(test::complaint("Krylov", belos(text("Deflation Quorum", "int", "1"))), "no complaint");
}

TEST(KrylovParameters, ThatNdframeSetsAreRefused)
{
  EXPECT_THAT(test::complaint("Krylov", belos(text("Convergence Tolerance", "double", "1e-3"))),
              testing::HasSubstr("\"Convergence Tolerance\" of Belos is set by ndframe; remove it."));
  EXPECT_THAT(test::complaint("Krylov", mueLu(text("number of equations", "int", "3"))),
              testing::HasSubstr("\"number of equations\" of MueLu is set by ndframe; remove it."));
}

TEST(KrylovParameters, OutOfRangeAreRefused)
{
  EXPECT_THAT(test::complaint("Krylov", text("Tolerance", "double", "1.5")), testing::HasSubstr("(0, 1)"));
  EXPECT_THAT(test::complaint("Krylov", text("Maximum Iterations", "int", "0")), testing::HasSubstr(">= 1"));
  EXPECT_THAT(test::complaint("Krylov", ifpack2("ILUT")), testing::HasSubstr("RILUK"));
  EXPECT_THAT(test::complaint("Krylov", preconditioner(text("Type", "string", "ML"))), testing::HasSubstr("MueLu"));
}

} // namespace ndframe
