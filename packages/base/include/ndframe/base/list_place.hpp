#pragma once

#include <utility>

#include "ndframe/base/params.hpp"

namespace ndframe
{

/// Where a list of the deck stands: for mistakes that show after its values were read.
class ListPlace
{
public:
  /// Without a list there is no place: mistake() must not be called then.
  explicit ListPlace(Params list = Params(nullptr)) : list_(std::move(list)) {}

  /// With the place of `key`, or of the list: empty key.
  Diagnostic mistake(const std::string& key, const std::string& message) const { return list_.mistake(key, message); }

private:
  Params list_;
};

} // namespace ndframe
