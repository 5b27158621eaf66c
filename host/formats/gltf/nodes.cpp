// Places the nodes of the default scene below each other.
#include "host/formats/gltf/nodes.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/setting_words.h"

namespace candela::gltf {

NodeTree::NodeTree(const Value& root, const Pose& pose, bool lenient, scene::DiagnosticLog& log) {
  const std::size_t count = root.sizeOf("nodes");
  children_.resize(count);
  parents_.resize(count, kNone);
  isHidden_.resize(count);
  worlds_.resize(count, glm::dmat4(1));
  if (count == 0) {
    if (root.sizeOf("scenes") > 0) listedRoots(root, {}, log);  // checks the indices
    return;
  }
  collectChildren(root, lenient, log);
  std::vector<std::size_t> tops;
  for (std::size_t i = 0; i < count; ++i) {
    if (parents_[i] == kNone) tops.push_back(i);
  }
  const Value nodes = root.require("nodes");
  const std::vector<std::size_t> order = placeSubtrees(tops, nodes, pose);
  std::vector<bool> isReached(count);
  for (const std::size_t i : order) isReached[i] = true;
  const auto unreached = static_cast<std::size_t>(std::ranges::find(isReached, false) - isReached.begin());
  if (unreached < count) nodes[unreached].fail("the node is its own ancestor, or a descendant of such a node");
  std::vector<std::size_t> roots;
  if (root.sizeOf("scenes") == 0) {
    roots = tops;
  } else {
    for (const Value& entry : listedRoots(root, order, log))
      roots.push_back(acceptRoot(entry, nodes, pose, lenient, log));
  }
  visible_ = descend(roots);
}

void NodeTree::collectChildren(const Value& root, bool lenient, scene::DiagnosticLog& log) {
  const Value nodes = root.require("nodes");
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const std::optional<Value> list = nodes[i].find("children");
    for (std::size_t c = 0; list && c < list->size(); ++c) {
      const std::size_t child = (*list)[c].indexInto("nodes", children_.size());
      if (parents_[child] != kNone) {
        const std::string message = fmt::format("node {} has another parent already", child);
        if (!lenient)
          (*list)[c].fail(fmt::format("{}; {} keeps it below the first one only", message, settingWords("lenient")));
        log.warn("parents", {}, fmt::format("{}: {}, and stays below that one only", (*list)[c].pointer(), message));
        continue;
      }
      parents_[child] = i;
      children_[i].push_back(child);
    }
  }
}

std::vector<std::size_t> NodeTree::placeSubtrees(const std::vector<std::size_t>& tops, const Value& nodes,
                                                 const Pose& pose) {
  std::vector<std::size_t> order = descend(tops);
  for (const std::size_t i : tops) worlds_[i] = glm::dmat4(1);
  for (const std::size_t i : order) {
    const auto posed = pose.find(i);
    worlds_[i] = worlds_[i] * localTransform(nodes[i], posed == pose.end() ? NodePose{} : posed->second);
    const std::optional<Value> visibility = extensionOf(nodes[i], "KHR_node_visibility");
    if (visibility && !visibility->booleanOr("visible", true)) isHidden_[i] = true;
    for (const std::size_t child : children_[i]) {
      worlds_[child] = worlds_[i];
      isHidden_[child] = isHidden_[i];
    }
  }
  return order;
}

std::vector<Value> NodeTree::listedRoots(const Value& root, const std::vector<std::size_t>& order,
                                         scene::DiagnosticLog& log) const {
  const std::optional<Value> chosen = root.find("scene");
  const Value scene = root.require("scenes")[chosen ? chosen->indexInto("scenes", root.sizeOf("scenes")) : 0];
  const std::optional<Value> list = scene.find("nodes");
  std::vector<Value> entries;
  std::vector<bool> isIn(children_.size());
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    entries.push_back((*list)[i]);
    const std::size_t node = entries.back().indexInto("nodes", children_.size());
    if (isIn[node]) entries.back().fail(fmt::format("node {} is in the scene twice", node));
    isIn[node] = true;
  }
  std::vector<bool> isBelow(children_.size());
  for (const std::size_t i : order) {
    if (parents_[i] != kNone) isBelow[i] = isIn[parents_[i]] || isBelow[parents_[i]];
  }
  const std::size_t dropped = std::erase_if(entries, [&](const Value& entry) { return isBelow[entry.whole()]; });
  if (dropped > 0) {
    log.warn("below", {}, list->pointer() + ": nodes that are below other nodes of the list are shown once");
  }
  return entries;
}

std::size_t NodeTree::acceptRoot(const Value& entry, const Value& nodes, const Pose& pose, bool lenient,
                                 scene::DiagnosticLog& log) {
  const auto node = static_cast<std::size_t>(entry.whole());
  if (parents_[node] == kNone) return node;
  const bool isMoved = worlds_[parents_[node]] != glm::dmat4(1);
  const std::string problem = fmt::format("node {} is no root", node);
  if (isMoved && !lenient) {
    entry.fail(fmt::format("{}, and its ancestors have transforms, so that its position is ambiguous; {} ignores them",
                           problem, settingWords("lenient")));
  }
  log.warn("root", {},
           entry.pointer() + ": " + problem + (isMoved ? "; the transforms of its ancestors are ignored" : ""));
  if (isMoved) placeSubtrees({node}, nodes, pose);
  return node;
}

std::vector<std::size_t> NodeTree::descend(const std::vector<std::size_t>& from) const {
  std::vector<std::size_t> order;
  std::vector<std::size_t> pending(from.rbegin(), from.rend());
  while (!pending.empty()) {
    const std::size_t node = pending.back();
    pending.pop_back();
    order.push_back(node);
    pending.insert(pending.end(), children_[node].rbegin(), children_[node].rend());
  }
  return order;
}

}  // namespace candela::gltf
