#pragma once
/// Sets of one kind: cards are kept until somebody asks, because sets may be made of sets defined later.

#include <map>
#include <vector>

#include "model/keyword/entry.hpp"
#include "model/model.hpp"

namespace cleave::model {

class Draft;

template <class Member>
class SetBook {
 public:
  /// Members of the set of one card.
  using Evaluate = std::vector<Member> (*)(Draft&, const Entry&);

  void add(Id id, const Entry& entry, Evaluate evaluate) {
    order_.push_back(id);
    items_.emplace(id, Item{entry, evaluate, {}, State::pending});
  }

  /// The members; null when there is no such set or when it contains itself (`circular` is set then).
  const std::vector<Member>* find(Draft& draft, Id id, bool* circular = nullptr) {
    const auto at = items_.find(id);
    if (at == items_.end()) return nullptr;
    Item& item = at->second;
    if (item.state == State::open) {
      if (circular) *circular = true;
      return nullptr;
    }
    if (item.state == State::pending) {
      item.state = State::open;
      item.members = item.evaluate(draft, item.entry);
      item.state = State::done;
    }
    return &item.members;
  }

  /// All sets in reading order, evaluated, moved out.
  std::vector<Set<Member>> take(Draft& draft) {
    std::vector<Set<Member>> sets;
    for (const Id id : order_) find(draft, id);
    for (const Id id : order_) {
      Item& item = items_.at(id);
      sets.push_back({id, item.entry.title(), std::move(item.members)});
    }
    return sets;
  }

 private:
  enum class State { pending, open, done };
  struct Item {
    Entry entry;
    Evaluate evaluate;
    std::vector<Member> members;
    State state = State::pending;
  };
  std::map<Id, Item> items_;
  std::vector<Id> order_;
};

}  // namespace cleave::model
