// Cases over one selector; see prettify.hpp.

#include "generator/print/prettify.hpp"

#include <algorithm>
#include <set>

namespace hlsgen {
namespace {

using syntax::Case;
using syntax::Expr;

void collect_names(const Expr& e, std::set<std::string>& names) {
  if (e.is(Expr::Kind::kName) || e.is(Expr::Kind::kSelect)) names.insert(e.text);
  for (const Expr& operand : e.operands) collect_names(operand, names);
}

std::set<std::string> names_read(const syntax::Item& item) {
  std::set<std::string> names;
  for_each_in_item(item, [&](const Expr& e) { collect_names(e, names); });
  return names;
}

std::set<std::string> names_made(const syntax::Item& item) {
  std::set<std::string> names;
  if (const auto* wire = std::get_if<syntax::Wire>(&item)) names.insert(wire->name);
  if (const auto* cell = std::get_if<syntax::Cell>(&item))
    for (const syntax::Cell::Output& o : cell->outputs) names.insert(o.wire);
  if (const auto* c = std::get_if<Case>(&item))
    for (const Case::Target& t : c->targets) names.insert(t.name);
  return names;
}

bool meet(const std::set<std::string>& a, const std::set<std::string>& b) {
  return std::any_of(a.begin(), a.end(), [&](const std::string& s) { return b.count(s) != 0; });
}

bool same_labels(const Case& a, const Case& b) {
  return std::equal(a.arms.begin(), a.arms.end(), b.arms.begin(), b.arms.end(),
                    [](const Case::Arm& x, const Case::Arm& y) { return x.labels == y.labels; });
}

void absorb(Case& into, Case& other) {
  into.targets.push_back(other.targets[0]);
  for (std::size_t i = 0; i < into.arms.size(); ++i)
    into.arms[i].values.push_back(std::move(other.arms[i].values[0]));
  into.comment.clear();
}

// Arms that do the same share their labels; those that do the default are left out.
void fold_arms(Case& c) {
  std::vector<Case::Arm> arms;
  Case::Arm fallback = std::move(c.arms.back());
  c.arms.pop_back();
  for (Case::Arm& arm : c.arms) {
    if (arm.values == fallback.values) continue;
    const auto same = std::find_if(arms.begin(), arms.end(), [&](const Case::Arm& other) {
      return other.values == arm.values;
    });
    if (same == arms.end()) {
      arms.push_back(std::move(arm));
    } else {
      for (Expr& label : arm.labels) same->labels.push_back(std::move(label));
    }
  }
  arms.push_back(std::move(fallback));
  c.arms = std::move(arms);
}

}  // namespace

void merge_cases(std::vector<syntax::Item>& items) {
  for (std::size_t first = 0; first < items.size(); ++first) {
    if (!std::holds_alternative<Case>(items[first])) continue;
    std::set<std::string> between;  // made at or after `first`
    for (std::size_t i = first; i < items.size(); ++i) {
      auto& head = std::get<Case>(items[first]);
      auto* other = std::get_if<Case>(&items[i]);
      if (i != first && other != nullptr && other->selector == head.selector &&
          same_labels(head, *other) && !meet(names_read(items[i]), between)) {
        absorb(head, *other);
        between.insert(other->targets[0].name);
        items.erase(items.begin() + static_cast<std::ptrdiff_t>(i--));
        continue;
      }
      between.merge(names_made(items[i]));
    }
    fold_arms(std::get<Case>(items[first]));
  }
}

}  // namespace hlsgen
