#include "core/bvh/tree_cost.h"

namespace prizma {
namespace {

/// Calls `visit` with the box of each child; missing children have empty ones.
template <class Visit>
void forEachChildBox(const WideNode& node, const Visit& visit) {
    const auto& b = node.bounds;
    for (int i = 0; i < 8; ++i)
        visit(DBounds{{b[0][i], b[2][i], b[4][i]}, {b[1][i], b[3][i], b[5][i]}});
}

template <class Visit>
void forEachChildBox(const BinaryNode& node, const Visit& visit) {
    const auto& z = node.boxesZ;
    visit(DBounds{{node.box0xy[0], node.box0xy[2], z[0]}, {node.box0xy[1], node.box0xy[3], z[1]}});
    visit(DBounds{{node.box1xy[0], node.box1xy[2], z[2]}, {node.box1xy[1], node.box1xy[3], z[3]}});
}

template <class Node>
double costOf(const std::vector<Node>& nodes) {
    double sum = 0.0;
    for (const Node& node : nodes)
        forEachChildBox(node, [&sum](const DBounds& box) { sum += box.halfArea(); });
    return sum;
}

} // namespace

double treeCost(const DeviceTree& tree) {
    return tree.layout == TreeLayout::Wide8 ? costOf(tree.wideNodes) : costOf(tree.binaryNodes);
}

} // namespace prizma
