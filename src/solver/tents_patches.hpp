#pragma once
/// Solves patches on any number of threads, checks them, and puts them above their simplices.

#include <mutex>

#include "discretisation/spacetime/exchange.hpp"
#include "discretisation/spacetime/scheduler.hpp"
#include "discretisation/spacetime/verify.hpp"

namespace cleave::solver {

/// What many patches came to; the same for any number of threads but for the seconds.
struct Tally {
  std::int64_t patches = 0, elements = 0, unknowns = 0;
  double worst_momentum = 0.0, worst_energy = 0.0;  ///< relative residuals, where patches are verified
  double solving = 0.0, checking = 0.0;             ///< [s] of one thread

  void add(const Tally& other);
};

template <int D>
class PatchRunner {
 public:
  using Patch = discretisation::spacetime::Patch<D>;
  using Verdict = discretisation::spacetime::Verdict;

  /// All must outlive it.
  PatchRunner(const discretisation::spacetime::Body<D>& body,
              const discretisation::spacetime::Outside<D>& outside,
              discretisation::spacetime::Columns<D>& columns)
      : body_(body), outside_(outside), columns_(columns) {}

  /// Any thread. Accepted patches are in the columns afterwards, with what they exchanged.
  /// @param patches  that share no simplex @param verdicts [patches]
  /// @param verified  hold them to their balances: a patch that breaks one fails
  void solve(std::span<const Patch> patches, std::span<Verdict> verdicts, bool verified);

  /// What was solved since it was asked last. No patch may be in flight.
  Tally take();

 private:
  using Solution = discretisation::spacetime::Solution<D>;
  /// Scratch of one thread while it solves patches.
  struct Worker {
    discretisation::spacetime::PatchSolver<D> solver;
    std::vector<std::vector<const Solution*>> older;  ///< [patch][facet]
    std::vector<std::vector<Solution>> solution;      ///< [patch][element], and some without
    std::vector<discretisation::spacetime::PatchJob<D>> jobs;
    discretisation::spacetime::Verify verify;
    Tally tally;
    explicit Worker(const discretisation::spacetime::Problem<D>& problem) : solver(problem) {}
  };

  void commit(const Patch& patch, Worker& worker, std::span<Solution> solution, bool verified);
  Verdict check(const Patch& patch, Worker& worker, std::span<const Solution* const> older,
                std::span<const Solution> solution) const;
  Verdict broken(const Patch& patch, std::string what, double value, double limit) const;
  Worker* take_worker();
  void give_worker(Worker* worker);

  const discretisation::spacetime::Body<D>& body_;
  const discretisation::spacetime::Outside<D>& outside_;
  discretisation::spacetime::Columns<D>& columns_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<Worker*> idle_;
};

}  // namespace cleave::solver
