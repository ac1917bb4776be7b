#pragma once
/// All that geometry and materials decide about a linear patch: maps from the data below and beside it to its
/// unknowns. Patches of equal tents share one; applying it costs a fraction of making it.
///
/// Every patch that may share an operator is solved through one, made for it or found, and an operator is
/// made from the shape of the tent alone. So the bits of a solution do not depend on which patches came
/// before.

#include <unordered_map>

#include "discretisation/spacetime/space.hpp"
#include "discretisation/spacetime/target.hpp"

namespace cleave::discretisation::spacetime {

/// Waves through a facet between a part of a patch and the rest.
struct OpenFacet {
  int wave = -1;            ///< that goes out; wave ^ 1 comes in
  int row = 0, column = 0;  ///< its place among the waves out, and that of the wave that comes in
  int out = 0, in = 0;      ///< their numbers
};

/// Tables are transposed, [inputs][outputs]: a product adds rows, with no sum across lanes.
template <int D>
struct PatchOperator {
  static constexpr int NU = state_count<D>;
  struct Element {
    ElementSpace<D> space;
    Matrix<NU> flux{};  ///< - A_N of the inflow facet, for velocity and strain as they are
    int modes = 0;      ///< on it
    int waves_in = 0, waves_out = 0;
    /// [waves in, data][unknowns]; three fields: [coefficients], those of a Solution, fields before
    /// displacement
    Block respond;
    Block emit;  ///< [data][waves out]
    /// One field: [unknowns][coefficients]. Trefftz: [monomials][polynomials], no polynomial of a higher
    /// degree than the monomial.
    Block restore;
    /// [components, modes][components, polynomials]: what the older displacement on the inflow facet adds;
    /// but with three fields its difference to the restored one.
    Block carry;
    int carried = 0, carried_to = 0;  ///< modes and polynomials of a component
    std::vector<OpenFacet> open;
    std::vector<int> boundary;  ///< its facets with data, after the inflow
  };
  /// A piece of the waves out of a part, and where the join puts it.
  struct Move {
    int from = 0, to = 0, count = 0;
    bool shared = false;
  };
  struct Join {
    int first = -1, second = -1;
    int first_shared = 0, second_shared = 0, first_rest = 0, out = 0, in = 0;
    std::vector<Move> of_first, of_second;
    Block solve;            ///< [waves shared of the first, of the second][of the first]
    Block second_on_first;  ///< S2 of the shared waves
    Block first_rest_on_second, second_rest_on_first;
    Block from_first, from_second;  ///< [waves in][shared]
    std::vector<OpenFacet> open, shared;
  };
  Patch<D> patch;  ///< seen from its foot
  std::vector<Element> elements;
  std::vector<Join> joins;
  std::vector<StarMap<D>> maps;  ///< of the boundary facets, in their order
  int link_count = 0, unknowns = 0;
  double flops = 0.0;  ///< of one application
  Arena memory;
};

/// Operators by the numbers that decide them. Holds a bounded amount: what was not used for long is dropped.
template <int D>
class OperatorStore {
 public:
  using Key = std::vector<std::uint64_t>;
  using List = std::vector<std::unique_ptr<PatchOperator<D>>>;

  /// Those with the key, null if there are none.
  List* find(const Key& key);
  /// @param limit  of what is kept [doubles]
  const PatchOperator<D>* add(const Key& key, std::unique_ptr<PatchOperator<D>> op, std::size_t limit);

  std::int64_t found() const { return found_; }
  void count_found() { ++found_; }

 private:
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  using Map = std::unordered_map<Key, List, Hash>;
  Map young_, old_;  ///< used since the last time the young became too many; the others
  std::size_t size_ = 0;
  std::int64_t found_ = 0;
};

}  // namespace cleave::discretisation::spacetime
