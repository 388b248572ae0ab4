#include "preconditioner_registry.hpp"

#include "krylov_module.hpp"
#include "library_list.hpp"

namespace ndframe
{

namespace
{

void registerMueLu(Registry<Preconditioner>& registry)
{
  registry.add("MueLu",
               "Algebraic multigrid that knows the rigid motions; the number of iterations hardly grows with the mesh.",
               {},
               [](const Params& params) {
                 const KrylovLibrary& library = krylovLibrary();
                 return library.mueLu(conformed(params.sub("MueLu").teuchos(), library.validMueLu()));
               },
               {mueLuList()});
}

void registerIfpack2(Registry<Preconditioner>& registry)
{
  ListSpec list;
  list.name = "Ifpack2";
  list.doc = "Parameters of the Ifpack2 method, e.g. \"fact: iluk level-of-fill\".";
  list.passThrough = [](const Teuchos::ParameterList& given) {
    return mistakesIn(given, krylovLibrary().validIfpack2(), "Ifpack2", {});
  };
  registry.add("Ifpack2", "Incomplete factorisation, relaxation or polynomial of each rank's own rows; little memory.",
               {{"Method", "RILUK", oneOf({"RILUK", "RELAXATION", "CHEBYSHEV"}), "Ifpack2's name of the method."}},
               [](const Params& params) {
                 const KrylovLibrary& library = krylovLibrary();
                 return library.ifpack2(params.get<std::string>("Method"),
                                        conformed(params.sub("Ifpack2").teuchos(), library.validIfpack2()));
               },
               {list});
}

} // namespace

ListSpec mueLuList()
{
  ListSpec list;
  list.name = "MueLu";
  list.doc = "Parameters of MueLu's own list, e.g. \"aggregation: drop tol\".";
  list.passThrough = [](const Teuchos::ParameterList& given) {
    return mistakesIn(given, krylovLibrary().validMueLu(), "MueLu",
                      {"number of equations", "user data", "Nullspace", "Coordinates"});
  };
  return list;
}

std::unique_ptr<Preconditioner> makeVertexMueLu(const Teuchos::ParameterList& given)
{
  const KrylovLibrary& library = krylovLibrary();
  Teuchos::ParameterList list = conformed(given, library.validMueLu());
  if (!list.isParameter("smoother: type")) {
    list.set("smoother: type", "CHEBYSHEV");
    list.sublist("smoother: params").set("chebyshev: degree", 4);
    list.sublist("smoother: params").set("chebyshev: boost factor", 1.5);
  }
  return library.mueLu(list);
}

Registry<Preconditioner> preconditioners()
{
  Registry<Preconditioner> registry("preconditioner", "MueLu");
  registerMueLu(registry);
  registerIfpack2(registry);
  return registry;
}

} // namespace ndframe
