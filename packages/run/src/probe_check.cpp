#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ndframe/assembly/side_condition.hpp"
#include "ndframe/base/help.hpp"
#include "ndframe/mesh/cells_of_points.hpp"
#include "probes.hpp"

namespace ndframe
{
namespace
{

/// What is wrong with one probe.
class ProbeCheck
{
public:
  ProbeCheck(const Model& model, const ProbeOptions& probe, Diagnostics& diagnostics)
      : model_(model), probe_(probe), diagnostics_(diagnostics)
  {}

  void run()
  {
    number_ = probedBody(model_, probe_);
    if (number_ < 0)
      return refuse("Body", unknownBody());
    body_ = &model_.bodies[std::size_t(number_)];
    if (body_->isRigid)
      return refuse("Body",
                    fmt::format("\"{}\" is rigid: it has no stress and moves as the deck says; name a body that "
                                "touches it.",
                                probe_.body));
    if (!namesOnePlace() || !hasCoordinates())
      return;
    if (!probe_.side.empty() && probedSide(*body_, probe_) == nullptr)
      return refuse(
          "Side", fmt::format("body \"{}\" has no side \"{}\"; {}.", body_->name, probe_.side, sideNames(body_->mesh)));
    checkInside();
  }

private:
  void refuse(const std::string& key, const std::string& message)
  {
    diagnostics_.add(probe_.place.mistake(key, message));
  }

  std::string unknownBody() const
  {
    std::vector<std::string> names;
    for (const auto& body : model_.bodies)
      names.push_back(body.name);
    const auto nearest = nearestName(probe_.body, names);
    return fmt::format("there is no body \"{}\"; {}", probe_.body,
                       nearest.empty() ? fmt::format("the bodies are: {}.", fmt::join(names, ", "))
                                       : fmt::format("did you mean \"{}\"?", nearest));
  }

  bool namesOnePlace()
  {
    const int places =
        int(!probe_.at.empty()) + int(!probe_.from.empty() || !probe_.to.empty()) + int(!probe_.side.empty());
    if (places != 1)
      refuse("", fmt::format("a probe has {}: give At (a point), or From and To (a line), or Side (integrals).",
                             places == 0 ? "no place" : "one place"));
    else if (probe_.from.empty() != probe_.to.empty())
      refuse("", fmt::format("a line needs both ends: {} is missing.", probe_.to.empty() ? "To" : "From"));
    else if (!probe_.about.empty() && probe_.side.empty())
      refuse("About", "only integrals over a Side have a moment; remove this.");
    else
      return true;
    return false;
  }

  bool hasCoordinates()
  {
    bool all = true;
    const auto look = [&](const char* key, const std::vector<double>& point) {
      if (point.empty() || int(point.size()) == body_->mesh.dim)
        return;
      refuse(key, fmt::format("{} has {} coordinates and the body {} dimensions.", key, point.size(), body_->mesh.dim));
      all = false;
    };
    look("At", probe_.at);
    look("From", probe_.from);
    look("To", probe_.to);
    look("About", probe_.about);
    return all;
  }

  void checkInside()
  {
    const auto wanted = probe_.wanted();
    const auto places = cellsOfPoints(body_->mesh, wanted, reachOf(probe_, model_, number_));
    const auto isOutside = [](const auto& cells) { return cells.empty(); };
    const auto outside = std::count_if(places.begin(), places.end(), isOutside);
    if (outside == 0)
      return;
    const auto first = std::find_if(places.begin(), places.end(), isOutside) - places.begin();
    const std::string place = pointText(wanted[std::size_t(first)].data(), body_->mesh.dim);
    const std::string which =
        probe_.isLine() ? fmt::format("{} of its {} points, the first at {},", outside, wanted.size(), place) : place;
    refuse(probe_.isLine() ? "From" : "At",
           fmt::format("{} lie{} outside of \"{}\", which extends from {}. Name places in the body; Tolerance allows "
                       "for curved sides, where the mesh has only chords.",
                       which, outside == 1 ? "s" : "", body_->name, extent()));
  }

  /// "(0, 0) to (1, 2)"
  std::string extent() const
  {
    const Mesh& mesh = body_->mesh;
    std::vector<double> lower(mesh.point(0), mesh.point(0) + mesh.dim), upper = lower;
    for (int i = 1; i < mesh.numPoints(); ++i)
      for (std::size_t k = 0; k < lower.size(); ++k) {
        lower[k] = std::min(lower[k], mesh.point(i)[k]);
        upper[k] = std::max(upper[k], mesh.point(i)[k]);
      }
    return pointText(lower.data(), mesh.dim) + " to " + pointText(upper.data(), mesh.dim);
  }

  const Model& model_;
  const ProbeOptions& probe_;
  Diagnostics& diagnostics_;
  int number_ = -1;
  const BodyModel* body_ = nullptr;
};

} // namespace

void checkProbes(const Model& model, const std::vector<ProbeOptions>& probes, Diagnostics& diagnostics)
{
  for (const ProbeOptions& probe : probes)
    ProbeCheck(model, probe, diagnostics).run();
}

} // namespace ndframe
