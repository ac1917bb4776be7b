/// Cost of one constitutive update per point: tiles of 64 points that stay in the first cache, half of the
/// points flowing, for every sample of the sweep tests. CPU time of the best of several stretches.
///
/// usage: bench_law_update [WORD in keyword or name]

#include <algorithm>
#include <cstdio>
#include <string>

#include "../tests/unit/model/material_samples.hpp"
#include "base/array.hpp"
#include "base/lanes.hpp"
#include "deck/deck.hpp"
#include "machine.hpp"
#include "model/material/eos.hpp"
#include "model/material/erosion.hpp"
#include "model/material/law.hpp"

namespace {

using namespace cleave;
using base::lane_count;

struct Built {
  deck::Diagnostics diagnostics;
  std::vector<model::Curve> curves;
  std::vector<model::Table> tables;
  std::unique_ptr<model::PressureLaw> pressure;
  std::unique_ptr<model::Law> law;
};

/// The sample's law; curves and tables are read in the order they stand, laws last.
Built build(const std::string& text) {
  Built r;
  auto deck = deck::Deck::read_text("*KEYWORD\n" + text + "*END\n", "bench.k", {}, r.diagnostics);
  std::vector<deck::Card> cards;
  for (const auto& block : deck.blocks())
    for (const auto& card : deck.cards(block, r.diagnostics)) cards.push_back(card);
  const auto each = [&](std::string_view word, auto take) {
    for (const auto& card : cards)
      if (card.keyword().starts_with(word)) take(card);
  };
  each("DEFINE_CURVE", [&](const deck::Card& c) {
    auto& curve = r.curves.emplace_back();
    curve.id = c.integer("LCID");
    for (std::size_t i = 0; i < c.row_count("A1"); ++i) {
      curve.x.push_back(c.real("A1", i));
      curve.y.push_back(c.real("O1", i));
    }
  });
  each("DEFINE_TABLE_2D", [&](const deck::Card& c) {
    auto& table = r.tables.emplace_back();
    table.id = c.integer("TBID");
    for (std::size_t i = 0; i < c.row_count("VALUE"); ++i) {
      table.value.push_back(c.real("VALUE", i));
      for (std::size_t k = 0; k < r.curves.size(); ++k)
        if (r.curves[k].id == c.integer("LCID", i)) table.curve.push_back(static_cast<model::Index>(k));
    }
  });
  double density = 0.0;
  each("MAT_", [&](const deck::Card& c) {
    if (c.has_field("RO")) density = c["RO"];
  });
  each("EOS_", [&](const deck::Card& c) {
    r.pressure = model::find_pressure_law(c.keyword())->build(c, density, r.diagnostics);
  });
  const model::LawContext context{
      .curves = r.curves, .tables = r.tables, .pressure = r.pressure.get(), .diagnostics = r.diagnostics};
  each("MAT_", [&](const deck::Card& c) {
    r.law = c.keyword() == "MAT_ADD_EROSION" ? model::add_erosion(std::move(r.law), c, context)
                                             : model::find_law(c.keyword())->build(c, context);
  });
  return r;
}

/// Nanoseconds per point.
double measure(const model::Law& law, const model::testing::Sample& sample) {
  constexpr int batches = 8, points = batches * lane_count;
  const int state = law.state_size(), record = (7 + state) * lane_count;
  base::Array<double> strain(batches * 6 * lane_count), F(batches * 9 * lane_count, 0.0), ones(points, 1.0),
      zero(points, 0.0), records(batches * record, 0.0), modulus(points), failed(points);
  for (std::size_t i = 0; i < strain.size(); ++i)  // half of the lanes stay nearly elastic
    strain[i] = sample.strain * (i % 2 ? 0.2 : 1e-3) * (static_cast<double>((i * 7919) % 13) - 6.0) / 6.0;
  for (int b = 0; b < batches; ++b)
    for (int i = 0; i < 9; ++i)
      for (int lane = 0; lane < lane_count; ++lane)
        F[(b * 9 + i) * lane_count + lane] = (i % 4 == 0 ? 1.0 : 0.0) + strain[b * 48 + lane];
  std::vector<double> start(state, 0.0);
  law.initialise(start);
  for (int b = 0; b < batches; ++b)
    for (int k = 0; k < state; ++k)
      for (int lane = 0; lane < lane_count; ++lane)
        records[b * record + (6 + k) * lane_count + lane] = start[k];

  model::Tile tile;
  tile.batch_count = batches;
  tile.dt = sample.dt;
  tile.strain_increment = strain.data();
  tile.deformation_gradient = F.data();
  tile.volume_ratio = tile.volume_ratio_before = tile.length = ones.data();
  tile.bulk_viscosity = zero.data();
  tile.stress = records.data();
  tile.state = records.data() + 6 * lane_count;
  tile.energy = records.data() + (6 + state) * lane_count;
  tile.modulus = modulus.data();
  tile.failed = failed.data();
  tile.record_stride = record;

  const base::Array<double> begin = records;
  double best = 1e30;
  constexpr int visits = 400;
  for (int stretch = 0; stretch < 15; ++stretch) {
    records = begin;
    const double from = bench::cpu_seconds();
    for (int v = 0; v < visits; ++v) {
      law.update(tile);
      if (v % 8 == 7)
        for (double& e : strain) e = -e;  // to and fro, so that strains stay bounded and flow goes on
    }
    best = std::min(best, bench::cpu_seconds() - from);
  }
  return best / (static_cast<double>(visits) * points) * 1e9;
}

}  // namespace

int main(int count, char** words) {
  std::printf("%-66s %10s %6s\n", "law", "ns/point", "state");
  for (const auto& sample : model::testing::samples()) {
    const std::string title = std::string(sample.keyword) + " " + sample.name;
    if (count > 1 && title.find(words[1]) == std::string::npos) continue;
    const Built built = build(sample.deck);
    std::printf("%-66s %10.2f %6d\n", title.c_str(), measure(*built.law, sample), built.law->state_size());
  }
}
