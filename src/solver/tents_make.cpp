#include "solver/tents.hpp"

namespace cleave::solver {
namespace {

using namespace discretisation::spacetime;

template <int D>
std::unique_ptr<Solver> make(const discretisation::World& world, const Options& options,
                             deck::Diagnostics& diagnostics) {
  auto body = make_body<D>(*world.model, diagnostics);
  if (!body) return nullptr;
  return make_tents<D>(world, std::move(body), options);
}

}  // namespace

std::unique_ptr<Solver> make_tents(const discretisation::World& world, const Options& options,
                                   deck::Diagnostics& diagnostics) {
  switch (dimension_of(*world.model)) {
    case 1:
      return make<1>(world, options, diagnostics);
    case 2:
      return make<2>(world, options, diagnostics);
    default:
      return make<3>(world, options, diagnostics);
  }
}

}  // namespace cleave::solver
