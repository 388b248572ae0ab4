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
               "displacement, stress, von Mises stress, and on an interface contact pressure and gap. Of a side: mean "
               "displacement, force and moment of the stress. The stress is that of the finite elements, of the cell "
               "that holds the point; where several cells meet, the mean of theirs, weighted by their measure.");
  probe.params = {
      ParamSpec::required("Body", Kind::String, "Which body, also where several touch."),
      ParamSpec::optional("At", Kind::Doubles, "Coordinates of a point."),
      ParamSpec::optional("From", Kind::Doubles, "Where a line begins."),
      ParamSpec::optional("To", Kind::Doubles, "Where it ends."),
      {"Points", 11, atLeast(2.0), "Of a line, equally spaced, both ends included."},
      ParamSpec::optional("Side", Kind::String,
                          "Name of a side of the body's mesh. The force is int sigma n dS with the stress of the cells "
                          "at the side, which converges with the mesh; what supports and contact carry is in the "
                          "summary of bodies and interfaces to round-off."),
      ParamSpec::optional("About", Kind::Doubles, "Point that the moment of a side is about; by default its centre."),
      {"Tolerance", 1e-6, atLeast(0.0),
       "How far outside of the mesh a point may be, relative to the body's diameter; it has the values of the nearest "
       "cell, continued. On curved sides, of which the mesh has chords, raise it."}};
  return probe;
}

} // namespace

ListSpec probesSpec()
{
  ListSpec list = makeList(
      "Probes", "Numbers at points, along lines and over sides, one named list each: in the summary, for Expect "
                "(\"probes/NAME/displacement/1\", \"probes/NAME/stress/xx\", "
                "\"probes/LINE/points/3/von_mises\", \"probes/SIDE/force/0\") and in "
                "NAME.probes.csv. Of the final state; with Accuracy of the level that is written.");
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
