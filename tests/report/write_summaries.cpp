// Writes the summaries that check_schema.py looks at: write_summaries FOLDER.

#include "ndframe/io/atomic_file.hpp"
#include "ndframe/report/summary_text.hpp"
#include "report/sample_summaries.hpp"

int main(int, char** argv)
{
  using namespace ndframe;
  const std::string folder = argv[1];
  auto unsolved = test::contactSummary();
  unsolved.solved = false;
  unsolved.coupling->history.clear();
  writeTextAtomically(folder + "/contact.summary.json", toJson(test::contactSummary()));
  writeTextAtomically(folder + "/unsolved.summary.json", toJson(unsolved));
  writeTextAtomically(folder + "/single.summary.json", toJson(test::singleBodySummary()));
  return 0;
}
