#pragma once
/// The block of solid elements: one visit per element and step, gather to scatter, for any description of
/// solid_element.hpp.

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"
#include "discretisation/block.hpp"
#include "discretisation/chunk.hpp"
#include "discretisation/fem/node_average.hpp"
#include "discretisation/fem/solid_fields.hpp"
#include "discretisation/fem/solid_kernel.hpp"

namespace cleave::discretisation::fem {

template <class Element>
class SolidBlock final : public Block {
 public:
  static constexpr int nodes = Element::node_count, points = Element::point_count;
  static constexpr bool averaged = AveragesAtNodes<Element>;
  static constexpr int tile_batches = points > 1 ? 1 : 4;  ///< between two calls of the law

  SolidBlock(const PartElements& elements, std::string_view name, Element element, SolidOptions options)
      : name_(name),
        part_(elements.part),
        law_(elements.model.parts[static_cast<std::size_t>(elements.part)].law),
        element_(element),
        options_(options),
        table_(elements) {
    layout_.state_size = law_->state_size();
    failed_needed_ = Lanes(std::min(points, law_->failed_points_needed()));
    element_size_ = ElementLayout{points}.own() + element_.own_size();
  }

  Index part() const override { return part_; }
  model::Shape shape() const override { return Element::shape; }
  std::string_view formulation() const override { return name_; }
  int points_per_element() const override { return points; }
  std::span<const Id> element_ids() const override { return table_.id; }
  std::span<const Index> connectivity() const override { return table_.connectivity; }

  StepStatus initialise(const base::Array<double>& position, BlockState& state) const override {
    state.point.assign(table_.batch_count * points * static_cast<std::size_t>(layout_.size()) * lane_count,
                       0.0);
    state.element.assign(table_.batch_count * static_cast<std::size_t>(element_size_) * lane_count, 0.0);
    state.alive.assign(table_.batch_count * lane_count, 0.0);
    std::fill_n(state.alive.begin(), table_.element_count, 1.0);
    std::vector<double> history(static_cast<std::size_t>(layout_.state_size));
    law_->initialise(history);

    StepStatus status;
    for (std::size_t b = 0; b < table_.batch_count; ++b) {
      Vec3<Lanes> x[nodes];
      gather_global(b, position.data(), x);
      const auto records = records_of(b, state);
      Lanes volume[points], total(0.0);
      element_.reference(x, volume, records.element.from(ElementLayout{points}.own()));
      for (int p = 0; p < points; ++p) {
        total += volume[p];
        records.element.set(ElementLayout::reference_volume + p, volume[p]);
        const auto point = records.point.from(p * layout_.size());
        for (int i = 0; i < layout_.state_size; ++i)
          point.set(PointLayout::state + i, Lanes(history[static_cast<std::size_t>(i)]));
        point.set(layout_.volume_ratio(), Lanes(1.0));
        point.set(layout_.modulus(), Lanes(law_->longitudinal_modulus()));
        for (int lane = 0; lane < lane_count; ++lane)
          if (!(volume[p][lane] > 0.0))
            status.merge(failure(b, lane, "volume is not positive in the initial mesh",
                                 "the node order of the element is wrong, or its shape is folded"));
      }
      Lanes size;
      for (int lane = 0; lane < lane_count; ++lane) size.set(lane, std::cbrt(total[lane]));
      records.element.set(ElementLayout::reference_size, size);
    }
    return status;
  }

  void add_mass(const BlockState& state, std::span<double> mass) const override {
    add_mass(state, mass, [](std::size_t) { return 1.0; });
  }
  void add_scaled_mass(const BlockState& state, std::span<const double> factor,
                       std::span<double> mass) const override {
    add_mass(state, mass, [&](std::size_t e) { return factor[e]; });
  }

  StepOutput add_force(const StepInput& input, BlockState& state, ForceSum& force) const override {
    std::vector<StepOutput> results(table_.chunks.size());
    const ForceScatter<nodes> scatter(table_, force);
    Averages averages(table_);
    if constexpr (averaged)
      volume_visit(
          element_, table_, input, state,
          [&](std::size_t b) { return records_of(b, state).element.get(ElementLayout::reference_volume); },
          averages.volume);
    for_each_grouped_chunk(table_, [&](std::size_t c) {
      thread_local ThreadMemory memory;
      run_chunk(c, input, state, averages, scatter, memory, results[c]);
    });
    scatter.add_shared();
    if constexpr (averaged)
      pressure_visit(element_, table_, input, state, averages.stress, scatter,
                     [&](std::size_t c, std::size_t b, int lane) { report_broken(b, lane, results[c]); });
    return merged(std::move(results));
  }

  void stable_steps(const base::Array<double>& position, const BlockState& state,
                    std::span<double> steps) const override {
    for (std::size_t b = 0; b < table_.batch_count; ++b) {
      Vec3<Lanes> x[nodes], v[nodes];
      gather_global(b, position.data(), x);
      for (auto& at : v) at = {Lanes(0.0), Lanes(0.0), Lanes(0.0)};
      const auto records = records_of(b, const_cast<BlockState&>(state));
      Lanes reference[points], modulus(0.0), ratio(0.0);
      for (int p = 0; p < points; ++p) {
        reference[p] = records.element.get(ElementLayout::reference_volume + p);
        const auto point = records.point.from(p * layout_.size());
        modulus = max(modulus, point.get(layout_.modulus()));
        ratio += point.get(layout_.volume_ratio()) * Lanes(1.0 / points);
      }
      ElementMotion<Lanes, points> motion;
      typename Element::template Carried<Lanes> carried;
      element_.strain(ElementInput<Lanes>{x, v, reference, 0.0, false},
                      records.element.from(ElementLayout{points}.own()), motion, carried);
      const Lanes speed = sqrt(modulus * ratio * Lanes(1.0 / options_.density));
      const Lanes undamped = motion.length / speed;
      Lanes step = stable_step(options_.bulk, motion.length, speed, Lanes(0.0));
      if (options_.damping.active())
        step *= StiffnessDamping::reduction(options_.damping.beta(undamped), undamped);
      for (int lane = 0; lane < lane_count; ++lane) {
        const std::size_t e = b * lane_count + static_cast<std::size_t>(lane);
        if (e < table_.element_count) steps[e] = state.alive[e] > 0.0 ? step[lane] : 1.0e30;
      }
    }
  }

  std::vector<ElementField> fields() const override { return solid_fields(*law_); }

  void evaluate(std::string_view field, const base::Array<double>&, const BlockState& state,
                std::span<const std::size_t> elements, std::span<double> out) const override {
    evaluate_solid_field(*law_, layout_, points, element_size_, table_.element_count, state, field, elements,
                         out);
  }

  void alive(const BlockState& state, std::span<bool> out) const override {
    for (std::size_t e = 0; e < table_.element_count; ++e) out[e] = state.alive[e] > 0.0;
  }

  double bytes_per_element() const override {
    const double records = sizeof(double) * (points * layout_.size() + element_size_ + 1.0);
    return records + table_.bytes() / static_cast<double>(table_.element_count);
  }

  const Element& element() const { return element_; }
  const SolidOptions& options() const { return options_; }
  const PointLayout& layout() const { return layout_; }
  const ChunkTable& table() const { return table_; }
  BatchRecords<Lanes> records_of(std::size_t batch, BlockState& state) const {
    return {{state.point.data() + batch * points * static_cast<std::size_t>(layout_.size()) * lane_count},
            {state.element.data() + batch * static_cast<std::size_t>(element_size_) * lane_count}};
  }

 private:
  using Averages = std::conditional_t<averaged, NodeAverages, NoAverages>;
  struct ThreadMemory {
    ChunkMemory nodes;
    Kept<Lanes, Element> kept[tile_batches];
    PointScratch<Lanes> point[tile_batches * points];
  };

  template <class Factor>
  void add_mass(const BlockState& state, std::span<double> mass, const Factor& factor) const {
    for (std::size_t e = 0; e < table_.element_count; ++e) {
      double volume = 0.0;
      for (int p = 0; p < points; ++p) volume += element_value(state, e, ElementLayout::reference_volume + p);
      element_.spread_mass(factor(e) * (volume * options_.density), [&](int a, double share) {
        mass[static_cast<std::size_t>(table_.connectivity[e * nodes + static_cast<std::size_t>(a)])] += share;
      });
    }
  }

  double element_value(const BlockState& state, std::size_t e, int component) const {
    const std::size_t batch = e / lane_count, lane = e % lane_count;
    return state
        .element[(batch * static_cast<std::size_t>(element_size_) + static_cast<std::size_t>(component)) *
                     lane_count +
                 lane];
  }

  void gather_global(std::size_t batch, const double* position, Vec3<Lanes>* x) const {
    for (int lane = 0; lane < lane_count; ++lane) {
      const Index* list = table_.connectivity.data() + table_.element(batch, lane) * nodes;
      for (int a = 0; a < nodes; ++a) {
        const double* at = position + 3 * static_cast<std::size_t>(list[a]);
        x[a].x.set(lane, at[0]);
        x[a].y.set(lane, at[1]);
        x[a].z.set(lane, at[2]);
      }
    }
  }

  StepStatus failure(std::size_t batch, int lane, const char* what, const char* likely_cause) const {
    return {false, part_, table_.id[table_.element(batch, lane)], what, likely_cause};
  }

  void run_chunk(std::size_t c, const StepInput& input, BlockState& state, Averages& averages,
                 const ForceScatter<nodes>& scatter, ThreadMemory& memory, StepOutput& result) const {
    const Chunk& chunk = table_.chunks[c];
    const Chunk* next = c + 1 < table_.chunks.size() ? &chunk + 1 : nullptr;
    const std::int32_t tiles = (chunk.batch_count + tile_batches - 1) / tile_batches;
    memory.nodes.load(table_, chunk, input.position, input.velocity);
    if constexpr (averaged) {
      averages.volume.divide(chunk, nodes);
      averages.stress.clear(chunk);
    }
    ChunkSums sums;
    alignas(64) double steps[ChunkTable::batches_per_chunk * lane_count];
    const std::size_t end = static_cast<std::size_t>(chunk.first_batch + chunk.batch_count);
    for (std::size_t first = static_cast<std::size_t>(chunk.first_batch); first < end;
         first += tile_batches) {
      const int count = static_cast<int>(std::min<std::size_t>(tile_batches, end - first));
      const std::int32_t tile = (static_cast<std::int32_t>(first) - chunk.first_batch) / tile_batches;
      if (next) prefetch_nodes(table_, *next, tile, tiles, input.position, input.velocity);
      scatter.prefetch(chunk, tile, tiles);
      for (int i = 0; i < count; ++i)
        before_law(first + static_cast<std::size_t>(i), chunk, input, state, averages, memory, memory.kept[i],
                   memory.point + i * points, result);
      law_->update(law_tile(memory.point, count * points, records_of(first, state).point.at, layout_,
                            input.dt, input.time));
      for (int i = 0; i < count; ++i) {
        const std::size_t b = first + static_cast<std::size_t>(i);
        after_law(b, chunk, input, state, averages, memory, memory.kept[i], memory.point + i * points,
                  scatter, steps + (b - static_cast<std::size_t>(chunk.first_batch)) * lane_count, sums,
                  result);
      }
    }
    scatter.finish(chunk, memory.nodes, sums.magnitude);
    result.internal_energy = base::sum(sums.internal);
    result.hourglass_energy = base::sum(sums.hourglass);
    result.damping_work = base::sum(sums.damping);
    result.stable_step = base::least(sums.least_step);
    for (std::size_t i = 0; i < static_cast<std::size_t>(chunk.batch_count) * lane_count; ++i)
      if (steps[i] == result.stable_step && steps[i] < 1.0e30) {
        const Id id =
            table_.id[table_.element(static_cast<std::size_t>(chunk.first_batch), static_cast<int>(i))];
        if (result.stable_element == 0 || id < result.stable_element) result.stable_element = id;
      }
    std::ranges::sort(result.eroded);
  }

  // Sums of a chunk, lane by lane in batch order.
  struct ChunkSums {
    Lanes internal{0.0}, hourglass{0.0}, damping{0.0}, least_step{1.0e30};
    std::int64_t magnitude = 0;
  };

  [[gnu::flatten]] void before_law(std::size_t batch, [[maybe_unused]] const Chunk& chunk,
                                   const StepInput& input, BlockState& state,
                                   [[maybe_unused]] Averages& averages, ThreadMemory& memory,
                                   Kept<Lanes, Element>& kept, PointScratch<Lanes>* point,
                                   StepOutput& result) const {
    Vec3<Lanes> x[nodes], v[nodes];
    gather_batch<nodes>(table_, batch, memory.nodes, x, v);
    prefetch_records(batch + tile_batches, state);
    const Lanes living = Lanes::load(state.alive.data() + batch * lane_count);
    const base::Mask active = living > Lanes(0.0);
    [[maybe_unused]] NodeMeans<Lanes> means;
    if constexpr (averaged) {
      Lanes mean[NodeRows::width];
      NodeRows::sum<nodes>(averages.volume.of(chunk), table_.local.data() + batch * nodes * lane_count, mean);
      means = {mean[1], mean[2], mean[3]};
    }
    strain_pass(element_, options_, layout_, x, v, input.dt, records_of(batch, state), active, kept, point,
                averaged ? &means : nullptr);
    if (!all((kept.least > Lanes(0.0)) | !active)) report_inverted(batch, kept.least, living, result);
  }

  // The records of the next tile arrive while this one is computed; beyond the end it does no harm.
  void prefetch_records(std::size_t batch, const BlockState& state) const {
    const auto ask = [](const double* first, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) __builtin_prefetch(first + i * lane_count, 1);
    };
    const std::size_t point = points * static_cast<std::size_t>(layout_.size());
    ask(state.point.data() + batch * point * lane_count, point);
    ask(state.element.data() + batch * static_cast<std::size_t>(element_size_) * lane_count,
        static_cast<std::size_t>(element_size_));
    __builtin_prefetch(state.alive.data() + batch * lane_count);
  }

  [[gnu::noinline]] void report_inverted(std::size_t batch, const Lanes& least, const Lanes& living,
                                         StepOutput& result) const {
    for (int lane = 0; lane < lane_count; ++lane)
      if (living[lane] > 0.0 && !(least[lane] > 0.0))
        result.status.merge(
            failure(batch, lane, "volume became negative",
                    "the element is crushed or the step too large: try a smaller TSSFAC, a finer "
                    "mesh there, a stiffer hourglass control, or an erosion criterion"));
  }

  [[gnu::flatten]] void after_law(std::size_t batch, const Chunk& chunk, const StepInput& input,
                                  BlockState& state, [[maybe_unused]] Averages& averages,
                                  ThreadMemory& memory, Kept<Lanes, Element>& kept,
                                  PointScratch<Lanes>* point, const ForceScatter<nodes>& scatter,
                                  double* steps, ChunkSums& sums, StepOutput& result) const {
    Vec3<Lanes> f[nodes];
    ForceAnswer<Lanes> answer;
    force_pass(element_, options_, layout_, input.dt, records_of(batch, state), kept, point, f, answer);

    const Lanes zero(0.0);
    double* living = state.alive.data() + batch * lane_count;
    base::Mask active = Lanes::load(living) > zero;
    bool everyone = all(active);
    const base::Mask gone =
        active & ((answer.failed >= failed_needed_) | (answer.stable_step < Lanes(input.erosion_step)));
    if (any(gone)) {
      erode(batch, gone, answer, living, result);
      active = active & !gone;
      everyone = false;
    }
    if (!everyone) {
      answer.stable_step = select(active, answer.stable_step, Lanes(1.0e30));
      answer.internal = select(active, answer.internal, zero);
      answer.hourglass = select(active, answer.hourglass, zero);
      answer.damping = select(active, answer.damping, zero);
    }
    answer.stable_step.store(steps);
    sums.least_step = min(sums.least_step, answer.stable_step);
    sums.internal += answer.internal;
    sums.hourglass += answer.hourglass;
    sums.damping += answer.damping;
    sums.magnitude |= scatter.add(batch, chunk, active, everyone, f, memory.nodes,
                                  [&](int lane) { report_broken(batch, lane, result); });
    if constexpr (averaged) {
      const Lanes volume = records_of(batch, state).element.get(ElementLayout::reference_volume);
      const Lanes value[NodeRows::width] = {
          select(active, volume, zero), select(active, volume * kept.carried.mean_stress, zero), zero, zero};
      NodeRows::add<nodes>(averages.stress.of(chunk), table_.local.data() + batch * nodes * lane_count,
                           value);
    }
  }

  void report_broken(std::size_t batch, int lane, StepOutput& result) const {
    result.status.merge(failure(batch, lane, "force is not a number",
                                "the material or the velocities of its nodes broke down: look at the states "
                                "before, and at the units of the material"));
  }

  [[gnu::noinline]] void erode(std::size_t batch, base::Mask gone, const ForceAnswer<Lanes>& answer,
                               double* living, StepOutput& result) const {
    for (int lane = 0; lane < lane_count; ++lane) {
      if (!gone[lane]) continue;
      living[lane] = 0.0;
      result.eroded_internal += answer.internal[lane];
      result.eroded_hourglass += answer.hourglass[lane];
      result.eroded.push_back(table_.id[table_.element(batch, lane)]);
    }
  }

  // Chunk results in chunk order.
  static StepOutput merged(std::vector<StepOutput> results) {
    StepOutput all;
    for (StepOutput& r : results) {
      all.status.merge(std::move(r.status));
      if (r.stable_step < all.stable_step ||
          (r.stable_step == all.stable_step && r.stable_element < all.stable_element)) {
        all.stable_step = r.stable_step;
        all.stable_element = r.stable_element;
      }
      all.internal_energy += r.internal_energy;
      all.hourglass_energy += r.hourglass_energy;
      all.eroded_internal += r.eroded_internal;
      all.eroded_hourglass += r.eroded_hourglass;
      all.damping_work += r.damping_work;
      all.eroded.insert(all.eroded.end(), r.eroded.begin(), r.eroded.end());
    }
    std::ranges::sort(all.eroded);
    return all;
  }

  std::string_view name_;
  Index part_;
  std::shared_ptr<const model::Law> law_;
  Element element_;
  SolidOptions options_;
  PointLayout layout_;
  int element_size_ = 0;
  Lanes failed_needed_{1.0};
  ChunkTable table_;
};

}  // namespace cleave::discretisation::fem
