#include <Ifpack2_Factory.hpp>
#include <Ifpack2_Parameters.hpp>

#include "preconditioners.hpp"
#include "tpetra_system.hpp"

namespace ndframe
{

namespace
{

/// One method of Ifpack2 on each rank's own rows (additive Schwarz without overlap, hence symmetric).
class Ifpack2Preconditioner final : public Preconditioner
{
public:
  Ifpack2Preconditioner(std::string method, const Teuchos::ParameterList& list)
      : method_(std::move(method)), list_(list)
  {}

  std::shared_ptr<PreconditionerHandle> build(const TpetraSystem& system) const override
  {
    const Teuchos::RCP<const Tpetra::RowMatrix<double>> matrix = system.matrix;
    const auto schwarz = Ifpack2::Factory::create("SCHWARZ", matrix);
    Teuchos::ParameterList list;
    list.set("schwarz: overlap level", 0);
    list.set("schwarz: inner preconditioner name", method_);
    list.sublist("schwarz: inner preconditioner parameters") = list_;
    schwarz->setParameters(list);
    schwarz->initialize();
    schwarz->compute();
    return std::make_shared<PreconditionerHandle>(PreconditionerHandle{schwarz});
  }

  std::string name() const override { return "Ifpack2 " + method_; }

private:
  std::string method_;
  Teuchos::ParameterList list_;
};

} // namespace

const Teuchos::ParameterList& validIfpack2List()
{
  static const Teuchos::ParameterList valid = [] {
    Teuchos::ParameterList list;
    Ifpack2::getValidParameters(list);
    return list;
  }();
  return valid;
}

std::unique_ptr<Preconditioner> makeIfpack2(const std::string& method, const Teuchos::ParameterList& list)
{
  return std::make_unique<Ifpack2Preconditioner>(method, list);
}

} // namespace ndframe
