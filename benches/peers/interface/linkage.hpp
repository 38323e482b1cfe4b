/* A linkage as a file of plain text, which `linkage.plain` writes, for peers in C++: vectors by components, matrices row by row.
 *
 *     gravity 3
 *     link parent  place 3  axes 9  axis 3  mass  center 3  tensor 9  torque
 *     loop first second  place 3  place 3  axis 3  axis 3
 *     spring first second  place 3  place 3  stiffness  length
 *
 * Links are numbered from zero, the ground is −1. */
#pragma once
#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace linkage {

using V3 = std::array<double, 3>;
using M3 = std::array<double, 9>;

struct Link {
    int parent;
    V3 place;
    M3 axes;
    V3 axis;
    double mass;
    V3 center;
    M3 tensor;
    double torque;
};

struct Loop {
    int link[2];
    V3 place[2], axis[2];
};

struct Spring {
    int link[2];
    V3 place[2];
    double stiffness, length;
};

struct Linkage {
    V3 gravity{};
    std::vector<Link> links;
    std::vector<Loop> loops;
    std::vector<Spring> springs;
    bool planar = false;
};

template <size_t N> std::istream &operator>>(std::istream &in, std::array<double, N> &values) {
    for (double &value : values)
        in >> value;
    return in;
}

inline bool read(const char *path, Linkage &found) {
    std::ifstream in(path);
    std::string word;
    while (in >> word) {
        if (word == "planar") {
            found.planar = true;
        } else if (word == "gravity") {
            in >> found.gravity;
        } else if (word == "link") {
            Link l;
            in >> l.parent >> l.place >> l.axes >> l.axis >> l.mass >> l.center >> l.tensor >> l.torque;
            found.links.push_back(l);
        } else if (word == "loop") {
            Loop l;
            in >> l.link[0] >> l.link[1] >> l.place[0] >> l.place[1] >> l.axis[0] >> l.axis[1];
            found.loops.push_back(l);
        } else if (word == "spring") {
            Spring s;
            in >> s.link[0] >> s.link[1] >> s.place[0] >> s.place[1] >> s.stiffness >> s.length;
            found.springs.push_back(s);
        } else {
            return false;
        }
        if (!in)
            return false;
    }
    return !found.links.empty();
}

} // namespace linkage
