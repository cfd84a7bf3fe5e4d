// Pictures of points on logarithmic axes: cost to the right, error upwards.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace gnomon::measure {

struct Dot {
    double cost = 0;            ///< not finite: it is not drawn
    double error = 0;           ///< 0 in a lane of its own below, what is not finite in one above
    std::size_t style = 0;      ///< which entry of the legend it is of
    bool hollow = false;        ///< dominated
    std::string title;          ///< shown where the pointer rests
    double least = 0, most = 0; ///< of the cost: a bar, if there is one
};

struct Panel {
    std::string title; ///< what goes upwards
    std::string cost;  ///< what goes to the right
    std::vector<Dot> dots;
};

struct Scatter {
    std::string title;
    std::vector<std::string> notes;  ///< lines below the title
    std::vector<std::string> legend; ///< every style's name
    std::vector<Panel> panels;       ///< side by side
};

/// Empty without a panel.
std::string scatter_svg(const Scatter& scatter);

} // namespace gnomon::measure
