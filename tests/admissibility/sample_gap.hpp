#pragma once

#include "admissibility/contact_strip.hpp"
#include "ndframe/admissibility/gap_bound.hpp"

namespace ndframe::test
{

/// A gap, an expression in x.
class Gap
{
public:
  Gap(const char* text) : text_(text), tree_(std::make_shared<const ExpressionTree>(text)) {}
  double operator()(double x) const
  {
    const double point[3] = {x, 0.0, 0.0};
    double value = 0.0;
    tree_->values(point, 1, &value);
    return value;
  }
  /// For boundGap on all facets of a strip.
  std::vector<PatchGap> on(const ContactStrip& strip) const { return {{int(strip.patches.size()), {tree_, {}}}}; }
  const std::string& text() const { return text_; }

private:
  std::string text_;
  std::shared_ptr<const ExpressionTree> tree_;
};

} // namespace ndframe::test
