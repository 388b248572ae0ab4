// What the program says about the error: the advice and the table.

#include <gmock/gmock.h>

#include "ndframe/certification/advice.hpp"
#include "ndframe/report/error_screen.hpp"

using namespace ndframe;
using testing::HasSubstr;
using testing::Not;

namespace
{

ErrorMeasureSummary measure(double absolute)
{
  ErrorMeasureSummary result;
  result.absolute = absolute;
  result.relative = absolute / 2.0;
  return result;
}

/// The parts of an error relative to a solution of norm 2.
ErrorSummary parts(double mesh, double iteration)
{
  ErrorSummary errors;
  errors.discretization = measure(mesh);
  errors.algorithm = measure(iteration);
  return errors;
}

std::vector<SweepRecord> history(std::initializer_list<double> epsTau)
{
  std::vector<SweepRecord> records;
  for (const double eps : epsTau) {
    records.emplace_back();
    records.back().epsTau = eps;
  }
  return records;
}

ErrorSummary everything()
{
  ErrorSummary errors = parts(0.03, 0.05);
  errors.guaranteed = true;
  errors.global = measure(0.0625);
  errors.meanStress = 0.03125;
  errors.meanStressRelative = 0.015625;
  errors.advice = "2 more sweeps would leave the mesh alone";
  return errors;
}

/// The line of a text that begins with `name`.
std::string lineOf(const std::string& text, const std::string& name)
{
  const auto begin = text.find("  " + name);
  EXPECT_NE(begin, std::string::npos) << text;
  return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

} // namespace

TEST(Advice, CountsTheSweepsByTheLastContraction)
{
  EXPECT_EQ(advice(parts(0.03, 0.05), history({0.2, 0.1})), "2 more sweeps would leave the mesh alone");
  EXPECT_EQ(advice(parts(0.03, 0.05), history({1.0, 0.1})), "1 more sweep would leave the mesh alone");
  EXPECT_EQ(advice(parts(0.03, 0.05), history({0.11, 0.1})), "15 more sweeps would leave the mesh alone");
}

TEST(Advice, NamesNoNumberWhenTheIterationDoesNotContract)
{
  EXPECT_EQ(advice(parts(0.03, 0.05), history({0.1})), "more sweeps would leave the mesh alone");
  EXPECT_EQ(advice(parts(0.03, 0.05), history({0.1, 0.2})), "more sweeps would leave the mesh alone");
}

TEST(Advice, IsAFinerMeshWhenTheMeshDominates)
{
  EXPECT_EQ(advice(parts(0.05, 0.01), history({0.2, 0.1})), "a finer mesh would help, more sweeps would not");
  EXPECT_EQ(advice(parts(0.05, 0.04), history({0.2, 0.1})), "a finer mesh and 1 more sweep would help");
}

TEST(Advice, IsNotMoreSweepsWhenTheyAreDone)
{
  for (const auto& sweeps : {history({0.2, 1e-8}), history({0.0})})
    EXPECT_EQ(advice(parts(0.03, 0.05), sweeps), "a finer mesh where contact ends would help, more sweeps would not");
}

TEST(Advice, KnowsTheMeshFromSplitToo)
{
  ErrorSummary errors = parts(0.03, 0.05);
  errors.discretization.reset();
  EXPECT_EQ(advice(errors, history({0.2, 0.1})), "");
  errors.splitStress = 0.03;
  errors.global = measure(0.06);
  EXPECT_EQ(advice(errors, history({0.2, 0.1})), "2 more sweeps would leave the mesh alone");
}

TEST(Advice, IsSilentWithoutBothPartsAndWhenNothingIsWrong)
{
  ErrorSummary errors = parts(0.03, 0.05);
  errors.algorithm.reset();
  EXPECT_EQ(advice(errors, history({0.2, 0.1})), "");
  EXPECT_EQ(advice(parts(1e-14, 5e-9), history({2e-8, 1e-8})), "");
  EXPECT_EQ(advice(parts(0.03, 0.05), {}), "");
}

TEST(ErrorText, SaysWhatIsGuaranteed)
{
  const auto text = errorText(everything());
  EXPECT_EQ(lineOf(text, "error in energy"),
            "  error in energy   <=      0.0625    3.12 %   of the solution, guaranteed");
  EXPECT_EQ(lineOf(text, "mean stress"),
            "  mean stress       <=     0.03125    1.56 %   error of the mean of computed and equilibrated stress");
}

TEST(ErrorText, SaysWhatTheDataTakeWhereThatIsMuch)
{
  ErrorSummary errors = everything();
  errors.global->oscillation = 0.25 * errors.global->absolute;
  EXPECT_THAT(errorText(errors), Not(HasSubstr("  data")));
  errors.global->oscillation = 0.5 * errors.global->absolute;
  EXPECT_EQ(
      lineOf(errorText(errors), "  data"),
      "    data            <=     0.03125    1.56 %   <- loads or prescribed displacements jump or bend within cells; "
      "mesh lines along jumps (Splits of a Box) would help");
  errors.guaranteed = false;
  EXPECT_THAT(lineOf(errorText(errors), "  data"), HasSubstr("    data             ~ "));
}

TEST(ErrorText, SaysWhyItIsNotGuaranteed)
{
  ErrorSummary errors = everything();
  errors.guaranteed = false;
  errors.reason = "Mode is Paper";
  const auto text = errorText(errors);
  EXPECT_THAT(text, Not(HasSubstr("<=")));
  EXPECT_EQ(lineOf(text, "error in energy"),
            "  error in energy    ~      0.0625    3.12 %   of the solution, not guaranteed: Mode is Paper");
}

TEST(ErrorText, PutsTheAdviceBesideTheLargerPart)
{
  ErrorSummary errors = everything();
  EXPECT_EQ(lineOf(errorText(errors), "  iteration"),
            "    iteration        ~        0.05    2.50 %   <- 2 more sweeps would leave the mesh alone");
  EXPECT_EQ(lineOf(errorText(errors), "  mesh"), "    mesh             ~        0.03    1.50 %");
  errors.algorithm = measure(0.01);
  errors.advice = "a finer mesh would help, more sweeps would not";
  EXPECT_THAT(lineOf(errorText(errors), "  mesh"), HasSubstr("<- a finer mesh would help"));
  EXPECT_THAT(lineOf(errorText(errors), "  iteration"), Not(HasSubstr("<-")));
}

TEST(ErrorText, MarksComparisonsAsNotGuaranteed)
{
  ErrorSummary errors;
  errors.zienkiewiczZhu = 0.05;
  errors.residual = 0.25;
  const auto text = errorText(errors);
  EXPECT_EQ(text, "  Zienkiewicz-Zhu    ~        0.05             a comparison, not guaranteed\n"
                  "  residual           ~        0.25             a comparison, not guaranteed");
}

TEST(ErrorText, ShowsTheMeshBySplitAsAPartOfTheBound)
{
  ErrorSummary errors = everything();
  errors.splitStress = 0.03;
  EXPECT_EQ(lineOf(errorText(errors), "  mesh, by Split"),
            "    mesh, by Split   ~        0.03             the bound without the iteration's part");
}

TEST(ErrorText, ShowsTheReferenceWithTheEffectivity)
{
  ErrorSummary errors = everything();
  errors.reference = ReferenceSummary{};
  errors.reference->refinements = 2;
  errors.reference->dofs = 123456;
  errors.reference->displacement = 0.0625;
  errors.reference->relative = 0.03125;
  errors.reference->note = "not h/8: Maximum Dofs";
  EXPECT_EQ(lineOf(errorText(errors), "reference"),
            "  reference          =      0.0625    3.12 %   against h/4, 123 456 dofs (not h/8: Maximum Dofs)");
  errors.reference->effectivity = 1.05;
  EXPECT_THAT(lineOf(errorText(errors), "reference"), HasSubstr("; the bound is 1.050 times it"));
}
