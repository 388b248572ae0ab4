#include "probe_list.hpp"

#include "ndframe/base/list_specs.hpp"

namespace ndframe
{
namespace
{

std::vector<double> pointOf(const Params& list, const char* key)
{
  return list.has(key) ? list.get<std::vector<double>>(key) : std::vector<double>();
}

ListSpec probeSpec()
{
  ListSpec probe = makeList(
      "PROBE", "One point (At), points of a line (From, To) or integrals over a side (Side) of a body. At points: "
               "displacement, stress, von Mises stress, and on an interface contact pressure and gap. Over a side: "
               "mean displacement, force and moment of the stress. The stress is that of the finite elements, in the "
               "cell that contains the point; where several cells meet, their mean, weighted by their measure.");
  probe.params = {
      ParamSpec::required("Body", Kind::String, "Which body, also where several touch."),
      ParamSpec::optional("At", Kind::Doubles, "Coordinates of a point."),
      ParamSpec::optional("From", Kind::Doubles, "Where a line begins: lengths."),
      ParamSpec::optional("To", Kind::Doubles, "Where it ends: lengths."),
      {"Points", 11, atLeast(2.0), "Number of points on a line, equally spaced, both ends included."},
      ParamSpec::optional("Side", Kind::String,
                          "Name of a side of the body's mesh. The force is int sigma n dS with the stress of the cells "
                          "at the side, which converges with the mesh; the forces of supports and contact are in the "
                          "summary of bodies and interfaces, to round-off."),
      ParamSpec::optional("About", Kind::Doubles,
                          "Reference point of the moment of a side, lengths; by default its centre."),
      {"Tolerance", 1e-6, atLeast(0.0),
       "How far outside the mesh a point may be, relative to the body's diameter; it gets the values of the nearest "
       "cell, extrapolated. Raise it on curved sides, where the mesh has only chords."}};
  return probe;
}

} // namespace

ListSpec probesSpec()
{
  ListSpec list =
      makeList("Probes", "Numbers at points, along lines and over sides, one named list each: in the summary, for "
                         "Expect (\"probes/NAME/displacement/1\", \"probes/NAME/stress/xx\", "
                         "\"probes/LINE/points/3/von_mises\", \"probes/SIDE/force/0\") and in NAME.probes.csv. For the "
                         "final state; with Accuracy, for the level that is written.");
  list.params = {{"Table", true, "Write NAME.probes.csv."}};
  list.onlyIfGiven = true;
  list.each = std::make_shared<ListSpec>(probeSpec());
  return list;
}

std::vector<ProbeOptions> probesOf(const Params& output)
{
  std::vector<ProbeOptions> probes;
  if (!output.hasSub("Probes"))
    return probes;
  for (const Params& list : output.sub("Probes").subs()) {
    ProbeOptions probe;
    probe.place = ListPlace(list);
    probe.name = list.name();
    probe.body = list.get<std::string>("Body");
    probe.at = pointOf(list, "At");
    probe.from = pointOf(list, "From");
    probe.to = pointOf(list, "To");
    probe.points = list.get<int>("Points");
    probe.side = list.has("Side") ? list.get<std::string>("Side") : std::string();
    probe.about = pointOf(list, "About");
    probe.tolerance = list.get<double>("Tolerance");
    probes.push_back(std::move(probe));
  }
  return probes;
}

} // namespace ndframe
