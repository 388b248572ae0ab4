#pragma once

#include <memory>

#include "ndframe/assembly/body_system.hpp"

namespace ndframe
{

/// The integral int q . v of all loads of a body, in parts that threads may compute side by side. What comes out does
/// not depend, to the bit, on who computed which part when. The body is kept elsewhere.
class BodyLoads
{
public:
  /// keep: what the loads keep of their samples.
  BodyLoads(const BodyModel& body, Load::Keep keep);
  BodyLoads(BodyLoads&&) noexcept;
  ~BodyLoads();

  int numParts() const;
  bool areSampled() const; ///< some of them are not constant: parts are worth threads
  /// Computes a part, once; several may be computed at a time. Memory is least when they are begun in ascending order.
  void compute(int part) noexcept;
  /// When all parts are computed: the integral in global axes (numNodes * dim). Throws InputError that names every load
  /// that is not finite somewhere.
  NodalField take();

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// All parts on this thread, in order.
NodalField integrateLoads(const BodyModel& body, Load::Keep keep = Load::Keep::Nothing);

} // namespace ndframe
