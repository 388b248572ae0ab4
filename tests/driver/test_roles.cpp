// Who is Dirichlet body and who is Neumann body must not matter to the answer, only to how fast it comes.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "driver/certificate_numbers.hpp"
#include "ndframe/base/log.hpp"

using namespace ndframe;
using namespace ndframe::test;
using testing::ElementsAre;
using testing::HasSubstr;

namespace
{

Scene coarse(const std::string& deck)
{
  Scene scene(deck);
  if (deck == "punch")
    return scene.set("Bodies/punch/Mesh/Cells={5, 5}").set("Bodies/foundation/Mesh/Cells={10, 5}");
  return scene.set("Bodies/upper/Mesh/Cells={10, 8}").set("Bodies/lower/Mesh/Cells={20, 12}");
}

/// The punch with the stiffness of its block; sharp.
Scene punch(double stiffness = 1.0)
{
  return coarse("punch")
      .set(fmt::format("Bodies/punch/Material/Young Modulus={}", stiffness))
      .set("Coupling/Relaxation/Type=Aitken")
      .set("Coupling/Stopping/Tolerance=1e-11");
}

/// The keys of a deck with one interface the other way round.
Scene exchangedKeys(Scene scene)
{
  for (auto& list : scene.deck().lists)
    if (list.name == "Interfaces")
      for (auto& entry : list.lists.front().entries) {
        const bool dirichlet = entry.name.rfind("Dirichlet", 0) == 0;
        if (dirichlet || entry.name.rfind("Neumann", 0) == 0)
          entry.name = (dirichlet ? "Neumann" : "Dirichlet") + entry.name.substr(entry.name.find(' '));
      }
  return scene;
}

Scene automatic(Scene scene)
{
  return scene.set("Coupling/Dirichlet Body=Automatic");
}

Scene together(Scene scene)
{
  return scene.set("Coupling/Type=Monolithic");
}

void expectSameDisplacements(const Run& a, const Run& b, double tolerance)
{
  for (int body = 0; body < int(b.model.bodies.size()); ++body)
    EXPECT_LT(relativeDifference(displacement(a, body), displacement(b, body)), tolerance) << body;
  EXPECT_NEAR(a.summary.energy / b.summary.energy, 1.0, tolerance);
}

/// The nodes of the contact table by their places: the roles decide their order.
std::vector<ContactNode> sorted(std::vector<ContactNode> nodes)
{
  std::sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) { return a.point < b.point; });
  return nodes;
}

void expectSameContact(const Run& a, const Run& b, double tolerance)
{
  const auto first = sorted(a.solved.contact), second = sorted(b.solved.contact);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].closed, second[i].closed);
    for (const auto value : {&ContactNode::uDirichlet, &ContactNode::uNeumann, &ContactNode::gap,
                             &ContactNode::tractionDirichlet, &ContactNode::tractionNeumann, &ContactNode::nodalForce})
      EXPECT_NEAR(first[i].*value, second[i].*value, tolerance) << i;
  }
  const auto &one = a.summary.interfaces.front(), &other = b.summary.interfaces.front();
  EXPECT_EQ(one.dirichletBody, other.dirichletBody);
  EXPECT_EQ(one.neumannBody, other.neumannBody);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(one.forceOnDirichlet[k], other.forceOnDirichlet[k], tolerance);
    EXPECT_NEAR(one.forceOnNeumann[k], other.forceOnNeumann[k], tolerance);
  }
}

/// A lid on the punch, named as if the punch had two roles.
Scene threeBodies()
{
  Scene scene = punch();
  for (const char* setting :
       {"Bodies/lid/Mesh/Type=Box", "Bodies/lid/Mesh/Lower={0.0, 1.0}", "Bodies/lid/Mesh/Upper={1.0, 1.5}",
        "Bodies/lid/Mesh/Cells={5, 3}", "Bodies/lid/Material/Type=Isotropic", "Bodies/lid/Material/Young Modulus=50.0",
        "Bodies/lid/Material/Poisson Ratio=0.2", "Bodies/lid/Supports/symmetry/Type=Roller",
        "Bodies/lid/Supports/symmetry/Side=left", "Bodies/lid/Loads/press/Type=Pressure",
        "Bodies/lid/Loads/press/Side=top", "Bodies/lid/Loads/press/Value=1.0", "Bodies/punch/Loads/press/Value=0.0",
        "Interfaces/above/Dirichlet Body=lid", "Interfaces/above/Dirichlet Side=bottom",
        "Interfaces/above/Neumann Body=punch", "Interfaces/above/Neumann Side=top"})
    scene.set(setting);
  return scene;
}

class StiffnessRatio : public testing::TestWithParam<double>
{};

} // namespace

TEST_P(StiffnessRatio, ConvergesInFewSweepsToTheMonolithicSolution)
{
  const auto found = automatic(punch(GetParam())).run().run, exact = together(punch(GetParam())).run().run;
  EXPECT_TRUE(found.solved.coupling.converged) << found.solved.coupling.reason;
  EXPECT_LE(found.solved.coupling.history.size(), 20u);
  const double difference = std::max(relativeDifference(displacement(found, 0), displacement(exact, 0)),
                                     relativeDifference(displacement(found, 1), displacement(exact, 1)));
  RecordProperty("digits", fmt::format("{:.1f}", -std::log10(difference)));
  // A body 1e8 times stiffer than what it rests on: the Monolithic solution itself has lost half of its digits.
  expectSameDisplacements(found, exact, GetParam() > 1e6 ? 1e-4 : 1e-8);
}

TEST_P(StiffnessRatio, MakesTheSofterBodyTheDirichletBody)
{
  const auto roles = automatic(punch(GetParam())).run().run.summary.coupling->roles;
  ASSERT_EQ(roles.size(), 1u);
  EXPECT_LT(roles.front().contraction, 0.6);
  EXPECT_LT(roles.front().contraction, *roles.front().contractionExchanged);
  EXPECT_THAT(roles.front().dirichletBodies, ElementsAre(GetParam() > 1.0 ? "foundation" : "punch"));
  EXPECT_EQ(roles.front().exchanged, GetParam() > 1.0);
}

INSTANTIATE_TEST_SUITE_P(Roles, StiffnessRatio, testing::Values(1e-8, 1e-4, 1e4, 1e8));

TEST(Roles, ChosenAreTheSameAsWritten)
{
  // A stiff punch: the foundation becomes the Dirichlet body, the punch floats as the Neumann body.
  const auto chosen = automatic(punch(1e3)).run().run, written = exchangedKeys(punch(1e3)).run().run;
  ASSERT_TRUE(chosen.summary.coupling->roles.front().exchanged);
  EXPECT_EQ(chosen.solved.coupling.history.size(), written.solved.coupling.history.size());
  expectSameDisplacements(chosen, written, 1e-11);
  expectSameContact(chosen, written, 1e-10);
}

TEST(Roles, ChosenAgainstTheKeysOfEitherDeckMeet)
{
  const auto one = automatic(punch(1e3)).run().run, other = automatic(exchangedKeys(punch(1e3))).run().run;
  EXPECT_TRUE(one.summary.coupling->roles.front().exchanged);
  EXPECT_FALSE(other.summary.coupling->roles.front().exchanged);
  expectSameDisplacements(one, other, 1e-11);
  expectSameContact(one, other, 1e-10);
}

TEST(Roles, AreChosenWithoutAnotherFactorisation)
{
  const auto outcome = automatic(punch(1e3)).run();
  EXPECT_EQ(outcome.ledger->counted("factorisations"), 2);
  EXPECT_EQ(outcome.ledger->counted("interface factorisations"), 1 + 2);
  EXPECT_GT(outcome.ledger->counted("role steps"), 0);
  EXPECT_EQ(punch().run().ledger->counted("role steps"), 0);
}

TEST(Roles, OfARunThatIsTakenOverAreThoseOfTheDeckAgain)
{
  Ledger ledger;
  const auto solve = [&](const Scene& scene, Reusable previous) {
    return runDeck(scene.params(), components(), Comm::single(), ledger, silentLog(), std::move(previous));
  };
  auto first = solve(automatic(punch(5.0)), {});
  const auto second = solve(punch(5.0), {std::move(first.model), std::move(first.condensed)});
  EXPECT_EQ(ledger.counted("factorisations"), 2);
  const auto fresh = punch(5.0).run().run;
  expectSameDisplacements(second, fresh, 1e-8);
  expectSameContact(second, fresh, 1e-8);
}

/// The bodies that had two roles have them again, and one each when they need it.
TEST(Roles, OfThreeBodiesAreThoseOfARunOfItsOwnAfterAnotherCoupling)
{
  Ledger ledger;
  Reusable handedOn;
  for (const auto& scene : {automatic(threeBodies()), together(threeBodies()), automatic(threeBodies())}) {
    auto run = runDeck(scene.params(), components(), Comm::single(), ledger, silentLog(), std::move(handedOn));
    const auto fresh = scene.run().run;
    for (std::size_t i = 0; i < fresh.summary.interfaces.size(); ++i) {
      EXPECT_EQ(run.summary.interfaces[i].dirichletBody, fresh.summary.interfaces[i].dirichletBody);
      EXPECT_EQ(run.summary.interfaces[i].neumannBody, fresh.summary.interfaces[i].neumannBody);
    }
    EXPECT_EQ(traction(run), traction(fresh));
    for (int body = 0; body < 3; ++body)
      EXPECT_EQ(displacement(run, body), displacement(fresh, body)) << body;
    handedOn = handOn(run);
  }
  EXPECT_EQ(ledger.counted("factorisations"), 3);
}

TEST(Roles, StayThoseOfTheDeckWhereAStiffnessIsLostInRoundOff)
{
  const auto run =
      automatic(punch().set("Bodies/punch/Mesh/Upper={1.0, 1e-4}").set("Bodies/foundation/Mesh/Lower={0.0, -1e-4}"))
          .run()
          .run;
  const RoleSummary& roles = run.summary.coupling->roles.front();
  EXPECT_TRUE(std::isnan(roles.contraction));
  EXPECT_FALSE(roles.exchanged);
  EXPECT_THAT(roles.dirichletBodies, ElementsAre("punch"));
}

/// It moves 1e8 times as far as it deforms.
TEST(Roles, AreChosenForTheThetaThatTheDeckNames)
{
  const auto chosen = [](double theta) {
    return automatic(coarse("punch")).set(fmt::format("Coupling/Relaxation/Theta={}", theta)).run().run;
  };
  for (const double theta : {0.1, 0.3, 0.5}) {
    const auto run = chosen(theta);
    const RoleSummary& roles = run.summary.coupling->roles.front();
    EXPECT_LT(roles.contraction, 1.0) << theta;
    EXPECT_LE(0.9 * roles.contraction, *roles.contractionExchanged) << theta;
    EXPECT_DOUBLE_EQ(roles.theta, theta);
    EXPECT_TRUE(run.solved.coupling.converged) << run.solved.coupling.reason;
  }
}

TEST(Roles, AreFoundTogetherWithThetaByDefault)
{
  for (const double stiffness : {1e-6, 1e-3, 3.0, 1e3, 1e6}) {
    Scene scene("hertz"); // names neither
    scene.set(fmt::format("Bodies/cylinder/Material/Young Modulus={}", stiffness));
    const auto run = scene.run().run;
    EXPECT_TRUE(run.solved.coupling.converged) << stiffness << ": " << run.solved.coupling.reason;
    EXPECT_EQ(run.summary.coupling->roles.size(), 1u);
    const double best = run.summary.coupling->roles.front().bestTheta;
    for (const auto& sweep : run.solved.coupling.history)
      EXPECT_NEAR(sweep.theta, best, 0.05 * best); // two digits
  }
}

TEST(FloatingNeumannBody, KeepsTheDigitsOfItsStrains)
{
  double before = 0.0;
  for (const double stiffness : {1e8, 1e9}) {
    const auto run = automatic(punch(stiffness)).run().run;
    EXPECT_THAT(run.failure, testing::IsEmpty());
    EXPECT_LT(run.summary.residuals.equilibrium, 1e-11);
    const double scaled = run.summary.bodies.front().energy * stiffness;
    if (before > 0.0) {
      EXPECT_NEAR(scaled / before, 1.0, 1e-7); // the limit of a rigid punch
    }
    before = scaled;
  }
}

TEST(FloatingNeumannBody, EqualsTheMonolithicSolution)
{
  const auto found = exchangedKeys(punch()).run().run, exact = together(punch()).run().run;
  EXPECT_TRUE(found.solved.coupling.converged) << found.solved.coupling.reason;
  EXPECT_EQ(found.summary.interfaces.front().neumannBody, "punch");
  expectSameDisplacements(found, exact, 1e-9);
}

TEST(FloatingNeumannBody, MayStartAboveAGap)
{
  const auto open = [](Scene scene) { return scene.set("Interfaces/contact/Gap=0.1 + 4 * x^2"); };
  const auto found = exchangedKeys(open(punch())).run().run, exact = together(open(punch())).run().run;
  EXPECT_GT(exact.summary.interfaces.front().closedNodes, 0);
  EXPECT_LT(exact.summary.interfaces.front().closedNodes, exact.summary.interfaces.front().nodes);
  expectSameDisplacements(found, exact, 1e-8);
}

TEST(FloatingNeumannBody, ThatIsPulledOffEndsNotConvergedNamingTheMotion)
{
  const auto run = exchangedKeys(punch().set("Bodies/punch/Loads/press/Value=-1.0")).run().run;
  EXPECT_TRUE(run.solved.states.empty());
  EXPECT_THAT(run.failure, HasSubstr("it pulls off punch along +y"));
}

TEST(ContactLoss, DoesNotDependOnTheRoles)
{
  const auto scene =
      coarse("contact-loss").set("Coupling/Stopping/Tolerance=1e-11").set("Coupling/Relaxation/Type=Aitken");
  const auto exact = together(coarse("contact-loss")).run().run;
  expectSameDisplacements(exchangedKeys(scene).run().run, exact, 1e-8);
  expectSameDisplacements(automatic(scene).run().run, exact, 1e-8);
}

TEST(ThreeBodies, GetOneRoleEachWhateverTheKeysSay)
{
  EXPECT_THAT(complaintOf(threeBodies()), HasSubstr("solves a body in one role"));
  const auto found = automatic(threeBodies()).run().run, exact = together(threeBodies()).run().run;
  EXPECT_TRUE(found.solved.coupling.converged) << found.solved.coupling.reason;
  ASSERT_EQ(found.summary.coupling->roles.size(), 1u);
  const auto& roles = found.summary.coupling->roles.front();
  EXPECT_EQ(roles.dirichletBodies.size() + roles.neumannBodies.size(), 3u);
  expectSameDisplacements(found, exact, 1e-8);
}

TEST(TwoFloatingBodies, ThatMoveTogetherAreRefused)
{
  // The foundation floats along y as the punch does.
  const auto complaint = complaintOf(automatic(
      punch().set("Bodies/foundation/Supports/ground/Type=Roller").set("Bodies/foundation/Supports/ground/Side=left")));
  EXPECT_THAT(complaint, HasSubstr("nothing holds this body; free rigid motions: translation along y"));
}

TEST(CertificateOfChosenRoles, IsABound)
{
  for (const double stiffness : {1.0, 30.0}) {
    Scene scene = coarse("punch").set(fmt::format("Bodies/punch/Material/Young Modulus={}", stiffness));
    scene.set("Error Estimation/Estimators={Global, Discretization, Reference}")
        .set("Error Estimation/Reference/Refinements=2")
        .set("Error Estimation/Check Equilibrium=true");
    for (const auto& way : {automatic(scene), exchangedKeys(scene)}) {
      const auto outcome = way.run();
      const ErrorSummary& errors = errorsOf(outcome);
      EXPECT_TRUE(errors.guaranteed) << errors.reason;
      EXPECT_GE(errors.global->absolute, errors.reference->displacement);
      EXPECT_GE(errors.global->absolute, *errors.reference->stress);
      EXPECT_LT(*errors.equilibrium, 1e-9);
      EXPECT_LT(*errors.reference->effectivity, 3.0);
    }
  }
}
