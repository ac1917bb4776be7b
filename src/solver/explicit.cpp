/// Explicit central differences in half-step form. Theory: docs/solver/explicit.md.
///
///   a_n = f(x_n, v_n-1/2) / m,  v_n+1/2 = v_n-1/2 + a_n (dt_n-1 + dt_n) / 2,  x_n+1 = x_n + v_n+1/2 dt_n
///
/// A whole cycle ends with a_n and dt_n known, so a copy of the State there is all a restart needs.

#include <algorithm>
#include <cmath>

#include "base/assert.hpp"
#include "solver/action.hpp"
#include "solver/erosion.hpp"
#include "solver/interaction.hpp"
#include "solver/nodal.hpp"
#include "solver/ordered_sum.hpp"
#include "solver/step_size.hpp"
#include "solver/stopwatch.hpp"
#include "solver/termination.hpp"

namespace cleave::solver {
namespace {

using discretisation::State;
using discretisation::StepOutput;
using discretisation::StepStatus;

/// Position of a memory in the State, made by `first` if it is not there yet.
template <class First>
std::size_t remember(State& state, const std::string& name, const First& first) {
  for (std::size_t m = 0; m < state.memory.size(); ++m)
    if (state.memory[m].name == name) return m;
  state.memory.push_back({name, first()});
  return state.memory.size() - 1;
}

constexpr double contact_growth =
    0.1;  // energy from a contact, of all that ever came in: it is wrong by then

class Explicit final : public Solver, private ContactSource {
 public:
  Explicit(const discretisation::World& world, const Options& options, deck::Diagnostics& diagnostics)
      : world_(world),
        model_(*world.model),
        options_(options),
        loads_(make_loads(model_)),
        constraints_(make_constraints(world, diagnostics)),
        interactions_(make_interactions(world, diagnostics)),
        scaling_(world),
        nodal_(world.node_count()),
        internal_(world.node_count()) {
    for (const auto& load : loads_) {
      const std::vector<Index> nodes = load->nodes();
      loaded_.insert(loaded_.end(), nodes.begin(), nodes.end());
    }
    std::sort(loaded_.begin(), loaded_.end());
    loaded_.erase(std::unique(loaded_.begin(), loaded_.end()), loaded_.end());
    if (!loaded_.empty()) external_.resize(3 * world.node_count());
    held_.resize(3 * world.node_count());
    reactions_ = {held_, std::vector<WallForce>(model_.walls.size()),
                  std::vector<BodyMotion>(world.bodies.size())};
    interfaces_.resize(model_.contacts.size());
    if (!interactions_.empty()) contact_force_.resize(3 * world.node_count());
  }

  Outcome advance(State& state, std::span<Observer* const> observers, Wishes& wishes) override {
    watch_ = Stopwatch();
    StepStatus status = prepare(state);
    for (Observer* observer : observers) observer->begin(frame(state));
    watch_.lap(Phase::output);
    std::optional<Ending> ending = reason_to_end(model_, state, options_, wishes);
    while (status.ok && !ending) {
      move(state);
      status = evaluate(state);
      if (!status.ok) break;
      for (Observer* observer : observers) observer->after_step(frame(state));
      watch_.lap(Phase::output);
      ending = reason_to_end(model_, state, options_, wishes);
    }
    const Ending end = status.ok ? *ending : Ending::physics;
    for (Observer* observer : observers) observer->finish(frame(state), end, status);
    watch_.lap(Phase::output);
    return {end, status, watch_.total(), element_cycles_, watch_.phases()};
  }

 private:
  /// Running numbers of the loop that must survive a restart.
  enum Number : std::size_t {
    external_after,
    damping_after,
    wall_after,
    gross_work,
    contact_step,
    step_element,
    first_stable,
    number_count
  };

  /// Everything at t = 0, or what a restarted state does not carry because it follows from what it does.
  StepStatus prepare(State& state) {
    const std::size_t count = 3 * world_.node_count();
    const bool fresh = std::none_of(state.memory.begin(), state.memory.end(),
                                    [](const auto& memory) { return memory.name == "acceleration"; });
    acceleration_ = remember(state, "acceleration", [&] { return base::Array<double>(count); });
    numbers_ = remember(state, "explicit", [&] { return base::Array<double>(number_count); });
    constraint_memory_.clear();
    for (const auto& constraint : constraints_)
      constraint_memory_.push_back(
          remember(state, constraint->name(), [&] { return constraint->first_memory(state); }));
    interaction_memory_.clear();
    for (const auto& interaction : interactions_) {
      interaction_memory_.push_back(
          remember(state, interaction->name(), [&] { return interaction->first_memory(); }));
      interaction->start(state);
    }
    factor_memory_.clear();
    if (scaling_.active())
      for (std::size_t b = 0; b < world_.blocks.size(); ++b)
        factor_memory_.push_back(
            remember(state, "mass factor " + std::to_string(b), [&] { return scaling_.first_memory(b); }));
    CLEAVE_ASSERT(state.memory[acceleration_].values.size() == count, "the state belongs to another model");

    erosion_.emplace(world_, state);
    element_cycles_ = 0.0;
    state.parts.resize(model_.parts.size());
    if (fresh) return evaluate(state);
    nodal_.settle_all(state, acceleration(state));
    for (std::size_t c = 0; c < constraints_.size(); ++c)
      constraints_[c]->report(state.memory[constraint_memory_[c]].values, reactions_);
    for (std::size_t i = 0; i < interactions_.size(); ++i)
      interfaces_[interactions_[i]->contact()] =
          interactions_[i]->report(state.memory[interaction_memory_[i]].values);
    return {};
  }

  /// From t_n to t_n+1.
  void move(State& state) {
    Nodal::move(state, acceleration(state));
    state.time += state.next_step;
    state.step = state.next_step;
    ++state.cycle;
    element_cycles_ += erosion_->active_count();
    watch_.lap(Phase::update);
  }

  /// Everything at t_n that follows from the positions there: forces, next step, acceleration, energies.
  StepStatus evaluate(State& state) {
    StepOutput output = add_internal_forces(state);
    watch_.lap(Phase::elements);
    if (!output.status.ok) return output.status;
    const bool start = state.cycle == 0;
    erosion_->remove(eroded_, state);
    StableStep stable{output.stable_step, output.stable_element};
    if (start) number(state, first_stable) = stable.step;
    if (scaling_.active()) scaling_.apply(state, factors(state), start, number(state, first_stable), stable);
    state.next_step = choose_step(model_, state, or_rigid(stable));
    for (std::size_t c = 0; c < constraints_.size(); ++c)
      state.next_step = std::min(state.next_step,
                                 constraints_[c]->largest_step(state.memory[constraint_memory_[c]].values));
    if (const StepStatus status = add_contact(state, stable); !status.ok) return status;
    state.largest_force = internal_.largest();
    if (start) state.first_step = state.next_step;
    number(state, step_element) = static_cast<double>(stable.element);

    const Moment now{state.time,     state.step, state.next_step,    state.position,
                     state.velocity, state.mass, acceleration(state)};
    watch_.lap(Phase::update);
    add_loads(now);
    watch_.lap(Phase::loads);
    const std::span<double> a = acceleration(state);
    nodal_.accelerate(state, internal_, external_, a);
    watch_.lap(Phase::update);
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      base::Array<double>& memory = state.memory[constraint_memory_[c]].values;
      constraints_[c]->correct(now, memory, a);
      constraints_[c]->report(memory, reactions_);
      nodal_.corrected(constraints_[c]->corrected());
    }
    watch_.lap(Phase::loads);
    nodal_.settle(state, a);
    watch_.lap(Phase::update);
    const StepStatus contact = report_contact(state, now, a);
    watch_.lap(Phase::contact);
    balance_energies(state, now, output);
    watch_.lap(Phase::update);
    if (!contact.ok) return contact;
    return check_health(world_, state, number(state, gross_work), stable.element, a);
  }

  /// Where nothing deforms: the step the rigid elements would have if they did.
  StableStep or_rigid(const StableStep& stable) const {
    return stable.step < 1.0e29 ? stable : StableStep{world_.rigid_step, stable.element};
  }

  /// Visits every block once; collects energies of the parts and the elements deleted.
  StepOutput add_internal_forces(State& state) {
    internal_.begin(state.largest_force);
    eroded_.clear();
    for (auto& part : state.parts) part.internal = part.hourglass = 0.0;
    discretisation::StepInput input{state.time, state.step, state.position.data(), state.velocity.data(),
                                    0.0};
    // A scaled element is not small: mass scaling and deletion by step exclude each other.
    if (model_.control.step.erode && !scaling_.active())
      input.erosion_step = least_step(model_, state) / model_.control.step.safety;

    StepOutput all;
    for (std::size_t b = 0; b < world_.blocks.size(); ++b) {
      const StepOutput one = world_.blocks[b]->add_force(input, state.blocks[b], internal_);
      if (!one.status.ok) all.status.merge(one.status);
      if (one.stable_step < all.stable_step ||
          (one.stable_step == all.stable_step && one.stable_element < all.stable_element)) {
        all.stable_step = one.stable_step;
        all.stable_element = one.stable_element;
      }
      all.internal_energy += one.internal_energy;
      all.hourglass_energy += one.hourglass_energy;
      all.eroded_internal += one.eroded_internal;
      all.eroded_hourglass += one.eroded_hourglass;
      all.damping_work += one.damping_work;
      eroded_.insert(eroded_.end(), one.eroded.begin(), one.eroded.end());
      auto& part = state.parts[static_cast<std::size_t>(world_.blocks[b]->part())];
      part.internal += one.internal_energy;
      part.hourglass += one.hourglass_energy;
      part.eroded_internal += one.eroded_internal;
      part.eroded_hourglass += one.eroded_hourglass;
    }
    std::sort(eroded_.begin(), eroded_.end());
    return all;
  }

  /// Forces between surfaces join those of the elements. Their springs may ask for a smaller step.
  StepStatus add_contact(State& state, const StableStep& stable) {
    if (interactions_.empty()) return {};
    watch_.lap(Phase::update);
    const Moment now{state.time, state.step, state.next_step, state.position, state.velocity, state.mass};
    StepStatus status;
    double rate = 0.0, damping = 0.0;
    for (const auto& interaction : interactions_) interaction->clear_nodal(contact_force_);
    for (std::size_t i = 0; i < interactions_.size(); ++i) {
      const ContactOutput output =
          interactions_[i]->add_force(now, eroded_, state.memory[interaction_memory_[i]].values, internal_);
      if (status.ok && !output.status.ok) status = output.status;
      rate += output.stiffness_rate;
      damping = std::max(damping, output.damping);
    }
    state.next_step = limit_step(state.next_step, stable.step, rate, damping, number(state, contact_step));
    watch_.lap(Phase::contact);
    return status;
  }

  /// What contact is doing, for the observers. Fails where it has created energy.
  StepStatus report_contact(State& state, const Moment& now, std::span<const double> a) {
    StepStatus status;
    if (interactions_.empty()) return status;
    const double in = std::abs(state.energy.initial) + number(state, gross_work);
    double sliding = 0.0;
    for (std::size_t i = 0; i < interactions_.size(); ++i) {
      base::Array<double>& memory = state.memory[interaction_memory_[i]].values;
      interactions_[i]->settle(now, memory, a);
      interactions_[i]->add_nodal(contact_force_);
      interfaces_[interactions_[i]->contact()] = interactions_[i]->report(memory);
      const double taken = interfaces_[interactions_[i]->contact()].energy();
      sliding += taken;
      if (status.ok && in > 0.0 && -taken > contact_growth * in)
        status = interactions_[i]->accuse(
            now, "created more than a tenth of all energy there is",
            "bodies go into each other too far in one step: lower TSSFAC, SFSA and SFSB, or refine the mesh");
    }
    if (model_.control.energy.sliding) state.energy.sliding = sliding;
    return status;
  }

  void add_loads(const Moment& now) {
    if (loads_.empty()) return;
    base::for_each_range(loaded_.size(), 4096, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        double* force = &external_[3 * static_cast<std::size_t>(loaded_[k])];
        force[0] = force[1] = force[2] = 0.0;
      }
    });
    for (const auto& load : loads_) load->add_force(now, external_);
  }

  /// Work of the loads by the trapezoidal rule: half of f_n with the displacement of each step beside it.
  Halves work_of_loads(const Moment& now, std::span<const double> a) const {
    return ordered_sum<Halves>(loaded_.size(), 1024, [&](std::size_t begin, std::size_t end) {
      Halves sum;
      for (std::size_t k = begin; k < end; ++k)
        for (std::size_t i = 0; i < 3; ++i) {
          const std::size_t at = 3 * static_cast<std::size_t>(loaded_[k]) + i;
          const double early = now.velocity[at], late = early + a[at] * now.interval();
          sum.before.external += 0.5 * now.step_before * external_[at] * early;
          sum.after.external += 0.5 * now.step * external_[at] * late;
        }
      return sum;
    });
  }

  /// The energy table at t_n. Work done after t_n waits in the numbers until the next cycle.
  void balance_energies(State& state, const Moment& now, const StepOutput& output) {
    const model::EnergyControl& control = model_.control.energy;
    discretisation::Energy& energy = state.energy;
    energy.eroded_internal += output.eroded_internal;
    energy.internal = output.internal_energy + energy.eroded_internal;
    if (control.hourglass) {
      energy.eroded_hourglass += output.eroded_hourglass;
      energy.hourglass = output.hourglass_energy + energy.eroded_hourglass;
    }
    energy.kinetic = nodal_.kinetic() + energy.eroded_kinetic;

    const std::span<const double> a = acceleration(state);
    for (std::size_t c = 0; c < constraints_.size(); ++c)
      energy.kinetic += constraints_[c]->kinetic(now, state.memory[constraint_memory_[c]].values, a);
    Halves work = work_of_loads(now, a);
    double gross = std::abs(work.before.external) + std::abs(work.after.external);
    for (std::size_t c = 0; c < constraints_.size(); ++c) {
      const Halves one = constraints_[c]->work(now, state.memory[constraint_memory_[c]].values, a);
      gross += std::abs(one.before.external) + std::abs(one.after.external);
      work += one;
    }
    number(state, gross_work) += gross;
    energy.external += number(state, external_after) + work.before.external;
    if (control.damping)
      energy.damping += number(state, damping_after) + work.before.damping + output.damping_work;
    if (control.wall) energy.wall += number(state, wall_after) + work.before.wall;
    number(state, external_after) = work.after.external;
    number(state, damping_after) = work.after.damping;
    number(state, wall_after) = work.after.wall;
    if (state.cycle == 0) energy.initial = energy.total() - energy.external;
  }

  Frame frame(const State& state) {
    shown_ = &state;
    return {model_,
            world_,
            state,
            state.memory[acceleration_].values,
            {state.velocity, state.memory[acceleration_].values, 0.5 * state.step},
            held_,
            reactions_.walls,
            static_cast<model::Id>(state.memory[numbers_].values[step_element]),
            eroded_,
            {},
            nullptr,
            {},
            {},
            interfaces_,
            contact_force_,
            reactions_.bodies,
            interactions_.empty() ? nullptr : this};
  }

  ContactFields contact_fields() const override {
    constexpr double unknown = 1e300;
    const State& state = *shown_;
    ContactFields fields{std::vector<double>(world_.node_count(), 0.0),
                         std::vector<double>(world_.node_count(), unknown)};
    const Moment now{state.time, state.step, state.next_step, state.position, state.velocity, state.mass};
    for (const auto& interaction : interactions_) interaction->add_fields(now, fields);
    double widest = 0.0;
    for (const double gap : fields.gap)
      if (gap < unknown) widest = std::max(widest, gap);
    for (double& gap : fields.gap) gap = std::min(gap, widest);
    return fields;
  }

  std::span<double> acceleration(State& state) const { return state.memory[acceleration_].values; }
  double& number(State& state, Number which) const { return state.memory[numbers_].values[which]; }
  std::vector<base::Array<double>*> factors(State& state) const {
    std::vector<base::Array<double>*> all;
    for (const std::size_t m : factor_memory_) all.push_back(&state.memory[m].values);
    return all;
  }

  const discretisation::World& world_;
  const model::Model& model_;
  Options options_;
  std::vector<std::unique_ptr<Load>> loads_;
  std::vector<std::unique_ptr<Constraint>> constraints_;
  std::vector<std::unique_ptr<Interaction>> interactions_;
  MassScaling scaling_;
  std::optional<Erosion> erosion_;
  Nodal nodal_;
  discretisation::ForceSum internal_;

  std::vector<Index> loaded_;     // nodes of all loads, ascending
  base::Array<double> external_;  // [node][3] loads; empty without loads
  base::Array<double> held_;      // [node][3] forces that hold nodes
  Reactions reactions_;
  std::vector<InterfaceForce> interfaces_;
  base::Array<double> contact_force_;           // [node][3]; empty without contact
  std::vector<model::Id> eroded_;               // in this step
  std::size_t acceleration_ = 0, numbers_ = 0;  // places in the state's memory
  std::vector<std::size_t> constraint_memory_, interaction_memory_, factor_memory_;
  double element_cycles_ = 0.0;
  const State* shown_ = nullptr;  // of the last frame
  Stopwatch watch_;
};

}  // namespace

std::unique_ptr<Solver> make_explicit(const discretisation::World& world, const Options& options,
                                      deck::Diagnostics& diagnostics) {
  return std::make_unique<Explicit>(world, options, diagnostics);
}

}  // namespace cleave::solver
