#pragma once
/// The model while it is being built: what has been defined so far, and how references are resolved.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/keyword/entry.hpp"
#include "model/keyword/rigid_draft.hpp"
#include "model/keyword/set_book.hpp"
#include "model/model.hpp"

namespace cleave::model {

/// *DEFINE_BOX, possibly turned.
struct Box {
  Vector low, high;  ///< in the frame's directions, relative to its origin
  Frame frame;
  bool contains(const Vector& point) const;
};

class Draft {
 public:
  Draft(const deck::Deck& d, const BuildOptions& o, deck::Diagnostics& say, Model& m, Account& a);

  const deck::Deck& deck;
  const BuildOptions& options;
  deck::Diagnostics& diagnostics;
  Model& model;
  Account* account;

  // --- definitions by id ------------------------------------------------------------------------
  std::map<Id, Frame> frames;    ///< *DEFINE_COORDINATE_*
  std::map<Id, Vector> vectors;  ///< *DEFINE_VECTOR, unit
  std::map<Id, Box> boxes;
  std::map<Id, Section> sections;
  std::map<Id, Hourglass> hourglasses;         ///< zeros where the card left the default
  std::map<Id, Entry> materials, states;       ///< *MAT_ by MID, *EOS_ by EOSID
  std::map<Id, std::vector<Entry>> additions;  ///< *MAT_ADD_ by MID
  std::map<Id, Affine> transformations;        ///< *DEFINE_TRANSFORMATION

  std::vector<Entry> part_entries;  ///< the card of each part, in the order of Model::parts

  SetBook<Index> node_sets, part_sets;
  SetBook<Id> solid_sets, shell_sets, beam_sets;
  SetBook<Id>& element_sets(ElementKind kind);
  SetBook<Segment> segment_sets;

  RigidDraft rigid;

  bool transformations_read = false;  ///< are all *DEFINE_TRANSFORMATION known?
  bool first_of_block = true;         ///< is the card being taken the first of its block?

  /// Node constraints of *NODE by code: TC in 0..7, RC in 0..7.
  std::map<std::pair<int, int>, std::vector<Id>> node_codes;
  /// Position of each element id in the mesh; filled on first use.
  struct ElementPlace {
    std::uint32_t group, index;  ///< of Mesh::elements(kind), of the arrays in it
  };
  std::optional<ElementPlace> element(Id id, ElementKind kind = ElementKind::solid);
  /// Node amid the edge between two corners of a ten-node tetrahedron; -1 where there is none.
  Index mid_node(Index a, Index b);
  /// Velocities are laid on in the order the format ranks them, after all cards are read.
  std::vector<std::function<void()>> velocity_layers[3];
  /// What must wait until every card of the phase has been read; run and cleared after each phase.
  std::vector<std::function<void()>> after_phase;

  /// What needs the densities of the parts.
  std::vector<std::function<void()>> when_laws_known;

  double wall_penalty = 0.0;                    ///< RWPNAL of *CONTROL_CONTACT
  std::map<Index, PartFriction> part_friction;  ///< *PART_CONTACT by position of the part

  // --- references, with an error where they lead nowhere ------------------------------------------
  Index node(const Entry& entry, std::string_view field, std::size_t row = 0);
  Index part(const Entry& entry, std::string_view field, std::size_t row = 0);
  /// Curve of a field; -1 where the field is 0 (an error if `required`).
  Index curve(const Entry& entry, std::string_view field, bool required = true);
  const std::vector<Index>* node_set(const Entry& entry, std::string_view field);
  const std::vector<Index>* part_set(const Entry& entry, std::string_view field);
  const std::vector<Id>* element_set(const Entry& entry, std::string_view field, ElementKind kind);
  const std::vector<Segment>* segment_set(const Entry& entry, std::string_view field);
  /// Frame of a field; the global axes where the field is 0.
  const Frame* frame(const Entry& entry, std::string_view field);
  const Box* box(const Entry& entry, std::string_view field);

  // --- what cards say in common -------------------------------------------------------------------
  Vector position(Index node) const;
  std::vector<Index> all_nodes() const;
  std::vector<Index> nodes_of_parts(const std::vector<Index>& parts) const;
  /// Nodes of NSID (0: all), inside BOXID if given, without those of NSIDEX.
  std::optional<std::vector<Index>> selected_nodes(const Entry& entry);
  /// A distance below which a node counts as lying on a plane.
  double plane_tolerance() const;

  void error(const Entry& entry, std::string_view field, std::string message, std::string hint = {});
  void warning(const Entry& entry, std::string_view field, std::string message, std::string hint = {});
  /// Asked for, understood, but not computed: an error, or a warning with allow_unsupported.
  void refuse(const Entry& entry, std::string_view field, std::string message, std::string hint = {});
  void refuse(deck::Place place, std::string keyword, std::string field, std::string message,
              std::string hint);
  /// False, with an error, when the id was defined before. `space` names the number space.
  bool claim(const Entry& entry, std::string_view space, Id id, std::string_view field);
  /// Refuses velocities and other vectors of a file that is turned by a transformation.
  void refuse_turned(const Entry& entry, std::string_view what);

  Entry entry_of(deck::Card card, int transform);
  const Affine& motion(int transform);

 private:
  std::map<std::pair<std::string, Id>, deck::Place> claimed_;
  std::vector<std::pair<Id, ElementPlace>> element_index_[3];  ///< [kind]
  std::optional<std::map<std::pair<Index, Index>, Index>> mid_nodes_;
  std::map<int, Affine> motions_;
};

/// Reports the first few of a kind in full and the rest as a number, so that a million equal mistakes stay
/// readable.
class Capped {
 public:
  explicit Capped(std::size_t limit = 20) : limit_(limit) {}
  bool take() { return ++count_ <= limit_; }
  /// "and 117 more", or empty.
  std::string rest() const {
    return count_ > limit_ ? "and " + std::to_string(count_ - limit_) + " more" : "";
  }

 private:
  std::size_t limit_, count_ = 0;
};

/// Translation bits of the codes 0..7 of *NODE and *CONSTRAINED_GLOBAL: 0 none, 1 x, 2 y, 3 z, 4 xy, 5 yz, 6
/// zx, 7 all.
unsigned direction_bits(std::int64_t code);

}  // namespace cleave::model
