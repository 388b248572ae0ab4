#pragma once

#include "ndframe/iterative/krylov_library.hpp"

namespace ndframe
{

const Teuchos::ParameterList& validIfpack2List();
const Teuchos::ParameterList& validMueLuList();

std::unique_ptr<Preconditioner> makeIfpack2(const std::string& method, const Teuchos::ParameterList& list);
std::unique_ptr<Preconditioner> makeMueLu(const Teuchos::ParameterList& list);

} // namespace ndframe
