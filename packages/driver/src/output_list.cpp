#include "output_list.hpp"

#include "ndframe/base/list_specs.hpp"
#include "probe_list.hpp"

namespace ndframe
{
namespace
{

Range plainFileName()
{
  return {"a file name without a folder",
          [](const Value& value) { return std::get<std::string>(value).find('/') == std::string::npos; }};
}

Range someFolder()
{
  return {"a folder; \".\" is the working directory",
          [](const Value& value) { return !std::get<std::string>(value).empty(); }};
}

} // namespace

ListSpec outputSpec()
{
  ListSpec list =
      makeList("Output", "What is written, and where. Files appear under their final name only when complete.");
  list.params = {
      {"Directory", std::string("."), someFolder(),
       "Folder of the results, relative to the working directory; created if missing."},
      {"Name", std::string(""), plainFileName(),
       "Beginning of the file names; empty: the deck's file name without its extension."},
      {"Exodus", true, "Write NAME.e for ParaView."},
      {"Exodus Files", std::string("Automatic"), exodusFilesNames().range(),
       "How N processes write NAME.e: as one file, or each a piece NAME.e.N.r with its part of the cells; ParaView "
       "opens "
       "all of them with any one. Automatic: in pieces from 1 000 000 nodes on. A single process writes one file."},
      {"Summary", true, "Write NAME.summary.json."},
      {"Contact Table", true, "Write NAME.contact.csv (decks with interfaces)."},
      {"Level Table", true, "Write NAME.levels.csv (decks with the list Accuracy): the history, one line per level."},
      {"All Levels", false,
       "Write every level too, as NAME.level-01.e, ..., a series for ParaView (decks with the list Accuracy)."},
      {"Checkpoint", false,
       "Write NAME.checkpoint after every level (decks with the list Accuracy) and on the way through the sweeps or "
       "status passes of a mesh (Checkpoint Sweeps): with --restart an interrupted run continues from there."},
      {"Checkpoint Sweeps", 20, atLeast(0),
       "Write NAME.checkpoint after so many sweeps of a mesh each, or every status pass of couplings without sweeps; "
       "0: only after levels. Sweeps after it begin with a new factor, which changes round-off."},
      {"Report", false,
       "Write NAME.report.html: scene, verdict, pictures and tables from the written files, on one self-contained "
       "page; `ndframe report NAME` makes it later. Needs Summary, and python3-netcdf4, python3-matplotlib and "
       "python3-jinja2. A study gets one for its table."},
      {"Steps", std::string("Final"), stepsNames().range(),
       "Steps of NAME.e: the final state, or the state after every sweep (one back substitution per body and sweep)."},
      {"Equilibrated Stress", false,
       "Add the stress in equilibrium with the loads to NAME.e, its mean in every element (sigma_hat_xx, ...; needs "
       "the estimator Global)."},
      {"Mean Stress", false,
       "Add the mean of the computed and the equilibrated stress to NAME.e (mean_stress_xx, ...): its error is bounded "
       "by about half of the bound (needs the estimator Global)."}};
  list.lists = {probesSpec()};
  return list;
}

ListSpec expectationSpec()
{
  ListSpec list = makeList("EXPECTATION", "One number that the run must reproduce (exit code 4 when it does not).");
  list.params = {ParamSpec::required("Quantity", Kind::String,
                                     "Path of the number in the summary, e.g. \"energy\", \"bodies/punch/energy\", "
                                     "\"interfaces/contact/contact_force\", \"coupling/sweeps\"."),
                 ParamSpec::required("Value", Kind::Double, "Expected value, in the unit of the quantity."),
                 ParamSpec::required("Tolerance", Kind::Double, atLeast(0.0),
                                     "Largest absolute difference, in the unit of the quantity.")};
  return list;
}

OutputOptions outputOptions(const Params& deck)
{
  const Params list = deck.sub("Output");
  OutputOptions options;
  options.place = ListPlace(list);
  options.directory = list.get<std::string>("Directory");
  options.name = list.get<std::string>("Name");
  options.exodus = list.get<bool>("Exodus");
  options.exodusFiles = exodusFilesNames().value(list.get<std::string>("Exodus Files"));
  options.summary = list.get<bool>("Summary");
  options.contactTable = list.get<bool>("Contact Table");
  options.levelTable = list.get<bool>("Level Table");
  options.report = list.get<bool>("Report");
  options.allLevels = list.get<bool>("All Levels");
  options.checkpoint = list.get<bool>("Checkpoint");
  options.checkpointSweeps = list.get<int>("Checkpoint Sweeps");
  options.steps = stepsNames().value(list.get<std::string>("Steps"));
  options.equilibratedStress = list.get<bool>("Equilibrated Stress");
  options.meanStress = list.get<bool>("Mean Stress");
  options.probes = probesOf(list);
  options.probeTable = !options.probes.empty() && list.sub("Probes").get<bool>("Table");
  return options;
}

std::vector<Expectation> expectationsOf(const Params& deck)
{
  std::vector<Expectation> expectations;
  for (const Params& list : deck.sub("Expect").subs())
    expectations.push_back({ListPlace(list), list.name(), list.get<std::string>("Quantity"), list.get<double>("Value"),
                            list.get<double>("Tolerance")});
  return expectations;
}

} // namespace ndframe
