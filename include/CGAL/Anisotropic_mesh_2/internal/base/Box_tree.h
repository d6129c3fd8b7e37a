// Copyright (c) 2026 the Anisotropic_mesh_2 developers.
//
// This file is part of Anisotropic_mesh_2.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_BOX_TREE_H
#define CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_BOX_TREE_H

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Anisotropic_mesh_2::internal {

inline Bbox_2 enlarged(const Bbox_2& b, double margin)
{
  return Bbox_2(b.xmin() - margin, b.ymin() - margin, b.xmax() + margin, b.ymax() + margin);
}

// Items with boxes, halved by their centres along the longer side of the box
// around them, until a leaf has few. An item is known by its position in the order of the leaves.
class Box_tree
{
public:
  // The first child of a node follows it; a leaf has no second.
  struct Node
  {
    Bbox_2      box;
    std::size_t begin, end, second_child;

    bool is_leaf() const { return second_child == 0; }
  };

  Box_tree() {}

  Box_tree(const std::vector<Bbox_2>& boxes, std::size_t leaf_size) : m_order(boxes.size())
  {
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    if(!boxes.empty())
      build(boxes, leaf_size, 0, boxes.size());
  }

  const std::vector<Node>& nodes() const { return m_nodes; }

  // the items, as the boxes were given, by their positions
  const std::vector<std::size_t>& order() const { return m_order; }

  // Visits the positions in those leaves whose `distance(node number)` does not exceed the `bound()` of the
  // moment, the nearer child of a node first.
  template <class Distance, class Bound, class Visit>
  void search(const Distance& distance, const Bound& bound, const Visit& visit, std::size_t at = 0) const
  {
    if(m_nodes.empty())
      return;
    const Node& n = m_nodes[at];
    if(n.is_leaf()) {
      for(std::size_t k = n.begin; k < n.end; ++k)
        visit(k);
      return;
    }
    std::pair<double, std::size_t> first(distance(at + 1), at + 1), second(distance(n.second_child), n.second_child);
    if(second < first)
      std::swap(first, second);
    if(first.first <= bound())
      search(distance, bound, visit, first.second);
    if(second.first <= bound())
      search(distance, bound, visit, second.second);
  }

  // Sets `found` to the items, ascending, in leaves whose boxes have a point in common with `box`.
  void find_overlapping(const Bbox_2& box, std::vector<std::size_t>& found) const
  {
    found.clear();
    if(!m_nodes.empty())
      append_overlapping(box, 0, found);
    std::sort(found.begin(), found.end());
  }

private:
  void append_overlapping(const Bbox_2& box, std::size_t at, std::vector<std::size_t>& found) const
  {
    const Node& n = m_nodes[at];
    if(!do_overlap(n.box, box))
      return;
    if(n.is_leaf()) {
      for(std::size_t k = n.begin; k < n.end; ++k)
        found.push_back(m_order[k]);
      return;
    }
    append_overlapping(box, at + 1, found);
    append_overlapping(box, n.second_child, found);
  }

  void build(const std::vector<Bbox_2>& boxes, std::size_t leaf_size, std::size_t begin, std::size_t end)
  {
    Bbox_2 box;
    for(std::size_t k = begin; k < end; ++k)
      box += boxes[m_order[k]];
    const std::size_t at = m_nodes.size(), middle = begin + (end - begin) / 2;
    m_nodes.push_back(Node{box, begin, end, 0});
    if(end - begin <= leaf_size)
      return;
    const int axis = box.xmax() - box.xmin() > box.ymax() - box.ymin() ? 0 : 1;
    const auto position = [this](std::size_t k) { return m_order.begin() + static_cast<std::ptrdiff_t>(k); };
    const auto centre = [&](std::size_t i) { return (boxes[i].min)(axis) + (boxes[i].max)(axis); };
    std::nth_element(position(begin), position(middle), position(end), [&](std::size_t i, std::size_t j) {
      return std::make_pair(centre(i), i) < std::make_pair(centre(j), j);
    });
    build(boxes, leaf_size, begin, middle);
    m_nodes[at].second_child = m_nodes.size();
    build(boxes, leaf_size, middle, end);
  }

  std::vector<Node>        m_nodes;
  std::vector<std::size_t> m_order;
};

} // namespace CGAL::Anisotropic_mesh_2::internal

#endif // CGAL_ANISOTROPIC_MESH_2_INTERNAL_BASE_BOX_TREE_H
