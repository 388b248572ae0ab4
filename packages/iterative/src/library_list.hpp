#pragma once

#include <string>
#include <vector>

namespace Teuchos
{
class ParameterList;
}

namespace ndframe
{

/// The mistakes of a list that is handed on to a library, one sentence each: keys that `valid` does not know, values of
/// another type, and keys that ndframe sets itself (`reserved`). Our own check, because some libraries ignore what they
/// do not know.
std::vector<std::string> mistakesIn(const Teuchos::ParameterList& given, const Teuchos::ParameterList& valid,
                                    const std::string& library, const std::vector<std::string>& reserved);

/// `given` with the ints that stand where `valid` wants doubles converted.
Teuchos::ParameterList conformed(const Teuchos::ParameterList& given, const Teuchos::ParameterList& valid);

} // namespace ndframe
