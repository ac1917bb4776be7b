#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "base/threads.hpp"
#include "results/summary.hpp"

namespace cleave::results {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name_of(model::Account::Policy policy) {
  switch (policy) {
    case model::Account::Policy::honoured:
      return "honoured";
    case model::Account::Policy::in_part:
      return "in_part";
    case model::Account::Policy::output_only:
      return "output_only";
    case model::Account::Policy::refused:
      return "refused";
    case model::Account::Policy::unknown:
      return "unknown";
  }
  return "unknown";
}

Json extent_json(const Extent& extent) {
  return {{"low", extent.low},
          {"high", extent.high},
          {"length", {extent.length(0), extent.length(1), extent.length(2)}},
          {"diameter", extent.diameter}};
}

}  // namespace

std::string Summary::json(const solver::Outcome& outcome) const {
  const model::Model& model = context_.model;
  Json out;
  out["title"] = model.title;
  out["program"] = "cleave";
  out["version"] = context_.options.version;
  out["deck"] = context_.options.deck.string();
  out["ending"] = name_of(ending_);
  out["ending_text"] = describe(ending_);
  out["normal"] = is_normal(ending_) && !context_.trouble.any();
  out["failure"] = nullptr;
  if (!status_.ok)
    out["failure"] = {
        {"part", status_.part >= 0 ? model.parts[static_cast<std::size_t>(status_.part)].id : 0},
        {"element", status_.element},
        {"what", status_.what},
        {"likely_cause", status_.likely_cause}};
  out["files_failed"] = context_.trouble.any() ? Json(context_.trouble.what()) : Json();
  out["final_time"] = time_;
  out["cycles"] = cycles_;
  out["time_step"] = {
      {"first", first_step_}, {"last", last_step_}, {"smallest", step_.low}, {"largest", step_.high}};

  out["energy"] = {{"kinetic", energy_.kinetic},
                   {"internal", energy_.internal},
                   {"hourglass", energy_.hourglass},
                   {"stonewall", energy_.wall},
                   {"damping", energy_.damping},
                   {"sliding_interface", energy_.sliding},
                   {"external_work", energy_.external},
                   {"eroded_kinetic", energy_.eroded_kinetic},
                   {"eroded_internal", energy_.eroded_internal},
                   {"eroded_hourglass", energy_.eroded_hourglass},
                   {"initial", energy_.initial},
                   {"total", energy_.total()},
                   {"ratio", energy_.ratio()},
                   {"ratio_without_eroded", energy_.ratio_without_eroded()},
                   {"ratio_low", ratio_.low},
                   {"ratio_high", ratio_.high},
                   {"kinetic_high", kinetic_.high},
                   {"internal_high", internal_.high},
                   {"hourglass_high", hourglass_.high}};
  out["mass"] = {{"total", mass_},
                 {"added", added_mass_},
                 {"percent_increase", base_mass_ > 0.0 ? 100.0 * added_mass_ / base_mass_ : 0.0}};

  Json counts = {{"nodes", model.mesh.nodes.count()}};
  std::size_t elements = 0, alive = 0;
  for (const auto* groups : {&model.mesh.beams, &model.mesh.shells, &model.mesh.solids})
    for (const model::Elements& group : *groups) {
      counts[std::string(model::name_of(group.shape))] = group.count();
      elements += group.count();
    }
  for (const PartFacts& part : parts_) alive += part.after.elements;
  counts["elements"] = elements;
  counts["parts"] = model.parts.size();
  out["counts"] = counts;

  std::size_t computed = 0;
  Json parts = Json::array();
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const PartFacts& facts = parts_[p];
    computed += facts.before.elements;
    Json symmetry = Json::array();
    for (int k = 0; k < 3; ++k)
      if (facts.axes.symmetry[k]) symmetry.push_back(std::string(1, "xyz"[k]));
    parts.push_back({{"id", model.parts[p].id},
                     {"title", model.parts[p].title},
                     {"elements", facts.before.elements},
                     {"eroded_elements", facts.before.elements - facts.after.elements},
                     {"mass", facts.mass},
                     {"kinetic_energy", facts.kinetic},
                     {"internal_energy", facts.energy.internal},
                     {"hourglass_energy", facts.energy.hourglass},
                     {"axis", facts.axes.centre},
                     {"symmetry", symmetry},
                     {"initial", extent_json(facts.before)},
                     {"final", extent_json(facts.after)}});
  }
  out["eroded_elements"] = computed - alive;
  out["parts"] = parts;

  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  Json phases = Json::object();
  for (const auto& phase : outcome.phases) phases[phase.name] = phase.seconds;
  const double rate = outcome.seconds > 0.0 ? outcome.element_cycles / outcome.seconds : 0.0;
  out["speed"] = {
      {"seconds", outcome.seconds},        {"element_cycles", outcome.element_cycles},
      {"element_cycles_per_second", rate}, {"nanoseconds_per_element_cycle", rate > 0.0 ? 1.0e9 / rate : 0.0},
      {"threads", base::thread_count()},   {"phases", phases}};
  if (!outcome.facts.empty()) {
    Json facts = Json::object();
    for (const solver::Fact& fact : outcome.facts) facts[fact.name] = fact.value;
    out["facts"] = facts;
  }
  out["memory"] = {{"peak_bytes", static_cast<double>(usage.ru_maxrss) * 1024.0},
                   {"bytes_per_element", computed > 0 ? bytes_ / static_cast<double>(computed) : 0.0}};

  Json account = Json::array(), unsupported = Json::array();
  if (context_.options.account)
    for (const auto& entry : context_.options.account->entries) {
      account.push_back({{"keyword", entry.keyword},
                         {"policy", name_of(entry.policy)},
                         {"cards", entry.cards},
                         {"defaulted", entry.defaulted},
                         {"ignored_fields", entry.ignored_fields},
                         {"remark", entry.remark}});
      if (entry.policy == model::Account::Policy::refused || entry.policy == model::Account::Policy::unknown)
        unsupported.push_back(entry.keyword);
    }
  out["deck_account"] = account;
  out["unsupported"] = unsupported;
  out["warnings"] = context_.options.warnings;
  // Titles are bytes of the deck: what is not UTF-8 is replaced, not refused.
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace cleave::results
