#include "generator/print/splits.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace hlsgen {
namespace {

constexpr unsigned kDeepestLiteral = 4;  // of a condition, through & | !
constexpr unsigned kMostRest = 4;        // labels that a comment behind `default` may list
constexpr double kTie = 0.5;

}  // namespace

Splits::Splits(Restrictor& restrictor, Rater& rater, Updates updates, const Facts& facts)
    : restrictor_(restrictor), rater_(rater), facts_(facts) {
  for (const Update& u : updates) {
    candidates_.emplace_back();
    candidates_.back().update = u;
  }
  collect();
  index_ = index(facts_);
}

// The conditions a value hangs on.
void Splits::add_literals(NodeId id, unsigned depth, std::vector<NodeId>& out) const {
  const Node& n = node(id);
  if (n.op == Op::kConstant) return;
  if (n.op == Op::kNot) return add_literals(n.in[0], depth, out);
  out.push_back(id);
  if (depth < kDeepestLiteral && (n.op == Op::kAnd || n.op == Op::kOr))
    for (const NodeId operand : n.in) add_literals(operand, depth + 1, out);
}

void Splits::collect() {
  std::vector<std::vector<NodeId>> own(candidates_.size());
  std::set<NodeId> literals, selectors;
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    const Update& u = candidates_[i].update;
    if (!rater_.is_choice(u.value) || rater_.is_free(u.value)) continue;
    const NodeId condition = rater_.without_not(node(u.value).in[0]);
    candidates_[i].condition = condition;
    add_literals(condition, 0, own[i]);
    std::sort(own[i].begin(), own[i].end());
    own[i].erase(std::unique(own[i].begin(), own[i].end()), own[i].end());
    literals.insert(own[i].begin(), own[i].end());
    candidates_[i].own = rater_.gain(u, on(condition));
  }
  for (const NodeId id : literals)
    if (const Domain* d = restrictor_.domain(id)) selectors.insert(d->selector);
  for (const NodeId id : selectors) {
    selectors_.emplace_back();
    selectors_.back().id = id;
  }
  std::map<NodeId, unsigned> number_of;
  for (const NodeId id : literals) {
    number_of[id] = static_cast<unsigned>(literals_.size());
    literals_.emplace_back();
    literals_.back().id = id;
    if (const Domain* d = restrictor_.domain(id)) {
      const auto at = std::distance(selectors.begin(), selectors.find(d->selector));
      literals_.back().selector = static_cast<unsigned>(at);
      ++selectors_[literals_.back().selector].readers;
    }
  }
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    for (const NodeId id : own[i]) {
      candidates_[i].literals.push_back(number_of[id]);
      ++literals_[number_of[id]].readers;
      if (id == candidates_[i].condition) ++literals_[number_of[id]].wholes;
    }
  }
}

Splits::Index Splits::index(const Facts& facts) const {
  Index index;
  for (unsigned i = 0; i < candidates_.size(); ++i) {
    if (candidates_[i].taken) continue;
    const Questions questions = restrictor_.questions(facts, candidates_[i].update.value);
    if (!questions.settled) index.always.push_back(i);
    for (const NodeId bit : questions.bits) index.bits[bit].push_back(i);
    for (const NodeId selector : questions.selectors) {
      auto& all = index.selectors[selector];
      if (all.empty() || all.back() != i) all.push_back(i);
    }
  }
  return index;
}

// Who may change by what `facts` say beyond those of all.
Splits::Positions Splits::asked(const Index& index, const Facts& facts) const {
  Positions all;
  const auto add = [&](const llvm::DenseMap<NodeId, Positions>& from, NodeId id) {
    const auto found = from.find(id);
    if (found != from.end()) all.insert(all.end(), found->second.begin(), found->second.end());
  };
  for (const auto& [bit, value] : facts.bits) {
    const auto before = facts_.bits.find(bit);
    if (before == facts_.bits.end() || before->second != value) add(index.bits, bit);
  }
  for (const auto& [selector, range] : facts.ranges) {
    const auto before = facts_.ranges.find(selector);
    if (before == facts_.ranges.end() || before->second != range) add(index.selectors, selector);
  }
  return all;
}

Splits::Positions Splits::left_of(Positions positions) const {
  std::sort(positions.begin(), positions.end());
  positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
  const auto is_taken = [&](unsigned i) { return candidates_[i].taken; };
  positions.erase(std::remove_if(positions.begin(), positions.end(), is_taken), positions.end());
  return positions;
}

Split Splits::on(NodeId condition) const {
  Split s{condition, {{}, {}}, {facts_, facts_}, {}, {}, 0};
  restrictor_.learn(s.facts[0], condition, true);
  restrictor_.learn(s.facts[1], condition, false);
  return s;
}

// Values of the selector that lead to the same, in one arm; the largest is the default.
Split Splits::cases(NodeId selector, const Positions& asked) {
  const llvm::APInt range = restrictor_.range(facts_, selector);
  std::map<std::vector<NodeId>, llvm::APInt> classes;
  for (unsigned v = 0; v < range.getBitWidth(); ++v) {
    if (!range[v]) continue;
    Facts known = facts_;
    known.splits_shared = true;
    known.ranges[selector] = llvm::APInt::getOneBitSet(range.getBitWidth(), v);
    std::vector<NodeId> values;
    for (const unsigned i : asked)
      values.push_back(restrictor_.restrict(known, candidates_[i].update.value));
    classes.emplace(values, llvm::APInt(range.getBitWidth(), 0)).first->second.setBit(v);
  }
  std::vector<llvm::APInt> arms;
  for (const auto& [values, members] : classes) arms.push_back(members);
  std::sort(arms.begin(), arms.end(), [](const llvm::APInt& a, const llvm::APInt& b) {
    return a.countTrailingZeros() < b.countTrailingZeros();
  });
  if (arms.size() < 3) return {};
  const auto fallback = std::max_element(
      arms.begin(), arms.end(), [](const llvm::APInt& a, const llvm::APInt& b) {
        return a.countPopulation() <= b.countPopulation();  // the last of them
      });
  std::rotate(fallback, fallback + 1, arms.end());
  Split s;
  s.selector = selector;
  for (const llvm::APInt& arm : arms) {
    s.labels.emplace_back();
    s.facts.push_back(facts_);
    s.facts.back().ranges[selector] = arm;
    s.facts.back().splits_shared = true;
    const bool last = s.labels.size() == arms.size();
    if (last && arm.countPopulation() > kMostRest) break;
    for (unsigned v = 0; v < arm.getBitWidth(); ++v)
      if (arm[v]) (last ? s.rest : s.labels.back()).emplace_back(node(selector).width, v);
  }
  return s;
}

Split Splits::rate(Split split, const Positions& asked, Rated& rated) {
  Updates updates;
  std::vector<double> own;
  for (const unsigned i : asked) {
    updates.push_back(candidates_[i].update);
    own.push_back(candidates_[i].own);
  }
  Split s = rater_.rate(std::move(split), updates, own);
  rated = {true, s.gain, {}};
  for (std::size_t i = 0; i < s.joined.size(); ++i)
    if (s.joined[i]) rated.joined.push_back(asked[i]);
  return s;
}

void Splits::rate(unsigned literal) {
  Literal& l = literals_[literal];
  Split split = on(l.id);
  Positions all = index_.always;
  for (const Facts& facts : split.facts) {
    const Positions more = asked(index_, facts);
    all.insert(all.end(), more.begin(), more.end());
  }
  rate(std::move(split), left_of(std::move(all)), l.rated);
  for (const unsigned i : l.rated.joined) candidates_[i].rated.push_back(literal);
}

void Splits::rate_selector(unsigned selector) {
  if (!has_index_of_cases_) {
    Facts facts = facts_;
    facts.splits_shared = true;
    index_of_cases_ = index(facts);
    has_index_of_cases_ = true;
  }
  Selector& s = selectors_[selector];
  Positions all = index_of_cases_.always;
  const auto found = index_of_cases_.selectors.find(s.id);
  if (found != index_of_cases_.selectors.end())
    all.insert(all.end(), found->second.begin(), found->second.end());
  all = left_of(std::move(all));
  // Who does not join should not tell arms apart either.
  rate(cases(s.id, all), all, s.rated);
  s.split = rate(cases(s.id, s.rated.joined), all, s.rated);
  for (const unsigned i : all) candidates_[i].selected.push_back(selector);
}

Split Splits::best() {
  NodeId condition = kNone;
  const Split* split = nullptr;
  double best = 0;
  chosen_ = nullptr;
  const auto is_better = [&](Rated& rated) {
    if (rated.gain < Rater::kLeastGain || rated.gain <= best + kTie) return false;
    best = rated.gain;
    chosen_ = &rated;
    return true;
  };
  // A condition comes before its parts, and goes unless a part is clearly better.
  for (auto number = static_cast<unsigned>(literals_.size()); number-- > 0;) {
    Literal& l = literals_[number];
    if (l.readers == 0) continue;
    if (!l.rated.known) rate(number);
    // A part of one register's condition is no better than the condition.
    if ((l.wholes > 0 || l.rated.joined.size() > 1) && is_better(l.rated)) condition = l.id;
  }
  for (unsigned number = 0; number < selectors_.size(); ++number) {
    Selector& s = selectors_[number];
    if (s.readers == 0) continue;
    if (!s.rated.known) rate_selector(number);
    if (is_better(s.rated)) split = &s.split;
  }
  if (split != nullptr) return *split;
  return condition == kNone ? Split{} : on(condition);
}

Updates Splits::take() {
  const Positions joined = chosen_->joined;
  Updates out;
  for (const unsigned i : joined) {
    Candidate& c = candidates_[i];
    out.push_back(c.update);
    c.taken = true;
    for (const unsigned literal : c.rated) literals_[literal].rated.known = false;
    for (const unsigned selector : c.selected) selectors_[selector].rated.known = false;
    for (const unsigned number : c.literals) {
      Literal& l = literals_[number];
      if (l.id == c.condition) --l.wholes;
      if (--l.readers == 0 && l.selector != kNone) --selectors_[l.selector].readers;
    }
  }
  return out;
}

Updates Splits::rest() const {
  Updates out;
  for (const Candidate& c : candidates_)
    if (!c.taken) out.push_back(c.update);
  return out;
}

}  // namespace hlsgen
