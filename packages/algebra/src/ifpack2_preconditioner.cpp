#include <Ifpack2_Factory.hpp>
#include <Ifpack2_Parameters.hpp>

#include "library_list.hpp"
#include "preconditioner.hpp"
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

Teuchos::ParameterList validIfpack2()
{
  Teuchos::ParameterList valid;
  Ifpack2::getValidParameters(valid);
  return valid;
}

std::vector<std::string> ifpack2Mistakes(const Teuchos::ParameterList& list)
{
  return mistakesIn(list, validIfpack2(), "Ifpack2", {});
}

} // namespace

void registerIfpack2(Registry<Preconditioner>& registry)
{
  ListSpec list;
  list.name = "Ifpack2";
  list.doc = "Parameters of the Ifpack2 method, e.g. \"fact: iluk level-of-fill\".";
  list.passThrough = ifpack2Mistakes;
  registry.add("Ifpack2", "Incomplete factorisation, relaxation or polynomial of each rank's own rows; little memory.",
               {{"Method", "RILUK", oneOf({"RILUK", "RELAXATION", "CHEBYSHEV"}), "Ifpack2's name of the method."}},
               [](const Params& params) {
                 return std::make_unique<Ifpack2Preconditioner>(
                     params.get<std::string>("Method"), conformed(params.sub("Ifpack2").teuchos(), validIfpack2()));
               },
               {list});
}

} // namespace ndframe
