#include <cmath>

#include <gtest/gtest.h>

#include "ndframe/live/progress_state.hpp"

using namespace ndframe;

TEST(ProgressState, IsEmptyWithoutAStage)
{
  ProgressState state;
  state.tell(Depth::Level, {"level", 2}, 0.0);
  EXPECT_EQ(state.text(0.0), "");
  state.beginStage("factor");
  EXPECT_EQ(state.text(0.0), "level 2, factor");
  state.endStage("factor");
  EXPECT_EQ(state.text(0.0), "");
}

TEST(ProgressState, GuessesFromTheShareThatIsDone)
{
  ProgressState state;
  state.beginStage("factor");
  state.tell(Depth::Body, Progress::part("bodies done", 0, 4, 0.0), 10.0);
  EXPECT_EQ(state.text(11.0), "factor, bodies done 0 of 4, 0 %");
  state.tell(Depth::Body, Progress::part("bodies done", 1, 4, 0.25), 20.0);
  EXPECT_EQ(state.text(20.0), "factor, bodies done 1 of 4, 25 % (about 30 s left)");
  EXPECT_EQ(state.text(24.0), "factor, bodies done 1 of 4, 25 % (about 26 s left)");
  EXPECT_EQ(state.text(99.0), "factor, bodies done 1 of 4, 25 % (about 0 s left)");
  state.tell(Depth::Body, Progress::part("bodies done", 4, 4, 1.0), 60.0);
  EXPECT_EQ(state.text(60.0), "factor");
}

TEST(ProgressState, GuessesFromAFallByEqualFactors)
{
  ProgressState state;
  state.beginStage("couple");
  for (int sweep = 1; sweep <= 3; ++sweep) // a tenth in every 40 s
    state.tell(Depth::Step, Progress::falling("sweep", sweep, "eps_tau", std::pow(0.1, sweep), 1e-9), 40.0 * sweep);
  EXPECT_EQ(state.text(120.0), "couple, sweep 3, eps_tau 0.001 (until 1e-09, about 4 min left)");
}

TEST(ProgressState, GuessesNothingFromOneCallOrAValueThatGrows)
{
  ProgressState state;
  state.beginStage("couple");
  for (const double value : {0.5, 0.5, 0.7}) {
    state.tell(Depth::Step, Progress::falling("sweep", 1, "eps_tau", value, 0.1), 1.0);
    EXPECT_EQ(state.text(2.0).find("left"), std::string::npos);
  }
}

TEST(ProgressState, BeginsAnewWhenNumbersDo)
{
  ProgressState state;
  state.beginStage("recover");
  state.tell(Depth::Iteration, Progress::falling("iteration", 1, "residual", 1.0, 1e-2), 0.0);
  state.tell(Depth::Iteration, Progress::falling("iteration", 11, "residual", 0.1, 1e-2), 30.0);
  EXPECT_EQ(state.text(30.0), "recover, iteration 11, residual 0.1 (until 0.01, about 30 s left)");
  state.tell(Depth::Iteration, Progress::falling("iteration", 1, "residual", 0.5, 1e-2), 31.0);
  EXPECT_EQ(state.text(31.0), "recover, iteration 1, residual 0.5 (until 0.01)");
}

TEST(ProgressState, WhatEndsTakesAllInsideWithIt)
{
  ProgressState state;
  state.beginStage("couple");
  state.tell(Depth::Step, {"sweep", 1}, 0.0);
  state.tell(Depth::Iteration, {"iteration", 5}, 0.0);
  EXPECT_EQ(state.text(0.0), "couple, sweep 1, iteration 5");
  state.tell(Depth::Step, {"sweep", 2}, 0.0);
  EXPECT_EQ(state.text(0.0), "couple, sweep 2");
  state.tell(Depth::Case, {"case", 2}, 0.0);
  state.endStage("couple");
  state.beginStage("recover");
  EXPECT_EQ(state.text(0.0), "case 2, recover");
}

TEST(ProgressState, AStageOfAnotherThreadGoesOn)
{
  ProgressState state;
  state.beginStage("factor");
  state.beginStage("order");
  EXPECT_EQ(state.text(0.0), "order");
  state.endStage("order");
  EXPECT_EQ(state.text(0.0), "factor");
}
