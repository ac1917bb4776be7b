/// Spacetime discontinuous Galerkin on tents: from a body to outputs. Theory: docs/solver/tents.md.
///
/// The front never waits to be level. It pauses where all of it has passed an instant of output (or a few
/// that lie close together), and the solution is cut there at constant time. What the State holds between two
/// pauses is the cut written last; the front and the solution under it go into State::memory when the State
/// is saved.

#include "solver/tents.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/assert.hpp"
#include "base/threads.hpp"
#include "solver/tents_album.hpp"
#include "solver/tents_cells.hpp"
#include "solver/tents_crack.hpp"
#include "solver/tents_elements.hpp"
#include "solver/tents_instants.hpp"
#include "solver/tents_patches.hpp"
#include "solver/tents_state.hpp"
#include "solver/tents_tips.hpp"
#include "solver/termination.hpp"

namespace cleave::solver {
namespace {

using namespace discretisation::spacetime;
using discretisation::State;
using discretisation::StepStatus;
using Clock = std::chrono::steady_clock;

constexpr int patches_together = 64;        ///< where tents repeat: some lanes full of equal ones
constexpr double volume_tolerance = 1e-11;  ///< of body times duration
const char* const memory_name = "spacetime";

double seconds(Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

template <int D>
class Tents final : public Solver, private CellSource {
 public:
  Tents(const discretisation::World& world, std::unique_ptr<const Body<D>> body, const Options& options)
      : world_(world),
        model_(*world.model),
        body_(std::move(body)),
        options_(options),
        pitcher_(body_->mesh, body_->pitch),
        instants_(output_instants(model_, body_->end_time)),
        energies_due_(energy_instants(model_, instants_)),
        pauses_(pauses(instants_, wave_time())),
        outside_(*body_),
        columns_(*body_, instants_),
        patches_(*body_, outside_, columns_),
        filler_(model_, *body_, outside_),
        cracks_(model_, *body_),
        tips_(model_, *body_),
        probes_(model_, *body_),
        album_(options.tents),
        verify_(body_->verify) {}

  Outcome advance(State& state, std::span<Observer* const> observers, Wishes& wishes) override {
    lap_ = Clock::now();
    StepStatus status = prepare(state);
    for (Observer* observer : observers) observer->begin(frame(state));
    book(output_);
    std::optional<Ending> ending = reason_to_end(model_, state, options_, wishes);
    while (status.ok && !ending) {
      const FrontStatus moved = move(wishes);
      if (!moved.ok) {
        status = failure(moved);
        break;
      }
      status = write_instants(state, observers, wishes, ending);
      // Stopped in between: the state stays at the instant written last.
      if (!ending && wishes.stop.load(std::memory_order_acquire))
        ending = reason_to_end(model_, state, options_, wishes);
    }
    const Ending end = status.ok ? *ending : Ending::physics;
    for (Observer* observer : observers) observer->finish(frame(state), end, status);
    book(output_);
    return outcome(end, status);
  }

  CellFields cells() const override {
    const int wanted = model_.control.spacetime.subdivision;
    int degree = 1;
    for (const SpaceChoice& choice : body_->problem.spaces) degree = std::max(degree, field_degree(choice));
    return cells_at<D>(model_, *body_, Instant<D>(*body_, columns_, time_), wanted > 0 ? wanted : degree);
  }

  CellFields tents() const override {
    double fastest = 0.0;
    for (const Elastic<D>& material : body_->problem.materials) fastest = std::max(fastest, material.fastest);
    CellFields cells = album_.cells(fastest, body_->element_of_simplex);
    for (discretisation::Id& part : cells.part) part = model_.parts[static_cast<std::size_t>(part)].id;
    return cells;
  }

  std::vector<ElementStress> stresses() const override {
    return probes_.at(Instant<D>(*body_, columns_, time_));
  }

 private:
  /// A few times what a wave needs across a simplex: pauses closer than this would leave threads idle [time].
  double wave_time() const {
    double sum = 0.0;
    for (Simplex s = 0; s < body_->mesh.simplex_count(); ++s) {
      const auto& corner = body_->mesh.simplex(s);
      sum += distance(body_->mesh.position()[static_cast<std::size_t>(corner[0])],
                      body_->mesh.position()[static_cast<std::size_t>(corner[1])]) /
             body_->mesh.speed(s).fastest;
    }
    return 2.0 * sum / body_->mesh.simplex_count();
  }

  /// The initial state, or the one a restarted state carries.
  StepStatus prepare(State& state) {
    const auto saved = std::find_if(state.memory.begin(), state.memory.end(),
                                    [](const auto& memory) { return memory.name == memory_name; });
    if (saved == state.memory.end()) {
      front_ = pitcher_.level_front(0.0);
      written_ = 0;
      time_ = 0.0;
      filler_.start(state);
    } else if (!load(saved->values)) {
      return {false, -1, 0, "the restart file holds another spacetime mesh", "was the deck changed?"};
    } else {
      saved->values = {};  // saved anew when it is wanted
    }
    time_ = state.time;
    fill(state, saved != state.memory.end());
    evaluate(state, everything);
    return {};
  }

  /// Solves tents until all of the front has passed the next pause, or a wish stops it.
  FrontStatus move(const Wishes& wishes) {
    FrontStatus moved;
    const std::size_t group = *std::lower_bound(pauses_.begin(), pauses_.end(), written_);
    if (passed(instants_[group])) return moved;
    Scheduler<D> scheduler(pitcher_,
                           {.verify = verify_, .together = pitcher_.repeats() ? patches_together : 1});
    moved = scheduler.advance_several(
        front_, body_->end_time,
        [this](std::span<const Patch<D>> patches, std::span<Verdict> verdicts) { solve(patches, verdicts); },
        nullptr, {.at = instants_[group], .stop = &wishes.stop});
    tally_.add(patches_.take());
    slowed_ += static_cast<std::int64_t>(moved.slowed.size());
    book(front_seconds_);
    return moved;
  }

  bool passed(double instant) const {
    return std::all_of(front_.time.begin(), front_.time.end(), [&](double t) { return t >= instant; });
  }

  /// Fills the state at each instant the front has passed and shows it.
  StepStatus write_instants(State& state, std::span<Observer* const> observers, Wishes& wishes,
                            std::optional<Ending>& ending) {
    const double reached = *std::min_element(front_.time.begin(), front_.time.end());
    while (!ending && written_ < instants_.size() && instants_[written_] <= reached) {
      time_ = instants_[written_];
      state.step = time_ - state.time;
      state.time = time_;
      ++state.cycle;
      ++written_;
      fill(state, false);
      for (Observer* observer : observers) observer->after_step(frame(state));
      book(output_);
      ending = reason_to_end(model_, state, options_, wishes);
      // What is done before the front moves on, or the run ends, can no longer be told from what comes after.
      if (ending || written_ == instants_.size() || instants_[written_] > reached)
        evaluate(state, everything);
      columns_.written(written_);
      book(cutting_);
      if (energies_due() && !std::isfinite(state.energy.kinetic + state.energy.internal))
        return {false, -1, 0, "the energy of the body is not a finite number",
                "loads or motions beyond the range of numbers: look at their curves and factors"};
      if (const double excess = filler_.volume_error(exchanged_at_); verify_ && !(excess <= volume_tolerance))
        return {false, -1, 0,
                "the volumes of the tents do not add up to body times time: relative error " +
                    std::to_string(excess),
                "an error of the program; please report it with the deck"};
    }
    return {};
  }

  /// What every observer may read unasked. The state says the rest of the instant before until evaluate().
  void fill(State& state, bool resumed) {
    const Instant<D> instant(*body_, columns_, time_);
    have_ = 0;
    filler_.fill_nodes(state, instant, false);
    cracks_.fill(instant);
    tips_.fill(instant);
    if (resumed) {
      filler_.fill_energies(state, instant, true);
      list_facts(state);
      have_ = energies;
    }
    book(cutting_);
    // A run that may be ended by its energies looks at them always.
    if (energies_due() || model_.control.end.energy_change > 0.0) evaluate(state, energies);
  }
  bool energies_due() const { return written_ == 0 || energies_due_[written_ - 1]; }

  void evaluate(State& state, unsigned wanted) {
    wanted &= ~have_;
    if (wanted == 0) return;
    have_ |= wanted;
    book(output_);
    const Instant<D> instant(*body_, columns_, time_);
    if (wanted & every_node) filler_.fill_nodes(state, instant, true);
    if (wanted & reactions) filler_.fill_reactions(instant);
    if (wanted & energies) {
      filler_.fill_energies(state, instant, false);
      list_facts(state);
    }
    book(cutting_);
  }

  void list_facts(const State& state) {
    const Exchange<D>& exchanged = filler_.exchanged();
    const double scale = body_->thickness;
    exchanged_at_ = time_;
    facts_.clear();
    const auto fact = [&](const char* name, double value) { facts_.push_back({name, value}); };
    const auto& energy = state.energy;
    fact("patches", static_cast<double>(tally_.patches));
    fact("elements", static_cast<double>(tally_.elements));
    fact("kinetic_energy", energy.kinetic);
    fact("strain_energy", energy.internal);
    fact("boundary_work", scale * exchanged.boundary_work);
    fact("body_work", scale * exchanged.body_work);
    fact("dissipation", energy.initial + energy.external - energy.kinetic - energy.internal);
    if (verify_) fact("dissipation_of_jumps", scale * exchanged.dissipation);
    static constexpr const char *momentum[] = {"x_momentum", "y_momentum", "z_momentum"},
                                *impulse[] = {"x_impulse", "y_impulse", "z_impulse"};
    for (std::size_t i = 0; i < D; ++i) fact(momentum[i], filler_.momentum()[i]);
    for (std::size_t i = 0; i < D; ++i) fact(impulse[i], scale * exchanged.impulse[i]);
    if (verify_) {
      fact("worst_momentum_residual", tally_.worst_momentum);
      fact("worst_energy_residual", tally_.worst_energy);
      fact("volume_error", filler_.volume_error(time_));
    }
  }

  void solve(std::span<const Patch<D>> patches, std::span<Verdict> verdicts) {
    patches_.solve(patches, verdicts, verify_);
    for (std::size_t k = 0; k < patches.size(); ++k)
      if (verdicts[k].kind == Verdict::accept) album_.add(pitcher_.key(front_, patches[k].pole), patches[k]);
  }

  StepStatus failure(const FrontStatus& moved) const {
    const auto v = static_cast<std::size_t>(moved.vertex);
    const Simplex s = body_->mesh.star(moved.vertex)[0];
    char where[160];
    std::snprintf(
        where, sizeof where, "at node %lld, time %.9g (it should rise by at least %.3g): ",
        static_cast<long long>(model_.mesh.nodes.id[static_cast<std::size_t>(body_->node_of_vertex[v])]),
        moved.time, moved.bound);
    return {false, body_->mesh.material(s), body_->element_of_simplex[static_cast<std::size_t>(s)],
            where + moved.what,
            "the front and the solution below it are in the restart file; *CONTROL_SPACETIME EPS and CHI "
            "change the tents"};
  }

  /// The front, the columns and the counts as the memory of a state.
  void save(State& state) {
    evaluate(state, everything);
    columns_.written(written_);
    auto entry = std::find_if(state.memory.begin(), state.memory.end(),
                              [](const auto& memory) { return memory.name == memory_name; });
    if (entry == state.memory.end()) entry = state.memory.insert(entry, {memory_name, {}});
    base::Array<double>& values = entry->values;
    values.clear();
    values.insert(values.end(), {static_cast<double>(D), static_cast<double>(front_.time.size()),
                                 static_cast<double>(front_.budget.size()), static_cast<double>(written_),
                                 static_cast<double>(tally_.patches), static_cast<double>(tally_.elements),
                                 static_cast<double>(tally_.unknowns), tally_.worst_momentum,
                                 tally_.worst_energy, verify_ ? 1.0 : 0.0});
    for (const Point<D>& x : front_.position) values.insert(values.end(), x.begin(), x.end());
    values.insert(values.end(), front_.time.begin(), front_.time.end());
    for (const Budget& b : front_.budget)
      values.insert(values.end(), {b.step, static_cast<double>(b.newest)});
    const Exchange<D>& x = filler_.exchanged();
    values.insert(values.end(), {x.boundary_work, x.body_work, x.dissipation, x.volume});
    values.insert(values.end(), x.impulse.begin(), x.impulse.end());
    columns_.save(values);
  }
  bool load(std::span<const double> values) {
    constexpr std::size_t head = 10;
    front_ = pitcher_.level_front(0.0);
    const std::size_t vertices = front_.time.size(), budgets = front_.budget.size();
    const std::size_t size = head + (D + 1) * vertices + 2 * budgets + 4 + D;
    if (values.size() < size || values[0] != D || values[1] != static_cast<double>(vertices) ||
        values[2] != static_cast<double>(budgets))
      return false;
    written_ = static_cast<std::size_t>(values[3]);
    tally_.patches = static_cast<std::int64_t>(values[4]);
    tally_.elements = static_cast<std::int64_t>(values[5]);
    tally_.unknowns = static_cast<std::int64_t>(values[6]);
    tally_.worst_momentum = values[7];
    tally_.worst_energy = values[8];
    verify_ = verify_ || values[9] != 0.0;
    std::size_t at = head;
    for (Point<D>& x : front_.position)
      for (double& component : x) component = values[at++];
    for (double& t : front_.time) t = values[at++];
    for (Budget& b : front_.budget) {
      b.step = values[at++];
      b.newest = static_cast<std::uint8_t>(values[at++]);
    }
    Exchange<D> x;
    for (double* number : {&x.boundary_work, &x.body_work, &x.dissipation, &x.volume}) *number = values[at++];
    for (double& component : x.impulse) component = values[at++];
    filler_.resume(x);
    return columns_.load(values.subspan(size));
  }

  Frame frame(State& state) {
    return {.model = model_,
            .world = world_,
            .state = state,
            .acceleration = filler_.acceleration(),
            .velocity = {state.velocity, filler_.acceleration(), 0.0},
            .reaction = filler_.reaction(),
            .walls = {},
            .step_element = 0,
            .eroded = {},
            .motion = filler_.motion(),
            .cells = this,
            .facts = facts_,
            .save = [this, &state] { save(state); },
            .cracks = cracks_.openings(),
            .tips = tips_.tips(),
            .evaluate = [this, &state](unsigned wanted) { evaluate(state, wanted); },
            .energies_due = energies_due()};
  }

  void book(double& phase) {
    const auto now = Clock::now();
    phase += seconds(now - lap_);
    lap_ = now;
  }

  Outcome outcome(Ending end, const StepStatus& status) const {
    const double threads = base::thread_count();
    const double solving = tally_.solving / threads, checking = tally_.checking / threads;
    Outcome out{.ending = end,
                .status = status,
                .seconds = front_seconds_ + cutting_ + output_,
                .element_cycles = static_cast<double>(tally_.elements),
                .phases = {{"patches", solving}}};
    if (verify_) out.phases.push_back({"checks", checking});
    out.phases.push_back({"front", std::max(0.0, front_seconds_ - solving - checking)});
    out.phases.push_back({"cuts", cutting_});
    out.phases.push_back({"output", output_});
    out.facts = {{"simplices", static_cast<double>(body_->mesh.simplex_count())},
                 {"patches", static_cast<double>(tally_.patches)},
                 {"patches_per_second", static_cast<double>(tally_.patches) / front_seconds_},
                 {"unknowns_per_second", static_cast<double>(tally_.unknowns) / front_seconds_},
                 {"slow_tents", static_cast<double>(slowed_)}};
    for (const Fact& fact : facts_)
      if (fact.name != "patches") out.facts.push_back(fact);
    return out;
  }

  const discretisation::World& world_;
  const model::Model& model_;
  const std::unique_ptr<const Body<D>> body_;
  const Options options_;
  const Pitcher<D> pitcher_;
  const std::vector<double> instants_;
  const std::vector<char> energies_due_;  ///< [instant]
  const std::vector<std::size_t> pauses_;
  const Outside<D> outside_;

  Front<D> front_;
  Columns<D> columns_;
  PatchRunner<D> patches_;
  StateFiller<D> filler_;
  CrackSides<D> cracks_;
  CrackTips<D> tips_;
  ElementProbes<D> probes_;
  std::size_t written_ = 0;    ///< instants
  double time_ = 0.0;          ///< of the instant written last
  unsigned have_ = 0;          ///< what of it is in the state, bits of Wanted
  double exchanged_at_ = 0.0;  ///< the energies in the state are those of this time [time]
  TentAlbum<D> album_;
  bool verify_;  ///< a run that began with it goes on with it
  Tally tally_;
  std::int64_t slowed_ = 0;
  std::vector<Fact> facts_;

  Clock::time_point lap_;
  double front_seconds_ = 0.0, cutting_ = 0.0, output_ = 0.0;
};

}  // namespace

template <int D>
std::unique_ptr<Solver> make_tents(const discretisation::World& world, std::unique_ptr<const Body<D>> body,
                                   const Options& options) {
  return std::make_unique<Tents<D>>(world, std::move(body), options);
}
template std::unique_ptr<Solver> make_tents<1>(const discretisation::World&, std::unique_ptr<const Body<1>>,
                                               const Options&);
template std::unique_ptr<Solver> make_tents<2>(const discretisation::World&, std::unique_ptr<const Body<2>>,
                                               const Options&);
template std::unique_ptr<Solver> make_tents<3>(const discretisation::World&, std::unique_ptr<const Body<3>>,
                                               const Options&);

}  // namespace cleave::solver
