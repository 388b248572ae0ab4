// Tells what a program is doing and how far it is, and gets one line of text for the screen, with a guess of what is
// left.
#include "ndframe/live/progress_state.hpp"

int main()
{
  using namespace ndframe;
  ProgressState state;
  state.beginStage("couple");
  // The residual falls by a factor of ten every 40 s, so six more orders of magnitude take 240 s.
  double residual = 1.0, seconds = 0.0;
  for (int sweep = 1; sweep <= 3; ++sweep) {
    residual /= 10.0;
    seconds += 40.0;
    state.tell(Depth::Step, Progress::falling("sweep", sweep, "residual", residual, 1e-9), seconds);
  }
  const bool guesses = state.text(seconds) == "couple, sweep 3, residual 0.001 (until 1e-09, about 4 min left)";

  state.endStage("couple"); // its sweeps end with it
  return guesses && state.isEmpty() && state.text(seconds).empty() ? 0 : 1;
}
